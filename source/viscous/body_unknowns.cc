#include <caudal/viscous/body_unknowns.h>

#include <algorithm>

namespace caudal
{
  BodyVector::BodyVector(MPI_Comm communicator, const unsigned int size)
      : communicator(communicator)
      , values(size)
  {}

  void BodyVector::receive(const FieldVector &source)
  {
    std::copy_n(source.begin(), source.locally_owned_size(), values.begin());
    MPI_Bcast(values.data(), values.size(), MPI_DOUBLE, 0, communicator);
  }

  void BodyVector::send(FieldVector &target) const
  {
    std::copy_n(values.begin(), target.locally_owned_size(), target.begin());
  }

  FieldVector BodyVector::make_owned() const
  {
    IndexSet owned(values.size());
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      owned.add_range(0, values.size());
    FieldVector result(owned, communicator);
    send(result);
    return result;
  }

  Vector<double> BodyVector::extract(const Places &places) const
  {
    Vector<double> part(places.size);
    for (unsigned int i = 0; i < places.size; ++i)
      part[i] = values[places[i]];
    return part;
  }

  void BodyVector::insert(const Vector<double> &part, const Places &places)
  {
    AssertDimension(part.size(), places.size);
    for (unsigned int i = 0; i < places.size; ++i)
      values[places[i]] = part[i];
  }
} // namespace caudal
