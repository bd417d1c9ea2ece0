// The innermost loops of the boundary elements. Compiled for several kinds of processors, of
// which the one that runs them is chosen when the program starts.

#include <caudal/ideal/cell_integrals.h>
#include <caudal/ideal/laplace_kernel.h>

#if defined(__GNUC__) && __GNUC__ >= 12 && !defined(__clang__) && defined(__x86_64__) &&           \
    defined(__linux__)
#define CAUDAL_FOR_EACH_PROCESSOR __attribute__((target_clones("default", "arch=x86-64-v3")))
#else
#define CAUDAL_FOR_EACH_PROCESSOR
#endif

namespace caudal::ideal
{
  namespace
  {
    constexpr unsigned int stride  = ReferenceRule::stride;
    constexpr unsigned int n_nodes = Surface::n_nodes_per_cell;

    /** The largest number of points in a rule. */
    constexpr unsigned int n_most = CellRule::n_most_points;

    /** Four numbers at once: where the compiler does not see by itself that it can. */
    typedef double Lanes __attribute__((vector_size(4 * sizeof(double)), aligned(8), may_alias));

    constexpr unsigned int n_lanes = stride / 4;

    inline DEAL_II_ALWAYS_INLINE const Lanes *as_lanes(const double *const values)
    {
      return reinterpret_cast<const Lanes *>(values);
    }

    /** The field with these values at the nodes, or a derivative of it, at the points. */
    inline DEAL_II_ALWAYS_INLINE void interpolate(const ReferenceRule &rule,
                                                  const unsigned int   which,
                                                  const double *const nodal, double *const result)
    {
      const std::size_t   n         = rule.n_points;
      const double *const functions = rule.by_function[which].data();
#pragma GCC ivdep
      for (std::size_t q = 0; q < n; ++q)
      {
        double sum = 0.;
        for (std::size_t k = 0; k < n_nodes; ++k)
          sum += nodal[k] * functions[k * n + q];
        result[q] = sum;
      }
    }
  } // namespace

  CAUDAL_FOR_EACH_PROCESSOR
  void CellRule::place(const ReferenceRule &rule, const std::vector<Point<3>> &positions)
  {
    reference            = &rule;
    const unsigned int n = rule.n_points;
    alignas(64) double X_x[3][n_most], X_y[3][n_most];
    data.resize(6 * n);
    for (unsigned int d = 0; d < 3; ++d)
    {
      double X[n_nodes];
      for (unsigned int k = 0; k < n_nodes; ++k)
        X[k] = positions[k][d];
      interpolate(rule, 0, X, data.data() + d * n);
      interpolate(rule, 1, X, X_x[d]);
      interpolate(rule, 2, X, X_y[d]);
    }
    for (unsigned int d = 0; d < 3; ++d)
    {
      const unsigned int e = (d + 1) % 3, f = (d + 2) % 3;
      double *const      N = data.data() + (3 + d) * n;
#pragma GCC ivdep
      for (unsigned int q = 0; q < n; ++q)
        N[q] = rule.weights[q] * (X_x[e][q] * X_y[f][q] - X_x[f][q] * X_y[e][q]);
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
    alignas(64) double u[n_most];
    data.assign(n_fields * n, 0.);
    interpolate(rule.get_reference(), 0, flow.potential, data.data());
    double *const w = data.data() + n;
    for (unsigned int d = 0; d < 3; ++d)
    {
      interpolate(rule.get_reference(), 0, flow.velocity[d], u);
      const double *const N = rule.get_areas(d);
#pragma GCC ivdep
      for (unsigned int q = 0; q < n; ++q)
        w[q] += u[q] * N[q];
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
#pragma GCC ivdep // all these arrays are apart
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
    const ReferenceRule &reference = rule.get_reference();
    const unsigned int   n         = reference.n_points;
    alignas(64) double   X_x[3][n_most], X_y[3][n_most], by_N[3][n_most];
    const double *const  by_w = data.data() + 8 * n;
    for (unsigned int d = 0; d < 3; ++d)
    {
      alignas(64) double X[n_nodes], u[n_most];
      for (unsigned int k = 0; k < n_nodes; ++k)
        X[k] = positions[k][d];
      interpolate(reference, 1, X, X_x[d]);
      interpolate(reference, 2, X, X_y[d]);
      interpolate(reference, 0, flow.velocity[d], u);
      // N = weight X_x x X_y, and w = u.N
      const double *const by_d = data.data() + (5 + d) * n;
      for (unsigned int q = 0; q < n; ++q)
        by_N[d][q] = reference.weights[q] * (by_d[q] + by_w[q] * u[q]);
    }
    for (unsigned int d = 0; d < 3; ++d)
    {
      const unsigned int  e = (d + 1) % 3, f = (d + 2) % 3;
      const double *const by_X = data.data() + (2 + d) * n, *const N = rule.get_areas(d);
      alignas(64) double by_X_x[n_most], by_X_y[n_most], by_u[n_most];
#pragma GCC ivdep
      for (unsigned int q = 0; q < n; ++q)
      {
        by_X_x[q] = X_y[e][q] * by_N[f][q] - X_y[f][q] * by_N[e][q];
        by_X_y[q] = by_N[e][q] * X_x[f][q] - by_N[f][q] * X_x[e][q];
        by_u[q]   = by_w[q] * N[q];
      }
      Lanes         place[n_lanes] = {}, velocity[n_lanes] = {};
      const double *values = reference.values.data(), *along_x = reference.x_derivatives.data(),
                   *along_y = reference.y_derivatives.data();
      for (unsigned int q = 0; q < n; ++q, values += stride, along_x += stride, along_y += stride)
        for (unsigned int l = 0; l < n_lanes; ++l)
        {
          const Lanes N_k = as_lanes(values)[l];
          place[l] += N_k * by_X[q];
          place[l] += as_lanes(along_x)[l] * by_X_x[q];
          place[l] += as_lanes(along_y)[l] * by_X_y[q];
          velocity[l] += N_k * by_u[q];
        }
      for (unsigned int k = 0; k < stride; ++k)
      {
        gradient.place[d][k] += place[k / 4][k % 4];
        gradient.velocity[d][k] += velocity[k / 4][k % 4];
      }
    }
    std::vector<double>().swap(data);
  }
} // namespace caudal::ideal
