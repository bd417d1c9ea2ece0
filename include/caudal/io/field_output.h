// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_io_field_output_h
#define caudal_io_field_output_h

#include <caudal/io/output_folder.h>

#include <deal.II/base/data_out_base.h>
#include <deal.II/base/parameter_handler.h>

#include <map>
#include <string>

namespace caudal
{
  /** Section `Output` of the .prm. */
  struct OutputParameters
  {
    std::string  folder              = "output";
    std::string  existing_results    = "number";
    double       field_interval      = 0.02;
    unsigned int statistics_interval = 1;
    std::string  format              = "vtu"; // or "hdf5"
    unsigned int n_subdivisions      = 2;

    void add_parameters(dealii::ParameterHandler &prm);
    /** Those about the folder alone, for models without fields. */
    void add_folder_parameters(dealii::ParameterHandler &prm);
    void check() const;

    ExistingResults get_existing_results() const;
  };

  /**
   * Writes fields of a run so that ParaView opens all of them as one
   * series in time: a list, solution.pvd (or solution.xdmf for HDF5) with one block for the
   * fluid and one for each body, and the data themselves in fields/. What has times of its own,
   * such as slices, has a list of its own. The list
   * is replaced at every write, after the data it points to are complete. The list is part of the
   * run's state: that of a resumed run has what its checkpoint knew.
   */
  class FieldOutput
  {
  public:
    /** At one time: the entries of the list by the names of their blocks. */
    using Entries = std::map<std::string, std::string>;

    /** All entries by time as it is listed [s]. */
    using Series = std::map<double, Entries>;

    /**
     * Goes on with the @p series of a checkpoint; the @p format is that of OutputParameters,
     * @p list the name of the list without its ending. Collective.
     */
    FieldOutput(const OutputFolder &folder, const std::string &format, MPI_Comm communicator,
                const Series &series = {}, const std::string &list = "solution");

    /** On rank 0; empty on the others. */
    const Series &get_series() const
    {
      return series;
    }

    /** Sentences about the files of the list that are not there any more. Collective. */
    std::vector<std::string> find_missing_files() const;

    /**
     * Writes one field: @p name is its block's name ("fluid", "fish"), @p time is in s
     * and @p counter numbers the files. @p field_communicator is that of the field's
     * triangulation: MPI_COMM_SELF for a body that is replicated on all ranks, of
     * which rank 0 alone writes its copy. Collective.
     */
    template <int dim, int spacedim>
    void write(dealii::DataOutInterface<dim, spacedim> &data_out, const std::string &name,
               double time, unsigned int counter, MPI_Comm field_communicator);

  private:
    void        write_list() const;
    std::string get_list_name() const;

    const OutputFolder &folder;
    const bool          is_vtu; // one compressed .vtu per field and time; else one .h5
    const MPI_Comm      communicator;
    const std::string   list;
    Series              series;
  };
} // namespace caudal

#endif
