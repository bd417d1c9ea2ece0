#ifndef caudal_viscous_body_unknowns_h
#define caudal_viscous_body_unknowns_h

#include <caudal/base/types.h>

#include <deal.II/lac/vector.h>

#include <vector>

namespace caudal
{
  using namespace dealii;

  /** Where a field of a body is in the system of a step: @p n_components of each @p stride. */
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
   * Where the unknowns of a body begin at @p begin: node by node its velocity and its force
   * density, last the velocity of its frame.
   */
  template <int dim>
  struct BodyPlaces
  {
    BodyPlaces(const int begin, const unsigned int n_dofs, const unsigned int n_frame)
        : velocity{begin, n_dofs, dim, 2 * dim}
        , force_density{begin + dim, n_dofs, dim, 2 * dim}
        , frame{begin + 2 * static_cast<int>(n_dofs), n_frame, 1, 1}
    {}

    const Places velocity, force_density, frame;
  };

  /** The unknowns of all bodies, which rank 0 owns and all ranks work with. */
  class BodyVector
  {
  public:
    BodyVector(MPI_Comm communicator, unsigned int size);

    /** From and to a vector of which rank 0 owns everything; the first is collective. */
    void receive(const FieldVector &source);
    void send(FieldVector &target) const;

    Vector<double> extract(const Places &places) const;
    void           insert(const Vector<double> &part, const Places &places);

  private:
    MPI_Comm            communicator;
    std::vector<double> values;
  };
} // namespace caudal

#endif
