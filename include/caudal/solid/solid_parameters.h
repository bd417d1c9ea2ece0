// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_solid_solid_parameters_h
#define caudal_solid_solid_parameters_h

#include <caudal/mesh/body_grid.h>
#include <caudal/solid/material.h>
#include <caudal/solid/prescribed_place.h>

#include <memory>

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

    /** Material::get_immersed_remark() */
    std::string get_immersed_remark(const std::string &path) const
    {
      return create_bare(path)->get_immersed_remark();
    }

    /** Material::get_wave_modulus(), with the stabilisation. */
    double get_wave_modulus(const std::string &path) const;

  private:
    std::unique_ptr<Material<dim>> create_bare(const std::string &path) const;
  };

  /** Section `Body <name>/Region <name>`: material of a part of the body, and what holds it. */
  template <int dim>
  struct RegionParameters
  {
    MaterialParameters<dim> material;
    std::string             cell_volume_stabilisation = "automatic";
    double                  feedback_stiffness        = 0;
    double                  feedback_damping          = 0;
    std::string             feedback_directions       = "xyz";
    std::string             motion                    = "free";

    PrescribedPlaceParameters<dim> place;

    /** Whether its points are where they are prescribed to be. */
    bool is_fixed() const
    {
      return motion != "free";
    }

    /** How strictly it rules the places of its points, to be compared with other regions. */
    unsigned int get_hold() const
    {
      return motion == "prescribed" ? 3 : motion == "fixed" ? 2 : place.moves() ? 1 : 0;
    }

    void add_parameters(ParameterHandler &prm);
    void check(const std::string &path) const;
  };

  /** The mechanical part of a section `Body <name>`. */
  template <int dim>
  struct SolidParameters
  {
    const std::string              name;
    const std::vector<std::string> regions;

    unsigned int            polynomial_degree = 1;
    std::string             surface_weight    = "automatic";
    double                  density           = 0;
    std::vector<Point<dim>> monitored_points;
    std::string             traction; // of SurfaceLoad
    std::string             surface_spring, surface_damper;

    BodyGridParameters<dim>                             grid;
    std::vector<std::unique_ptr<RegionParameters<dim>>> region_parameters;

    /** The names decide which subsections there are. */
    SolidParameters(const std::string &name, const std::vector<std::string> &regions);

    /** Declares the entries in the section of the body, which @p prm is in. */
    void add_parameters(ParameterHandler &prm);
    void check() const;

    /**
     * The edge of automatic elements in a fluid with cells of this edge [m]: with smaller ones the
     * body has more motions than the fluid and acts as if it were thicker.
     */
    double get_element_size(double fluid_cell) const;

    /** beta, the weight of the surface in the coupling to the fluid: see get_coupling_mass(). */
    double get_surface_weight() const;

    /** kappa_v, the modulus of the energy of the cells' volumes in a region [Pa]. */
    double get_cell_volume_stabilisation(unsigned int region) const;

    std::string get_path() const
    {
      return "Body " + name;
    }
    std::string get_region_path(const unsigned int region) const
    {
      return get_path() + "/Region " + regions[region];
    }
  };
} // namespace caudal

#endif
