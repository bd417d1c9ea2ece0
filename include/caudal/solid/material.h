#ifndef caudal_solid_stress_h
#define caudal_solid_stress_h

#include <deal.II/base/exceptions.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/tensor.h>

#include <memory>
#include <string>

namespace caudal
{
  using namespace dealii;

  DeclException1(ExcInvertedElement, double,
                 << "The deformation gradient has the determinant " << arg1
                 << ", and the energy of this material is defined for positive ones only: an "
                    "element of the body has been inverted. Take a smaller step, a finer body "
                    "or a larger volumetric stabilisation.");

  /**
   * A hyperelastic material: the energy W(F) [J/m^3 of reference volume] of the
   * deformation gradient F_iJ = dX_i/ds_J, and its derivatives. In two
   * dimensions F is the in-plane part of a plane strain.
   *
   * This is the elastic part of the stress only: pressure and viscous stress
   * inside the body are those of the fluid, which fills the body too.
   */
  template <int dim>
  class StressModel
  {
  public:
    virtual ~StressModel() = default;

    /** W(F) [J/m^3], zero in the reference configuration. */
    virtual double strain_energy(const Tensor<2, dim> &F) const = 0;

    /** First Piola-Kirchhoff stress P_iJ = dW/dF_iJ [Pa]. */
    virtual Tensor<2, dim> first_piola_kirchhoff_stress(const Tensor<2, dim> &F) const = 0;

    /**
     * dP_iJ/dF_kL [Pa], indices in this order; of a volumetric stabilisation without
     * -kappa ln(J) F^-T_kJ F^-T_iL.
     */
    virtual Tensor<4, dim> tangent(const Tensor<2, dim> &F) const = 0;
  };

  /**
   * The elastic material of one region of a body.
   *
   * `neo-Hookean`, incompressible: W = mu/2 (tr C - dim) - mu ln J,
   *   P = mu (F - F^-T), C = F^T F. The fluid's pressure keeps J = 1.
   * `modified neo-Hookean`, of the isochoric part of F:
   *   W = mu/2 (J^(-2/dim) tr C - dim), P = mu J^(-2/dim) (F - tr C/dim F^-T).
   * `St. Venant-Kirchhoff`: P = F S, S = lambda tr(E) I + 2 mu E, E = (C - I)/2.
   * `none`: no elastic stress.
   *
   * With a `thin direction` N, W is taken where F has been stretched along the normal
   * of the deformed faces to J = 1, so that there is no stress across them. Where J = 1
   * this changes the material's stress by a pressure, which the fluid's makes up for,
   * and the motion not at all. But the pressure of the fluid then does not jump at the
   * faces by the stress of the bent body, which its elements can't follow inside of a
   * cell and which would load the body with what they miss of it.
   *
   * Each takes the volumetric stabilisation W += kappa/2 (ln J)^2,
   * P += kappa ln(J) F^-T, which penalises the volume errors that interpolation
   * of the velocity leaves in the body (Vadala-Roth et al., Comput. Methods
   * Appl. Mech. Engrg. 365, 2020, doi:10.1016/j.cma.2020.112978).
   */
  struct MaterialParameters
  {
    std::string material                 = "neo-Hookean";
    double      youngs_modulus           = 2.4e6;
    double      shear_modulus            = 0.;
    double      poisson_ratio            = 0.4;
    std::string thin_direction           = "none";
    double      volumetric_stabilisation = 0.;

    /** Declares the entries in the section that @p prm is in. */
    void add_parameters(ParameterHandler &prm);

    /** Throws a sentence about the first bad entry; @p path is the section's. */
    void check(const std::string &path) const;

    /** mu [Pa]: as given, otherwise from E, with nu = 1/2 if incompressible. */
    double get_shear_modulus() const;

    /** lambda = 2 mu nu/(1 - 2 nu) [Pa], of the St. Venant-Kirchhoff material. */
    double get_lame_modulus() const;
  };

  /** The material that @p parameters describe. */
  template <int dim>
  std::unique_ptr<StressModel<dim>> create_stress_model(const MaterialParameters &parameters);
} // namespace caudal

#endif
