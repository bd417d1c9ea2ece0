#ifndef caudal_viscous_body_unknowns_h
#define caudal_viscous_body_unknowns_h

#include <caudal/viscous/coupled_equations.h>

namespace caudal
{
  /** Places of a field of a body in the system of a step: @p n_components of each @p stride. */
  struct Places
  {
    int          begin;
    unsigned int size, n_components, stride;

    int operator[](const unsigned int i) const
    {
      return begin + i / n_components * stride + i % n_components;
    }
  };

  /**
   * Places of the unknowns of a body, which begin at @p begin: node by node its velocity and its
   * force density, last the velocity of its frame.
   */
  template <int dim>
  struct BodyPlaces
  {
    BodyPlaces(const BodyEquations<dim> &equations, const int begin)
        : velocity{begin, equations.n_dofs(), dim, 2 * dim}
        , force_density{begin + dim, equations.n_dofs(), dim, 2 * dim}
        , frame{begin + 2 * static_cast<int>(equations.n_dofs()), equations.n_frame_dofs(), 1, 1}
    {}

    const Places velocity, force_density, frame;
  };

  /**
   * The unknowns, or equations, of all bodies one after the other. Rank 0 owns them, all ranks work
   * with them. The balances of forces stand in the rows of the velocities, the kinematic equations
   * in those of the force densities (see CoupledEquations).
   */
  class BodyVector
  {
  public:
    BodyVector(MPI_Comm communicator, unsigned int size);

    /** From and to a vector of which rank 0 owns everything; the first is collective. */
    void        receive(const FieldVector &source);
    void        send(FieldVector &target) const;
    FieldVector make_owned() const;

    Vector<double> extract(const Places &places) const;
    void           insert(const Vector<double> &part, const Places &places);

  private:
    MPI_Comm            communicator;
    std::vector<double> values;
  };
} // namespace caudal

#endif
