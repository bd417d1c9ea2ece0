#ifndef caudal_coupling_kernel_h
#define caudal_coupling_kernel_h

#include <deal.II/base/exceptions.h>

#include <memory>
#include <string>

namespace caudal
{
  using namespace dealii;

  /**
   * A regularised delta function of one variable: phi(r) with r = (x - X)/h,
   * even, of integral one over r, zero for |r| >= radius(). The
   * d-dimensional one is the product h^-d phi((x-X)/h) phi((y-Y)/h) ....
   */
  class DeltaKernel
  {
  public:
    virtual ~DeltaKernel() = default;

    /** phi(r) [-] */
    virtual double value(const double r) const = 0;

    /**
     * Half the width of the support, in lattice spacings h: a multiple of 1/2. The
     * kernel is smooth but for knots at -radius(), -radius() + 1, ..., radius().
     */
    virtual double radius() const = 0;

    /**
     * Gauss points that integrate the product with a quadratic function to
     * round-off within each interval [k - radius(), k + 1 - radius()], between the
     * knots, where the kernel is smooth.
     */
    virtual unsigned int n_quadrature_points() const = 0;
  };

  /**
   * The kernel of the coupling: the one-dimensional factors for a component of
   * the velocity, along that component's direction and across it.
   *
   * They differ for composite B-splines only: B_(k+1) along, B_k across. Since
   * B_(k+1)'(r) = B_k(r + 1/2) - B_k(r - 1/2), a field whose component i is
   * sampled on a lattice shifted by h/2 in direction i (staggered, MAC) and is
   * discretely divergence free there is interpolated to one that is divergence
   * free at every point (Gruninger and Griffith, J. Comput. Phys. 546, 2025,
   * doi:10.1016/j.jcp.2025.114472). With finite elements they
   * have no such property: the convolution of a divergence-free field is so if the
   * kernel is the same for all components.
   *
   * `dirac` is the variational limit, delta itself: no kernel, and the finite
   * element field is evaluated at the body's points.
   */
  struct KernelPair
  {
    std::unique_ptr<DeltaKernel> along;
    std::unique_ptr<DeltaKernel> across;

    bool isotropic = true;
    bool is_dirac  = false;

    /** The factor in @p direction for @p component of the velocity. */
    const DeltaKernel &get(const unsigned int component, const unsigned int direction) const
    {
      Assert(!is_dirac, ExcInternalError());
      return component == direction ? *along : *across;
    }

    /** Half the width of the support in any direction [h]; 0 for `dirac`. */
    double radius() const;
  };

  /**
   * The kernel of that name.
   *
   * `four-point`: Peskin, Acta Numerica 11, 2002, doi:10.1017/S0962492902000077.
   * `cosine`: (1 + cos(pi r/2))/4, Peskin's earlier one.
   * `three-point`: Roma, Peskin and Berger, J. Comput. Phys. 153, 1999,
   *   doi:10.1006/jcph.1999.6293.
   * `hat`: piecewise linear, the B-spline of order 2.
   * `B-spline k`: the cardinal B-spline of order k (degree k-1, k points).
   * `composite B-spline 32`: order 3 along, order 2 across; `43`, `54` alike.
   * `dirac`: see KernelPair.
   */
  KernelPair create_kernel(const std::string &name);

  /** All names, separated by '|' as Patterns::Selection wants them. */
  std::string get_kernel_names();
} // namespace caudal

#endif
