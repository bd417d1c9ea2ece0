// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/solid/rigid_motion.h>

#include <deal.II/base/symmetric_tensor.h>

namespace caudal
{
  namespace
  {
    /** The mean of a nodal field over @p nodes, weighted by their volumes. */
    template <int dim>
    Tensor<1, dim> compute_mean(const SolidBody<dim> &body, const Nodes<dim> &nodes,
                                const Vector<double> &field)
    {
      Tensor<1, dim> mean;
      double         volume = 0;
      for (const auto &node : nodes)
      {
        volume += body.get_nodal_volumes()[node[0]];
        mean += body.get_nodal_volumes()[node[0]] * get_value(field, node);
      }
      return mean / volume;
    }

    /** The sum of (v - v_mean) (x - x_mean)^T over @p nodes, weighted by their volumes. */
    template <int dim>
    Tensor<2, dim> correlate(const SolidBody<dim> &body, const Nodes<dim> &nodes,
                             const Vector<double> &v, const Tensor<1, dim> &v_mean,
                             const Vector<double> &x, const Tensor<1, dim> &x_mean)
    {
      Tensor<2, dim> correlation;
      for (const auto &node : nodes)
        correlation += body.get_nodal_volumes()[node[0]] *
                       outer_product(get_value(v, node) - v_mean, get_value(x, node) - x_mean);
      return correlation;
    }
  } // namespace

  template <int dim>
  RigidMotion<dim> fit_rigid_motion(const SolidBody<dim> &body, const Nodes<dim> &nodes,
                                    const Vector<double> &reference, const Vector<double> &x)
  {
    RigidMotion<dim> fit;
    fit.reference_center = compute_mean(body, nodes, reference);
    fit.center           = compute_mean(body, nodes, x);
    fit.rotation         = project_onto_orthogonal_tensors(
                correlate(body, nodes, x, fit.center, reference, fit.reference_center));
    return fit;
  }

  template <int dim>
  RigidVelocity<dim> fit_rigid_velocity(const SolidBody<dim> &body, const Nodes<dim> &nodes,
                                        const Vector<double> &x, const Vector<double> &v)
  {
    RigidVelocity<dim> fit;
    fit.center = compute_mean(body, nodes, x);
    fit.mean   = compute_mean(body, nodes, v);
    // The spin W minimises the sum of |v - W x|^2: W A + A W = B - B^T.
    const Tensor<2, dim> A    = correlate(body, nodes, x, fit.center, x, fit.center);
    const Tensor<2, dim> B    = correlate(body, nodes, v, fit.mean, x, fit.center);
    const Tensor<2, dim> rate = B - transpose(B);
    if constexpr (dim == 2)
      fit.spin = rate / trace(A);
    else
    {
      const Tensor<1, dim> axis = invert(trace(A) * unit_symmetric_tensor<dim>() - A) *
                                  Tensor<1, dim>({rate[2][1], rate[0][2], rate[1][0]});
      for (unsigned int d = 0; d < dim; ++d)
      {
        fit.spin[(d + 2) % dim][(d + 1) % dim] = axis[d];
        fit.spin[(d + 1) % dim][(d + 2) % dim] = -axis[d];
      }
    }
    return fit;
  }

  template <int dim>
  std::vector<Vector<double>> make_rigid_velocities(const SolidBody<dim> &body,
                                                    const Vector<double> &x)
  {
    const Tensor<1, dim>        center = body.compute_mean(x);
    std::vector<Vector<double>> modes(dim * (dim + 1) / 2, Vector<double>(body.n_dofs()));
    for (const auto &node : body.get_nodes())
    {
      for (unsigned int d = 0; d < dim; ++d)
        modes[d][node[d]] = 1;
      for (unsigned int k = 0; dim + k < modes.size(); ++k)
      {
        const unsigned int i = dim == 2 ? 0 : (k + 1) % dim, j = dim == 2 ? 1 : (k + 2) % dim;
        modes[dim + k][node[i]] = -(x[node[j]] - center[j]);
        modes[dim + k][node[j]] = x[node[i]] - center[i];
      }
    }
    return modes;
  }

#define INSTANTIATE(dim)                                                                           \
  template RigidMotion<dim>   fit_rigid_motion(const SolidBody<dim> &, const Nodes<dim> &,         \
                                               const Vector<double> &, const Vector<double> &);    \
  template RigidVelocity<dim> fit_rigid_velocity(const SolidBody<dim> &, const Nodes<dim> &,       \
                                                 const Vector<double> &, const Vector<double> &);  \
  template std::vector<Vector<double>> make_rigid_velocities(const SolidBody<dim> &,               \
                                                             const Vector<double> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace caudal
