#ifndef caudal_solid_elasticity_h
#define caudal_solid_elasticity_h

#include <caudal/solid/solid_body.h>

#include <map>

namespace caudal
{
  /** What drives a body from inside: fields over the reference configuration. */
  template <int dim>
  struct ActiveLoad
  {
    /** Force density f(s), in the domain's frame [N/m^dim]; may be empty. */
    std::function<Tensor<1, dim>(const Point<dim> &, types::material_id)> force_density;
    /** Active second Piola-Kirchhoff stress S_a(s), P_a = F S_a [Pa]; may be empty. */
    std::function<Tensor<2, dim>(const Point<dim> &, types::material_id)> stress;
  };

  /** Force vectors tested with the body's shape functions, and their tangent. */
  struct ElasticSystem
  {
    /** -int P : grad N ds - sum over the cells of kappa_v V/v ln(v/V) dv/dX */
    Vector<double> elastic_force;
    /** int f.N ds - int F S_a : grad N ds */
    Vector<double> active_force;
    /**
     * K = -d(elastic_force + active_force)/dX, of the volumetric stabilisations what
     * linearised ln J and ln(v/V) give, which is positive semi-definite.
     */
    SparseMatrix<double> stiffness;

    void reinit(const SparsityPattern &pattern);
  };

  /**
   * Assembles @p system at the nodal @p positions; the stiffness only if
   * @p with_stiffness. Throws ExcInvertedElement if det F <= 0 somewhere.
   */
  template <int dim>
  void assemble_elastic_system(const SolidBody<dim> &body, const Vector<double> &positions,
                               const ActiveLoad<dim> &load, bool with_stiffness,
                               ElasticSystem &system);

  /** Integral quantities of a deformed body. */
  struct DeformationSummary
  {
    /** Smallest and largest det F at the quadrature points [1]. */
    double smallest_jacobian, largest_jacobian;
    /** int J ds / int ds - 1 [1] */
    double volume_change;
    /** int W ds + sum over the cells of kappa_v/2 V (ln(v/V))^2 [J/m in 2D] */
    double elastic_energy;
  };

  template <int dim>
  DeformationSummary summarise_deformation(const SolidBody<dim> &body,
                                           const Vector<double> &positions);
  /** Cell means for pictures: J, the elastic Cauchy stress [Pa] by component, P F^T / J and
   * the pressure of the cells' volume stabilisation, and the region.
   */
  struct CellDeformation
  {
    Vector<float>                        jacobian, region;
    std::map<std::string, Vector<float>> cauchy_stress;
  };

  template <int dim>
  CellDeformation compute_cell_deformation(const SolidBody<dim> &body,
                                           const Vector<double> &positions);
} // namespace caudal

#endif
