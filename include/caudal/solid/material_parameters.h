// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_solid_material_parameters_h
#define caudal_solid_material_parameters_h

#include <caudal/solid/material.h>

namespace caudal
{
  /** The elastic material of a region of a body: a Material, and what is laid over it. */
  template <int dim>
  struct MaterialParameters
  {
    Choice<Material<dim>> material{"Material", "neo-Hookean", "The hyperelastic material:"};
    ElasticModuli         moduli;
    std::string           thin_direction           = "none";
    double                volumetric_stabilisation = 0.;

    /** Declares the entries in the section that @p prm is in. */
    void add_parameters(ParameterHandler &prm);

    /** Throws a sentence about the first bad entry; @p path is the section's. */
    void check(const std::string &path) const;

    /** The material with its thin direction and its stabilisation. */
    std::unique_ptr<Material<dim>> create(const std::string &path) const;

    /** Material::get_wave_modulus(), with the stabilisation. */
    double get_wave_modulus(const std::string &path) const;

  private:
    std::unique_ptr<Material<dim>> create_bare(const std::string &path) const;
  };
} // namespace caudal

#endif
