#include <caudal/ideal/boundary_elements.h>

namespace caudal::ideal
{
  BoundaryElements::BoundaryElements(const Surface &surface, const MPI_Comm communicator)
      : surface(surface)
      , communicator(communicator)
      , rules(surface.get_fe())
  {}

  std::unique_ptr<ExteriorFlow> BoundaryElements::solve(SurfaceMotion motion)
  {
    return std::make_unique<ExteriorFlow>(surface, std::move(motion), rules, communicator, cost);
  }

  Potentials BoundaryElements::compute_potentials(SurfaceMotion motion)
  {
    return solve(std::move(motion))->get_potentials();
  }
} // namespace caudal::ideal
