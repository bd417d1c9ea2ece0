// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_solid_elastic_parameters_h
#define caudal_solid_elastic_parameters_h

#include <caudal/base/parameter_file.h>
#include <caudal/io/field_output.h>
#include <caudal/solid/solid_parameters.h>

namespace caudal
{
  /** All parameters of a run of an elastic body without fluid. */
  template <int dim>
  struct ElasticParameters
  {
    std::string    model     = "elastic";
    unsigned int   dimension = dim;
    std::string    body_name;
    bool           is_static = false;
    double         end_time  = 1;
    double         step      = 0.01;
    Tensor<1, dim> gravity;

    std::unique_ptr<SolidParameters<dim>> solid;
    OutputParameters                      output;

    /** The one body that @p file names and its regions decide what sections there are. */
    explicit ElasticParameters(const ParameterFile *file);

    /** Entries that had other names in earlier versions. */
    static std::vector<RenamedEntry> get_renamed_entries()
    {
      return BodyGridParameters<dim>::get_renamed_entries();
    }

    void declare(ParameterHandler &prm);
    void check() const;
  };
} // namespace caudal

#endif
