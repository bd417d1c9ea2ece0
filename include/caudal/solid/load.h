// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_solid_load_h
#define caudal_solid_load_h

#include <caudal/fish/muscle.h>
#include <caudal/fish/prescribed_motion.h>
#include <caudal/solid/rigid_map.h>
#include <caudal/solid/solid_body.h>

namespace caudal
{
  /** The motion of a body, of which its loads are functions. */
  struct BodyMotion
  {
    /** X(s) [m] and U(s) [m/s] at the nodes. */
    const Vector<double> &positions, &velocity;
    /** Time [s], in the step or at one of its ends, and the length of the step [s]. */
    double time, step;
    /** The muscle's decision for the step. */
    const Contraction &contraction;
  };

  /** How the forces b on a body respond to its motion: -db/dX and -db/dU. */
  struct BodyResponse
  {
    SparseMatrix<double> stiffness, damping;

    /** Both are zero, with the pattern of the body's matrices. */
    explicit BodyResponse(const SparsityPattern &pattern)
        : stiffness(pattern)
        , damping(pattern)
    {}
  };

  /** To which account of the energy ledger the work of a load belongs. */
  enum class LoadAccount
  {
    elastic,
    feedback,
    gravity,
    muscle,
    gait
  };

  /** Forces b on a body, by account [N, in 2D N/m]. */
  using ForcesByAccount = std::map<LoadAccount, Vector<double>>;

  /** The rigid motion that lays a shape, given by the places of the nodes, over the body. */
  template <int dim>
  RigidMotion<dim> lay_over(const SolidBody<dim> &body, const std::vector<Point<dim>> &shape,
                            const Vector<double> &positions);

  /**
   * A load on a body, a contribution to the forces b(X, U, t) that its shape functions test
   * [N, in 2D N/m]. A body has a list of them.
   */
  template <int dim>
  class Load
  {
  public:
    Load(const SolidBody<dim> &body, const LoadAccount account)
        : account(account)
        , body(body)
    {}

    virtual ~Load() = default;

    const LoadAccount account;

    /**
     * Adds the load in the @p motion to @p force and, unless that is null, its derivatives to
     * @p response. Throws ExcInvertedElement if it needs det F > 0 and there is none.
     */
    virtual void add(const BodyMotion &motion, Vector<double> &force,
                     BodyResponse *response) const = 0;

  protected:
    const SolidBody<dim> &body;
  };

  /** -int P : grad N ds - sum over the cells of kappa_v V/v ln(v/V) dv/dX, see Region. */
  template <int dim>
  std::unique_ptr<Load<dim>> make_elastic_load(const SolidBody<dim> &body);

  /**
   * int kappa (X_h - X).N + eta (dX_h/dt - U).N ds in the directions in which springs and dampers
   * act, X_h(s, t) being where they hold the body, X_0 unless that is prescribed to move; and
   * likewise on the surface.
   */
  template <int dim>
  std::unique_ptr<Load<dim>> make_feedback_load(const SolidBody<dim> &body);

  /** The weight that the body has in excess of the fluid's, see compute_excess_weight(). */
  template <int dim>
  std::unique_ptr<Load<dim>> make_excess_weight(const SolidBody<dim> &body,
                                                const Vector<double> &weight);

  /** int f_a.N ds - int F S_a : grad N ds: force density and active stress of the @p muscle. */
  template <int dim>
  std::unique_ptr<Load<dim>> make_muscle_load(const SolidBody<dim> &body,
                                              const Muscle<dim>    &muscle);

  /**
   * int t.N dS of a dead load t(s, t) on the surface, entry `Traction`: force per area of the
   * reference configuration [Pa], at the points s of the body's own frame, in directions of the
   * domain. Its work counts as the muscle's.
   */
  template <int dim>
  std::unique_ptr<Load<dim>> make_surface_load(const SolidBody<dim> &body);

  /**
   * int eta (V - U).N ds, V the velocity that the @p gait of the nodes asks for, up to the velocity
   * of the body's frame, which the step's equations add: the deformation velocity of the prescribed
   * shape, laid over the body by a rotation and a translation, plus its distance from X over ten
   * steps.
   */
  template <int dim>
  std::unique_ptr<Load<dim>> make_gait_load(const SolidBody<dim>        &body,
                                            const PrescribedMotion<dim> &gait, double damping);

  /** The motion that the @p gait prescribes to the body's nodes. */
  template <int dim>
  PrescribedMotion<dim> prescribe_nodes(const SolidBody<dim> &body, const Gait &gait);

  /** The nodal positions of the shape that a @p gait starts with, laid over the straight body. */
  template <int dim>
  Vector<double> compute_first_positions(const SolidBody<dim>        &body,
                                         const PrescribedMotion<dim> &gait);
} // namespace caudal

#endif
