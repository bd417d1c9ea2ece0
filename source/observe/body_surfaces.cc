// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/observe/fields.h>
#include <caudal/observe/flow_evaluation.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q_eulerian.h>
#include <deal.II/numerics/data_out_faces.h>

#include <algorithm>

namespace caudal
{
  namespace
  {
    /** What the fluid does to the nodes of a body; zero inside of it. */
    struct SurfaceLoad
    {
      Vector<double> pressure; // [Pa], the same for all components of a node
      Vector<double> traction; // [Pa]
    };

    /**
     * int N_a n dS over the deformed surface, by unknown [m^(dim-1)]: the direction of the outer
     * normal at the nodes, and zero inside.
     */
    template <int dim>
    Vector<double> compute_node_normals(const DoFHandler<dim> &dofs, const Mapping<dim> &mapping)
    {
      const FiniteElement<dim> &element = dofs.get_fe();
      FEFaceValues<dim>         values(mapping, element, QGauss<dim - 1>(element.degree + 1),
                                       update_values | update_normal_vectors | update_JxW_values);
      Vector<double>            normals(dofs.n_dofs());
      std::vector<types::global_dof_index> indices(element.n_dofs_per_cell());
      for (const auto &cell : dofs.active_cell_iterators())
        for (const unsigned int face : cell->face_indices())
        {
          if (!cell->face(face)->at_boundary())
            continue;
          values.reinit(cell, face);
          cell->get_dof_indices(indices);
          for (unsigned int i = 0; i < indices.size(); ++i)
          {
            if (!element.has_support_on_face(i, face))
              continue;
            for (const unsigned int q : values.quadrature_point_indices())
              normals[indices[i]] +=
                  values.shape_value(i, q) * values.JxW(q) *
                  values.normal_vector(q)[element.system_to_component_index(i).first];
          }
        }
      return normals;
    }

    /**
     * The surface of each body with what it does and what the fluid does to it: displacement [m],
     * velocity [m/s], pressure p and traction t = -p n + mu (grad u + grad u^T) n [Pa], n being the
     * outer normal. Across the surface pressure and gradients jump, which the grid resolves within
     * a cell; they are taken at the distance of a cell outside of it. In two dimensions a surface
     * is a line.
     */
    template <int dim>
    class BodySurfaces : public FieldObserver<dim>
    {
    public:
      BodySurfaces()
          : FieldObserver<dim>(102, "surfaces")
      {}

      void add_parameters(ParameterHandler &prm) override
      {
        prm.enter_subsection("Output");
        prm.enter_subsection("Surfaces");
        prm.add_parameter("Write", is_written,
                          "Whether the surface of each body is written, too, as light files with "
                          "displacement, velocity, pressure and the traction of the fluid "
                          "[Pa]: open surfaces.pvd (surfaces.xdmf). In two dimensions it is a "
                          "line.");
        interval.add_parameter(prm);
        prm.add_parameter("Distance", distance,
                          "How far outside of the surface pressure and velocity gradient are "
                          "taken from the fluid, in cells of the finest level: the immersed body "
                          "smears their jumps over about a cell [1].");
        prm.leave_subsection();
        prm.leave_subsection();
      }

      void check(const std::string & /*path*/) const override
      {
        interval.check();
        check_not_negative("Output/Surfaces/Distance", distance);
      }

    protected:
      bool is_active() const override
      {
        return is_written;
      }

      double get_interval(const OutputParameters &output) const override
      {
        return interval.get(output);
      }

      void write_fields(const Observation<dim> &observation, const ObserverContext<dim> &) override
      {
        for (const auto &body : observation.bodies)
          write_surface(observation, body);
      }

    private:
      bool        is_written = false;
      OwnInterval interval{"Output/Surfaces/Interval", "surfaces"};
      double      distance = 1;

      void write_surface(const Observation<dim> &observation, const BodyObservation<dim> &observed)
      {
        const DoFHandler<dim>      &dofs         = observed.body.get_solid().get_dof_handler();
        const Vector<double>        displacement = compute_displacement(observed);
        const Vector<double>        move         = compute_move(observed);
        const MappingQEulerian<dim> mapping(dofs.get_fe().degree, dofs, move);
        const SurfaceLoad           load =
            compute_load(observation, observed, compute_node_normals(dofs, mapping));

        DoFHandler<dim> scalar_dofs(dofs.get_triangulation());
        scalar_dofs.distribute_dofs(dofs.get_fe().base_element(0));
        const Vector<double> pressure = get_first_component(dofs, load.pressure, scalar_dofs);

        DataOutFaces<dim> data_out;
        data_out.attach_triangulation(dofs.get_triangulation());
        add_vector(data_out, dofs, displacement, "displacement");
        add_vector(data_out, dofs, observed.state.velocity, "velocity");
        data_out.add_data_vector(scalar_dofs, pressure, "pressure");
        add_vector(data_out, dofs, load.traction, "traction");
        data_out.build_patches(mapping, dofs.get_fe().degree);
        this->add(data_out, "surface_" + observed.body.get_name(), observation, MPI_COMM_SELF);
      }

      /** The load of the fluid on the surface whose nodes have these @p normals, of any length. */
      SurfaceLoad compute_load(const Observation<dim>     &observation,
                               const BodyObservation<dim> &observed,
                               const Vector<double>       &normals) const
      {
        const SolidBody<dim> &solid = observed.body.get_solid();
        const auto size = observation.lattice.get_cell_size(observation.lattice.get_finest_level());
        double     cell = size[0];
        for (unsigned int d = 1; d < dim; ++d)
          cell = std::min(cell, size[d]);
        const Tensor<1, dim> origin = restrict_to<dim>(observation.origin);

        std::vector<Node<dim>>      nodes;
        std::vector<Tensor<1, dim>> directions;
        std::vector<Point<dim>>     points;
        for (const auto &node : solid.get_nodes())
        {
          const Tensor<1, dim> normal = get_value(normals, node);
          if (normal.norm() == 0)
            continue; // inside
          nodes.push_back(node);
          directions.push_back(normal / normal.norm());
          points.push_back(get_value(observed.state.positions, node) - origin +
                           distance * cell * directions.back());
        }
        const auto flow = evaluate_flow(observation, points);

        const auto &parameters = observation.space.get_parameters();
        SurfaceLoad load{Vector<double>(solid.n_dofs()), Vector<double>(solid.n_dofs())};
        for (unsigned int k = 0; k < nodes.size(); ++k)
        {
          const Tensor<2, dim> strain   = flow[k].gradient + transpose(flow[k].gradient);
          const Tensor<1, dim> traction = parameters.get_viscosity() * strain * directions[k] -
                                          flow[k].pressure * directions[k];
          set_value(load.traction, nodes[k], traction);
          for (unsigned int d = 0; d < dim; ++d)
            load.pressure[nodes[k][d]] = flow[k].pressure;
        }
        return load;
      }

      /** The first component of a field of @p dofs, as unknowns of the scalar element. */
      static Vector<double> get_first_component(const DoFHandler<dim> &dofs,
                                                const Vector<double>  &field,
                                                const DoFHandler<dim> &scalar_dofs)
      {
        const FiniteElement<dim>            &element = dofs.get_fe();
        Vector<double>                       result(scalar_dofs.n_dofs());
        std::vector<types::global_dof_index> indices(element.n_dofs_per_cell()),
            scalar_indices(scalar_dofs.get_fe().n_dofs_per_cell());
        for (const auto &scalar_cell : scalar_dofs.active_cell_iterators())
        {
          scalar_cell->get_dof_indices(scalar_indices);
          typename DoFHandler<dim>::active_cell_iterator(*scalar_cell, &dofs)
              ->get_dof_indices(indices);
          for (unsigned int a = 0; a < scalar_indices.size(); ++a)
            result[scalar_indices[a]] = field[indices[element.component_to_system_index(0, a)]];
        }
        return result;
      }
    };

    const DimensionalRegistration<Observer, BodySurfaces>
        registration("surfaces", "surfaces of the bodies as files of their own");
  } // namespace
} // namespace caudal
