#ifndef caudal_ideal_shape_h
#define caudal_ideal_shape_h

#include <caudal/ideal/surface.h>

#include <deal.II/base/symmetric_tensor.h>

#include <memory>
#include <string>
#include <vector>

namespace caudal::ideal
{
  /** Section `Shape` of the .prm: the straight body. */
  struct ShapeParameters
  {
    std::string         type   = "stations";
    double              length = 0.1;
    std::string         stations;
    std::string         stations_file;
    std::string         interpolation = "limited";
    std::vector<double> axes          = {0.05, 0.01, 0.01};

    void add_parameters(ParameterHandler &prm);
    void check() const;
  };

  /**
   * A slice of the body across its spine, as a rigid piece: what it displaces and the
   * integrals of the products of (1, y, z) over it, y lateral and z dorsal from the spine.
   */
  struct Section
  {
    double                s;       ///< arc length from the nose [m]
    SymmetricTensor<2, 3> moments; ///< int (1,y,z)(1,y,z) dV [m^3, m^4, m^5]
  };

  /**
   * The straight body: nose at s = 0, tail at s = get_length(). A point of it is (s, y, z),
   * with y lateral and z dorsal [m].
   */
  class Shape
  {
  public:
    virtual ~Shape() = default;

    virtual double get_length() const = 0;

    /** Where the surface's node with the reference point @p reference is: (s, y, z) [m]. */
    virtual Point<3> place(const Point<3> &reference) const = 0;

    /** Half the lateral width at s [m]. */
    virtual double half_width(double s) const = 0;

    /** The volume in slices, for integrals over the body. */
    virtual std::vector<Section> compute_sections() const = 0;

    /** Whether a bend to the left is the mirror image of one to the right. */
    virtual bool is_symmetric() const = 0;
  };

  /**
   * The shape that @p parameters describe; @p surface matters for `file` only.
   *
   * `stations`: ellipses of half-width a and half-height b across the spine,
   *   a(s) = g_a(s) E(s), E = 2 sqrt(s (L - s))/L, g_a = exp(p(s)), p the Profile through
   *   ln(a_i/E(s_i)), and b likewise: round ends, positive and, if the profile is limited,
   *   without bulges between the stations.
   * `ellipsoid`: g_a and g_b are constant.
   * `file`: the surface mesh of section `Surface`.
   */
  std::unique_ptr<Shape> create_shape(const ShapeParameters &parameters, const Surface &surface);
} // namespace caudal::ideal

#endif
