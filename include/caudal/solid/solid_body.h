// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_solid_solid_body_h
#define caudal_solid_solid_body_h

#include <caudal/solid/solid_parameters.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>

#include <array>

namespace caudal
{
  /** The unknowns of a node, one for each component. */
  template <int dim>
  using Node = std::array<unsigned int, dim>;

  /** The value of a nodal field at a node. */
  template <std::size_t dim>
  Point<dim> get_value(const Vector<double> &field, const std::array<unsigned int, dim> &node)
  {
    Point<dim> value;
    for (unsigned int d = 0; d < dim; ++d)
      value[d] = field[node[d]];
    return value;
  }

  /** The positions of the nodes of a body's cell, in the order of its scalar shape functions. */
  template <int dim>
  std::vector<Point<dim>> get_cell_nodes(const typename DoFHandler<dim>::active_cell_iterator &cell,
                                         const Vector<double> &positions);

  template <int dim>
  class SolidBody;

  /** The sum of nodal forces. */
  template <int dim>
  Tensor<1, dim> sum_up(const SolidBody<dim> &body, const Vector<double> &forces);

  /** int (rho_s - rho) g.N ds, the weight that the body has in excess of the fluid's. */
  template <int dim>
  Vector<double> compute_excess_weight(const SolidBody<dim> &body, const Tensor<1, dim> &gravity);

  template <std::size_t dim>
  void set_value(Vector<double> &field, const std::array<unsigned int, dim> &node,
                 const Tensor<1, static_cast<int>(dim)> &value)
  {
    for (unsigned int d = 0; d < dim; ++d)
      field[node[d]] = value[d];
  }

  /** What a body must know of the fluid that it is immersed in. */
  struct Surroundings
  {
    double density = 0; // [kg/m^3]
    double cell    = 0; // edge of the finest cells [m]; 0: there is no fluid
  };

  /**
   * A hyperelastic solid in its reference configuration (its own frame): grid, materials, nodes
   * and the matrices that do not change. Nodal positions X(s,t) and velocities U(s,t) are vectors
   * in the domain's frame. It is replicated on all ranks.
   */
  template <int dim>
  class SolidBody
  {
  public:
    SolidBody(const SolidParameters<dim> &parameters, const Surroundings &fluid);

    const SolidParameters<dim> &get_parameters() const
    {
      return parameters;
    }
    const std::string &get_name() const
    {
      return parameters.name;
    }
    const DoFHandler<dim> &get_dof_handler() const
    {
      return dof_handler;
    }
    const Triangulation<dim> &get_triangulation() const
    {
      return triangulation;
    }
    unsigned int n_dofs() const
    {
      return dof_handler.n_dofs();
    }
    /** Whether this unknown's node belongs to a region whose points are where they are told to be.
     */
    bool is_fixed(const unsigned int dof) const
    {
      return fixed_dofs[dof];
    }
    /** Whether the springs of a region, and not only those of the surface, hold this unknown. */
    bool has_springs(const unsigned int dof) const
    {
      return spring_dofs[dof];
    }

    /** Removes what acts on the nodes of fixed regions, which is borne by their support. */
    void clear_fixed_nodes(Vector<double> &force) const;
    /** Removes the rows of these nodes. */
    void clear_fixed_nodes(SparseMatrix<double> &matrix) const;

    /** Where what holds the nodes wants them to be at @p time: X_0 if it does not move. */
    Vector<double> compute_held_positions(double time) const;

    /** Puts the nodes of fixed regions to where they are held at @p time. */
    void restore_fixed_nodes(Vector<double> &positions, double time) const;

    /** Whether what holds the nodes moves. */
    bool has_moving_places() const;

    const Material<dim> &get_material(const unsigned int region) const
    {
      return *materials[region];
    }

    /** kappa_v, the modulus of the energy of the cells' volumes in a region [Pa]. */
    double get_cell_volume_stabilisation(const unsigned int region) const
    {
      return cell_volume_stabilisations[region];
    }

    /** M_s = int N_a N_b ds. */
    const SparseMatrix<double> &get_mass_matrix() const
    {
      return mass;
    }
    /**
     * C = M_s + beta int_dB h_s N_a N_b dS, h_s being the height of the first layer of elements:
     * velocities and force densities go between body and fluid with it, C U = G u and f = G^T Phi
     * where C Phi is the force on the body. The true force of a constraint sits on the surface; a
     * force density alone spreads it over that layer.
     */
    const SparseMatrix<double> &get_coupling_mass() const
    {
      return coupling_mass;
    }
    /**
     * int kappa N_a N_b ds in the directions in which the feedback force acts, and the springs of
     * the surface.
     */
    const SparseMatrix<double> &get_feedback_stiffness() const
    {
      return feedback_stiffness;
    }
    /** int eta N_a N_b ds, likewise. */
    const SparseMatrix<double> &get_feedback_damping() const
    {
      return feedback_damping;
    }
    const SparsityPattern &get_sparsity_pattern() const
    {
      return pattern;
    }
    /** rho_s - rho [kg/m^3] */
    double get_excess_density() const
    {
      return excess_density;
    }
    /** vector := C^-1 vector */
    void apply_inverse_coupling_mass(Vector<double> &vector) const;

    /** vector := M_s^-1 vector; it factorises M_s. */
    void apply_inverse_mass(Vector<double> &vector) const;

    using Node = caudal::Node<dim>;
    const std::vector<Node> &get_nodes() const
    {
      return nodes;
    }
    /** The nodes in the first region, the swimmer's head. */
    const std::vector<Node> &get_head_nodes() const
    {
      return head_nodes;
    }
    /** X_0, where the parameters place the nodes at the start [m]. */
    const Vector<double> &get_initial_positions() const
    {
      return initial_positions;
    }
    /** Reference point (own frame) of an unknown. */
    const Point<dim> &get_reference_point(const unsigned int dof) const
    {
      return reference_points[dof];
    }
    /** int N_a ds, the lumped mass matrix. */
    const Vector<double> &get_nodal_volumes() const
    {
      return nodal_volumes;
    }

    /** int ds [m^dim] */
    double get_reference_volume() const
    {
      return reference_volume;
    }
    /** The unit vector d of the body's own frame, at the start. */
    Tensor<1, dim> get_initial_axis(unsigned int d) const;
    /** Rotates a vector of the body's frame as the body is placed at the start. */
    Tensor<1, dim> rotate_to_domain(const Tensor<1, dim> &vector) const;

    /**
     * Prepares the evaluation of fields at a point of the reference
     * configuration (the body's own frame) and returns its number. Throws if it
     * is outside the body; @p path names the entry that it comes from. The
     * monitored points of the parameters are the first ones.
     */
    unsigned int add_point(const Point<dim> &point, const std::string &path);
    /** The value of a nodal field at the point with number @p index. */
    Tensor<1, dim> evaluate(const Vector<double> &field, unsigned int index) const;
    /** Mean of a nodal field over the reference volume. */
    Tensor<1, dim> compute_mean(const Vector<double> &field) const;
    /** Whether a point of the domain lies in the body at the start. */
    bool contains_at_start(const Point<dim> &point) const;
    /** Boxes around the cells for the nodal positions @p x. */
    std::vector<BoundingBox<dim>> compute_cell_boxes(const Vector<double> &x) const;

    /** A quadrature point of the reference configuration. */
    struct QuadraturePoint
    {
      Point<dim>                  place;
      double                      weight;
      std::vector<double>         values; // of the scalar shape functions
      std::vector<Tensor<1, dim>> gradients;
    };
    /** The quadrature points of the active cell with this index. */
    const std::vector<QuadraturePoint> &get_quadrature_points(const unsigned int cell) const
    {
      return quadrature_points[cell];
    }

  private:
    const SolidParameters<dim>                 &parameters;
    Triangulation<dim>                          triangulation;
    const FESystem<dim>                         element;
    DoFHandler<dim>                             dof_handler;
    std::vector<std::unique_ptr<Material<dim>>> materials;
    std::vector<double>                         cell_volume_stabilisations; // by region
    SparsityPattern                             pattern;
    SparseMatrix<double>                        mass, coupling_mass;
    SparseMatrix<double>                        feedback_stiffness, feedback_damping;
    SparseDirectUMFPACK                         inverse_coupling_mass;
    double                                      excess_density, reference_volume = 0;
    std::vector<std::vector<QuadraturePoint>>   quadrature_points; // by cell
    std::vector<Node>                           nodes, head_nodes;
    std::vector<Point<dim>>                     reference_points;
    std::vector<bool>                           fixed_dofs, spring_dofs;
    std::vector<PrescribedPlace<dim>>           places;           // by region
    std::vector<unsigned int>                   regions_of_nodes; // that hold them
    Vector<double>                              initial_positions, nodal_volumes;

    struct PointValue
    {
      std::vector<types::global_dof_index> dofs;
      std::vector<double>                  shape_values; // one per dof
    };
    std::vector<PointValue> points;

    void set_up_nodes();
    void set_up_quadrature();
    void assemble_matrices();
    void add_surface_springs(const std::string &entry, const std::string &coefficient,
                             SparseMatrix<double> &matrix) const;
    void assemble_coupling_mass();
  };
} // namespace caudal

#endif
