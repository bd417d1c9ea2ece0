#ifndef caudal_mesh_body_shape_h
#define caudal_mesh_body_shape_h

#include <caudal/base/factory.h>
#include <caudal/mesh/body_grid.h>

#include <memory>
#include <string>

namespace caudal
{
  /**
   * A kind of body that can be chosen by name. A new one derives from this
   * class and gets a line in get_body_shapes().
   */
  template <int dim>
  class BodyShape
  {
  public:
    /** The parameters must outlive the shape. */
    explicit BodyShape(const BodyGridParameters<dim> &parameters);

    virtual ~BodyShape() = default;

    /** Throws a sentence if an entry that this shape uses has a value that can't work. */
    virtual void check(const std::string &path) const = 0;

    /**
     * Whether the shape itself divides the body into regions; otherwise entry
     * `Region boundaries` does.
     */
    virtual bool has_own_regions() const
    {
      return false;
    }

    /**
     * Makes the grid in the body's own frame [m]. There is one material id for
     * each region, in the regions' order.
     */
    virtual void make_grid(Triangulation<dim> &tria, const std::string &path) const = 0;

  protected:
    const BodyGridParameters<dim> &parameters;
  };

  /** The known shapes; those of slender fish are plane and exist for dim = 2 only. */
  template <int dim>
  const Factory<BodyShape<dim>, const BodyGridParameters<dim> &> &get_body_shapes();
} // namespace caudal

#endif
