// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_solid_elastic_body_h
#define caudal_solid_elastic_body_h

#include <caudal/base/outcome.h>
#include <caudal/io/log.h>
#include <caudal/io/output_folder.h>
#include <caudal/io/statistics.h>
#include <caudal/solid/elastic_parameters.h>
#include <caudal/solid/load.h>

namespace caudal
{
  /**
   * A hyperelastic body alone, without fluid, under its weight:
   *   rho X'' = div P + rho g,
   * its fixed regions held. Time by the average acceleration (Newmark 1959,
   * beta = 1/4, gamma = 1/2), which keeps the energy of linear vibrations; or the
   * equilibrium, with a load that grows step by step. It verifies what the
   * immersed bodies are made of.
   */
  template <int dim>
  class ElasticBody
  {
  public:
    using Parameters = ElasticParameters<dim>;

    ElasticBody(const ElasticParameters<dim> &parameters, MPI_Comm communicator);

    /** Starts from rest, with the acceleration of the weight. */
    void start();

    /** Prints what the case is like. */
    void check(std::ostream &out, bool fast) const;

    /** Parameter values are not kept: there are no checkpoints. */
    void set_parameter_values(const ParameterValues &) {}

    Outcome run(const OutputFolder &folder, Log &log, const std::function<bool()> &stop_requested);

  private:
    const ElasticParameters<dim> &parameters;
    SolidBody<dim>                solid;
    std::unique_ptr<Load<dim>>    elasticity;
    BodyResponse                  response;
    Vector<double>                weight, positions, velocity, acceleration;
    SparseMatrix<double>          matrix;

    void print_summary(std::ostream &out) const;
    /** Solves a step of length @p step [s], or for the equilibrium under @p load of the weight. */
    unsigned int   solve(double step, double load);
    Vector<double> compute_residual(double inertia, double load, const Vector<double> &predicted);
    void           apply_newton_update(double inertia, Vector<double> &residual);
    void write_statistics(double time, unsigned int iterations, Statistics &statistics) const;
  };
} // namespace caudal

#endif
