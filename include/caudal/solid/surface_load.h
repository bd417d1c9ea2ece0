#ifndef caudal_solid_surface_load_h
#define caudal_solid_surface_load_h

#include <caudal/base/expression.h>
#include <caudal/solid/solid_body.h>

#include <memory>

namespace caudal
{
  /**
   * A dead load t(s, t) on the surface of a body, entry `Traction`: force per area of the
   * reference configuration [Pa], at the points s of the body's own frame, in directions of the
   * domain.
   */
  template <int dim>
  class SurfaceLoad
  {
  public:
    explicit SurfaceLoad(const SolidBody<dim> &body);

    /** force += int t.N dS over the surface, at @p time; nothing if there is no load. */
    void add_to(Vector<double> &force, double time) const;

  private:
    const SolidBody<dim>            &body;
    std::unique_ptr<Expression<dim>> traction; // null: none
  };
} // namespace caudal

#endif
