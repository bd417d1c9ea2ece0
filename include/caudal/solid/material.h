// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_solid_material_h
#define caudal_solid_material_h

#include <caudal/base/plugin.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

namespace caudal
{
  DeclException1(ExcInvertedElement, double,
                 << "The deformation gradient has the determinant " << arg1
                 << ", and the energy of this material is defined for positive ones only: an "
                    "element of the body has been inverted. Take a smaller step, a finer body "
                    "or a larger volumetric stabilisation.");

  /** The entries of a region from which isotropic materials take their moduli. */
  struct ElasticModuli
  {
    double youngs_modulus = 2.4e6;
    double shear_modulus  = 0.;
    double poisson_ratio  = 0.4;

    /** Declares the entries in the section that @p prm is in. */
    void add_parameters(ParameterHandler &prm);

    /** mu [Pa]: as given, otherwise E/(2 (1 + nu)). Throws if it is not positive; @p path is the
     * section's. */
    double compute_shear_modulus(double poisson_ratio, const std::string &path) const;
  };

  /**
   * A hyperelastic material: the energy W(F, s) [J/m^3 of reference volume] of the deformation
   * gradient F_iJ = dX_i/ds_J, and its derivatives. It may depend on the point s of the body in
   * the reference configuration, in the body's own frame [m]. In two dimensions F is the in-plane
   * part of a plane strain.
   *
   * It is the elastic part of the stress only: pressure and viscous stress inside the body are
   * those of the fluid, which fills the body too.
   */
  template <int dim>
  class Material : public Plugin
  {
  public:
    /**
     * Takes what it needs of the region's moduli and throws a sentence about one that does not
     * suit it; @p path is the region's section. To be called before the functions below.
     */
    virtual void set_up(const ElasticModuli & /*moduli*/, const std::string & /*path*/) {}

    /** W(F, s) [J/m^3], zero in the reference configuration. */
    virtual double strain_energy(const Tensor<2, dim> &F, const Point<dim> &s) const = 0;

    /** First Piola-Kirchhoff stress P_iJ = dW/dF_iJ [Pa]. */
    virtual Tensor<2, dim> first_piola_kirchhoff_stress(const Tensor<2, dim> &F,
                                                        const Point<dim>     &s) const = 0;

    /**
     * dP_iJ/dF_kL [Pa], indices in this order; of a volumetric stabilisation without
     * -kappa ln(J) F^-T_kJ F^-T_iL.
     */
    virtual Tensor<4, dim> tangent(const Tensor<2, dim> &F, const Point<dim> &s) const = 0;

    /** Whether the volume is kept by the fluid's pressure and not by the material. */
    virtual bool leaves_volume_to_pressure() const
    {
      return false;
    }

    /**
     * A sentence on how the material differs within a fluid, whose pressure keeps its volume, from
     * itself elsewhere; empty if it does not.
     */
    virtual std::string get_immersed_remark() const
    {
      return "";
    }

    /**
     * Stress per strain of the fastest elastic wave in the undeformed body [Pa], to estimate steps:
     * here dP_xx/dF_xx at the origin of the body's frame.
     */
    virtual double get_wave_modulus() const;
  };
} // namespace caudal

#endif
