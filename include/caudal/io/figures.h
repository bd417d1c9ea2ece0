// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_io_figures_h
#define caudal_io_figures_h

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>

#include <string>

namespace caudal
{
  /** Subsection `Output/Figures`: what a run prints of its results in the end. */
  struct FigureParameters
  {
    std::string  print; // expressions, separated by ';'
    bool         with_warnings = false;
    double       start         = 0.; // rows before this time don't count [s]
    unsigned int n_decimals    = 6;

    void add_parameters(dealii::ParameterHandler &prm);
    void check() const;

    /** Whether there are any. Then the terminal shows nothing else but, on request, warnings. */
    bool are_printed() const;
  };

  /**
   * The figures of a run, a line "expression = value" each, from the tables in its folder
   * (statistics*.txt and, in an ideal fluid, summary.csv). They depend on neither time of day,
   * machine, nor version, so that what a run prints can be compared with what it has printed
   * before: a regression test.
   *
   * In an expression [name] is a column (without its unit), t the time. Functions make one number
   * of a column or of an expression of up to three of them, row by row: first, last, smallest,
   * largest, mean, amplitude (half of the range), and frequency (of upward passages through the
   * middle of the range, 1/s). Example: 1e3*largest(abs([u at probe 1] - [u at probe 2])).
   * Collective.
   */
  void print_figures(const FigureParameters &parameters, const std::string &folder,
                     MPI_Comm communicator);
} // namespace caudal

#endif
