// The innermost loops of the boundary elements. Compiled for several kinds of processors, of
// which the one that runs them is chosen when the program starts.

#include <caudal/potential/cell_integrals.h>
#include <caudal/potential/laplace_kernel.h>

#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__linux__)
#define CAUDAL_FOR_EACH_PROCESSOR __attribute__((target_clones("default", "arch=haswell")))
#else
#define CAUDAL_FOR_EACH_PROCESSOR
#endif

namespace caudal::potential
{
  namespace
  {
    constexpr unsigned int stride = ReferenceRule::stride;

    /** The largest number of points in a rule. */
    constexpr unsigned int n_most = CellRule::n_most_points;
  } // namespace

  CAUDAL_FOR_EACH_PROCESSOR
  void CellRule::place(const ReferenceRule &rule, const std::vector<Point<3>> &positions)
  {
    reference            = &rule;
    const unsigned int n = positions.size(), n_points = rule.n_points;
    data.resize(6 * n_points);
    for (unsigned int q = 0; q < n_points; ++q)
    {
      double                     X[3] = {0., 0., 0.}, X_x[3] = {0., 0., 0.}, X_y[3] = {0., 0., 0.};
      const double *const        values = &rule.values[q * stride],
                          *const by_x   = &rule.x_derivatives[q * stride],
                          *const by_y   = &rule.y_derivatives[q * stride];
      for (unsigned int k = 0; k < n; ++k)
        for (unsigned int d = 0; d < 3; ++d)
        {
          X[d] += values[k] * positions[k][d];
          X_x[d] += by_x[k] * positions[k][d];
          X_y[d] += by_y[k] * positions[k][d];
        }
      for (unsigned int d = 0; d < 3; ++d)
      {
        const unsigned int e = (d + 1) % 3, f = (d + 2) % 3;
        data[d * n_points + q]       = X[d];
        data[(3 + d) * n_points + q] = rule.weights[q] * (X_x[e] * X_y[f] - X_x[f] * X_y[e]);
      }
    }
  }

  CAUDAL_FOR_EACH_PROCESSOR
  void add_moments(const CellRule &rule, const Point<3> &x, CellMoments &moments)
  {
    const unsigned int  n  = rule.get_reference().n_points;
    const double        x0 = x[0], x1 = x[1], x2 = x[2];
    const double *const y0 = rule.get_points(0), *const y1 = rule.get_points(1),
                        *const y2 = rule.get_points(2);
    const double *const N0 = rule.get_areas(0), *const N1 = rule.get_areas(1),
                        *const N2 = rule.get_areas(2);
    alignas(64) double         dipole[n_most], single[3][n_most];
    for (unsigned int q = 0; q < n; ++q)
    {
      const LaplaceKernel kernel =
          evaluate_laplace_kernel(y0[q] - x0, y1[q] - x1, y2[q] - x2, N0[q], N1[q], N2[q]);
      dipole[q]    = kernel.double_layer;
      single[0][q] = kernel.single_layer * N0[q];
      single[1][q] = kernel.single_layer * N1[q];
      single[2][q] = kernel.single_layer * N2[q];
    }
    // Sums of their own, so that no other variable can be the same as one of them.
    CellMoments   sums   = moments;
    const double *values = rule.get_reference().values.data();
    for (unsigned int q = 0; q < n; ++q, values += stride)
      for (unsigned int k = 0; k < stride; ++k)
      {
        sums.dipole[k] += dipole[q] * values[k];
        sums.single[0][k] += single[0][q] * values[k];
        sums.single[1][k] += single[1][q] * values[k];
        sums.single[2][k] += single[2][q] * values[k];
      }
    moments = sums;
  }

  CAUDAL_FOR_EACH_PROCESSOR
  void add_far_moments(const CellRule &rule, const Point<3> &x, const double *fluxes,
                       const unsigned int n_fluxes, double *const dipole, double *const single)
  {
    const unsigned int  n  = rule.get_reference().n_points;
    const double        x0 = x[0], x1 = x[1], x2 = x[2];
    const double *const y0 = rule.get_points(0), *const y1 = rule.get_points(1),
                        *const y2 = rule.get_points(2);
    const double *const N0 = rule.get_areas(0), *const N1 = rule.get_areas(1),
                        *const N2 = rule.get_areas(2);
    alignas(64) double         G[n_most], dG[n_most];
    for (unsigned int q = 0; q < n; ++q)
    {
      const LaplaceKernel kernel =
          evaluate_laplace_kernel(y0[q] - x0, y1[q] - x1, y2[q] - x2, N0[q], N1[q], N2[q]);
      G[q]  = kernel.single_layer;
      dG[q] = kernel.double_layer;
    }
    const double *values = rule.get_reference().values.data();
    for (unsigned int q = 0; q < n; ++q, values += stride, fluxes += n_fluxes)
    {
      for (unsigned int k = 0; k < stride; ++k)
        dipole[k] += dG[q] * values[k];
      for (unsigned int l = 0; l < n_fluxes; ++l)
        single[l] += G[q] * fluxes[l];
    }
  }
} // namespace caudal::potential
