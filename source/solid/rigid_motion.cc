// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/solid/rigid_motion.h>

#include <deal.II/lac/full_matrix.h>

namespace caudal
{
  namespace
  {
    /** Pairs (i, j), i < j, of the planes of rotation. */
    template <int dim>
    std::vector<std::pair<unsigned int, unsigned int>> get_planes()
    {
      if constexpr (dim == 2)
        return {{0, 1}};
      else
        return {{1, 2}, {2, 0}, {0, 1}};
    }
  } // namespace

  template <int dim>
  RigidMotion<dim> fit_rigid_motion(const SolidBody<dim>                             &body,
                                    const std::vector<typename SolidBody<dim>::Node> &nodes,
                                    const Vector<double> &reference, const Vector<double> &x)
  {
    RigidMotion<dim> fit;
    double           volume = 0;
    for (const auto &node : nodes)
    {
      const double weight = body.get_nodal_volumes()[node[0]];
      volume += weight;
      fit.reference_center += weight * get_value(reference, node);
      fit.center += weight * get_value(x, node);
    }
    fit.reference_center /= volume;
    fit.center /= volume;
    Tensor<2, dim> correlation;
    for (const auto &node : nodes)
      correlation += body.get_nodal_volumes()[node[0]] *
                     outer_product(get_value(x, node) - fit.center,
                                   get_value(reference, node) - fit.reference_center);
    fit.rotation = project_onto_orthogonal_tensors(correlation);
    return fit;
  }

  template <int dim>
  RigidVelocity<dim> fit_rigid_velocity(const SolidBody<dim>                             &body,
                                        const std::vector<typename SolidBody<dim>::Node> &nodes,
                                        const Vector<double> &x, const Vector<double> &v)
  {
    RigidVelocity<dim> fit;
    double             volume = 0;
    for (const auto &node : nodes)
    {
      const double weight = body.get_nodal_volumes()[node[0]];
      volume += weight;
      fit.center += weight * get_value(x, node);
      fit.mean += weight * get_value(v, node);
    }
    fit.center /= volume;
    fit.mean /= volume;

    // Normal equations for the rates of rotation in each plane.
    const auto         planes = get_planes<dim>();
    FullMatrix<double> inertia(planes.size(), planes.size());
    Vector<double>     momentum(planes.size()), rates(planes.size());
    for (const auto &node : nodes)
    {
      const double                weight = body.get_nodal_volumes()[node[0]];
      const Tensor<1, dim>        arm    = get_value(x, node) - fit.center;
      std::vector<Tensor<1, dim>> turns(planes.size());
      for (unsigned int k = 0; k < planes.size(); ++k)
      {
        turns[k][planes[k].first]  = -arm[planes[k].second];
        turns[k][planes[k].second] = arm[planes[k].first];
      }
      for (unsigned int k = 0; k < planes.size(); ++k)
      {
        momentum[k] += weight * (turns[k] * (get_value(v, node) - fit.mean));
        for (unsigned int l = 0; l < planes.size(); ++l)
          inertia(k, l) += weight * (turns[k] * turns[l]);
      }
    }
    inertia.gauss_jordan();
    inertia.vmult(rates, momentum);
    for (unsigned int k = 0; k < planes.size(); ++k)
    {
      fit.spin[planes[k].first][planes[k].second] = -rates[k];
      fit.spin[planes[k].second][planes[k].first] = rates[k];
    }
    return fit;
  }

  template <int dim>
  std::vector<Vector<double>> make_rigid_velocities(const SolidBody<dim> &body,
                                                    const Vector<double> &x)
  {
    const Tensor<1, dim>        center = body.compute_mean(x);
    const auto                  planes = get_planes<dim>();
    std::vector<Vector<double>> modes(dim + planes.size(), Vector<double>(body.n_dofs()));
    for (const auto &node : body.get_nodes())
    {
      for (unsigned int d = 0; d < dim; ++d)
        modes[d][node[d]] = 1;
      for (unsigned int k = 0; k < planes.size(); ++k)
      {
        const auto [i, j]       = planes[k];
        modes[dim + k][node[i]] = -(x[node[j]] - center[j]);
        modes[dim + k][node[j]] = x[node[i]] - center[i];
      }
    }
    return modes;
  }

#define INSTANTIATE(dim)                                                                                   \
  template RigidMotion<dim>            fit_rigid_motion(const SolidBody<dim> &,                            \
                                                        const std::vector<SolidBody<dim>::Node> &,         \
                                                        const Vector<double> &, const Vector<double> &);   \
  template RigidVelocity<dim>          fit_rigid_velocity(const SolidBody<dim> &,                          \
                                                          const std::vector<SolidBody<dim>::Node> &,       \
                                                          const Vector<double> &, const Vector<double> &); \
  template std::vector<Vector<double>> make_rigid_velocities(const SolidBody<dim> &,                       \
                                                             const Vector<double> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace caudal
