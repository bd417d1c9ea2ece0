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

  CAUDAL_FOR_EACH_PROCESSOR
  void PointGradients::begin(const CellRule &rule, const CellFlow &flow)
  {
    const unsigned int n = rule.get_reference().n_points;
    data.assign(n_fields * n, 0.);
    const double *values = rule.get_reference().values.data();
    for (unsigned int q = 0; q < n; ++q, values += stride)
    {
      double phi = 0., u[3] = {0., 0., 0.};
      for (unsigned int k = 0; k < stride; ++k)
      {
        phi += values[k] * flow.potential[k];
        u[0] += values[k] * flow.velocity[0][k];
        u[1] += values[k] * flow.velocity[1][k];
        u[2] += values[k] * flow.velocity[2][k];
      }
      data[q] = phi;
      data[n + q] =
          u[0] * rule.get_areas(0)[q] + u[1] * rule.get_areas(1)[q] + u[2] * rule.get_areas(2)[q];
    }
  }

  CAUDAL_FOR_EACH_PROCESSOR
  void PointGradients::add(const CellRule &rule, const Point<3> &x, const double lambda,
                           const double phi_x, Tensor<1, 3> &by_x)
  {
    const unsigned int  n  = rule.get_reference().n_points;
    const double        x0 = x[0], x1 = x[1], x2 = x[2];
    const double *const y0 = rule.get_points(0), *const y1 = rule.get_points(1),
                        *const y2 = rule.get_points(2);
    const double *const N0 = rule.get_areas(0), *const N1 = rule.get_areas(1),
                        *const N2 = rule.get_areas(2);
    double *const phi = data.data(), *const w = phi + n;
    double *const by_y0 = phi + 2 * n, *const by_y1 = phi + 3 * n, *const by_y2 = phi + 4 * n;
    double *const by_N0 = phi + 5 * n, *const by_N1 = phi + 6 * n, *const by_N2 = phi + 7 * n;
    double *const by_w = phi + 8 * n;
    double        sum0 = 0., sum1 = 0., sum2 = 0.;
    for (unsigned int q = 0; q < n; ++q)
    {
      const double        r0 = y0[q] - x0, r1 = y1[q] - x1, r2 = y2[q] - x2;
      const LaplaceKernel kernel  = evaluate_laplace_kernel(r0, r1, r2, N0[q], N1[q], N2[q]);
      const double        G       = kernel.single_layer;
      const double        inverse = 1. / (r0 * r0 + r1 * r1 + r2 * r2);
      const double        jump    = lambda * (phi[q] - phi_x);
      const double        along_N = jump * G * inverse;
      const double        along_r = inverse * (3. * jump * kernel.double_layer - lambda * w[q] * G);
      const double        d0 = along_N * N0[q] + along_r * r0, d1 = along_N * N1[q] + along_r * r1,
                   d2 = along_N * N2[q] + along_r * r2;
      by_y0[q] += d0;
      by_y1[q] += d1;
      by_y2[q] += d2;
      by_N0[q] += along_N * r0;
      by_N1[q] += along_N * r1;
      by_N2[q] += along_N * r2;
      by_w[q] += lambda * G;
      sum0 += d0;
      sum1 += d1;
      sum2 += d2;
    }
    by_x -= Point<3>(sum0, sum1, sum2);
  }

  void PointGradients::add_energy(const CellRule &rule, const double factor)
  {
    const unsigned int n = rule.get_reference().n_points;
    for (unsigned int q = 0; q < n; ++q)
      data[8 * n + q] += factor * data[q];
  }

  CAUDAL_FOR_EACH_PROCESSOR
  void PointGradients::end(const CellRule &rule, const std::vector<Point<3>> &positions,
                           const CellFlow &flow, CellGradient &gradient)
  {
    const ReferenceRule &reference    = rule.get_reference();
    const unsigned int   n            = reference.n_points;
    alignas(64) double   X[3][stride] = {};
    for (unsigned int k = 0; k < positions.size(); ++k)
      for (unsigned int d = 0; d < 3; ++d)
        X[d][k] = positions[k][d];
    CellGradient sums = gradient;
    for (unsigned int q = 0; q < n; ++q)
    {
      const double *const        values = &reference.values[q * stride],
                          *const by_x   = &reference.x_derivatives[q * stride],
                          *const by_y   = &reference.y_derivatives[q * stride];
      double                     X_x[3] = {0., 0., 0.}, X_y[3] = {0., 0., 0.}, u[3] = {0., 0., 0.};
      for (unsigned int d = 0; d < 3; ++d)
        for (unsigned int k = 0; k < stride; ++k)
        {
          X_x[d] += by_x[k] * X[d][k];
          X_y[d] += by_y[k] * X[d][k];
          u[d] += values[k] * flow.velocity[d][k];
        }
      // N = weight X_x x X_y, and w = u.N
      const double weight = reference.weights[q], by_w = data[8 * n + q];
      double       by_N[3];
      for (unsigned int d = 0; d < 3; ++d)
        by_N[d] = weight * (data[(5 + d) * n + q] + by_w * u[d]);
      for (unsigned int d = 0; d < 3; ++d)
      {
        const unsigned int e = (d + 1) % 3, f = (d + 2) % 3;
        const double       by_X_x = X_y[e] * by_N[f] - X_y[f] * by_N[e];
        const double       by_X_y = by_N[e] * X_x[f] - by_N[f] * X_x[e];
        const double       by_X = data[(2 + d) * n + q], by_u = by_w * rule.get_areas(d)[q];
        for (unsigned int k = 0; k < stride; ++k)
        {
          sums.place[d][k] += values[k] * by_X + by_x[k] * by_X_x + by_y[k] * by_X_y;
          sums.velocity[d][k] += values[k] * by_u;
        }
      }
    }
    gradient = sums;
    data.clear();
  }
} // namespace caudal::potential
