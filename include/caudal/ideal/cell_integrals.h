#ifndef caudal_ideal_cell_integrals_h
#define caudal_ideal_cell_integrals_h

#include <caudal/ideal/surface_quadrature.h>

namespace caudal::ideal
{
  /** Integrals over a cell or a part of it, for each of its shape functions N_k. */
  struct CellMoments
  {
    alignas(64) double dipole[ReferenceRule::stride];    ///< int N_k dG/dn_y dS [1]
    alignas(64) double single[3][ReferenceRule::stride]; ///< int N_k G n dS [m]
  };

  /** Adds the integrals by @p rule, as seen from x, which is none of its points. */
  void add_moments(const CellRule &rule, const Point<3> &x, CellMoments &moments);

  /**
   * The same for the dipole alone; and the integrals of G times several normal velocities,
   * whose values times N are in the rows of @p fluxes, to @p single.
   */
  void add_far_moments(const CellRule &rule, const Point<3> &x, const double *fluxes,
                       unsigned int n_fluxes, double *dipole, double *single);

  /** One flow at the nodes of a cell: the potential and the surface's velocity. */
  struct CellFlow
  {
    alignas(64) double potential[ReferenceRule::stride];
    alignas(64) double velocity[3][ReferenceRule::stride];
  };

  /** Derivatives of a number with respect to places and velocities of a cell's nodes. */
  struct CellGradient
  {
    alignas(64) double place[3][ReferenceRule::stride];
    alignas(64) double velocity[3][ReferenceRule::stride];
  };

  /**
   * Derivatives of a number F with respect to what is at the points of one CellRule: their
   * places y, their elements of area N = n dS, and the fluxes w = u.N. F is the sum over
   * nodes x of lambda_x times the residual of their boundary integral equation,
   *
   *   R_x = phi_x + int ((phi_y - phi_x) (y - x).N/(4 pi |y - x|^3) + w/(4 pi |y - x|)).
   *
   * First begin(), then add() for each x that uses the rule, at last end(), which returns
   * the derivatives with respect to the nodes of the cell.
   */
  class PointGradients
  {
  public:
    bool is_empty() const
    {
      return data.empty();
    }

    void begin(const CellRule &rule, const CellFlow &flow);

    /** The equation of @p x, where the potential is phi_x; adds to dF/dx. */
    void add(const CellRule &rule, const Point<3> &x, double lambda, double phi_x,
             Tensor<1, 3> &by_x);

    /** Adds @p factor times the integral of phi w over the cell. */
    void add_energy(const CellRule &rule, double factor);

    /** Forgets all. */
    void end(const CellRule &rule, const std::vector<Point<3>> &positions, const CellFlow &flow,
             CellGradient &gradient);

  private:
    // Each quantity at all points: phi, w; the derivatives by y, N and w.
    static constexpr unsigned int n_fields = 9;
    std::vector<double>           data;
  };
} // namespace caudal::ideal

#endif
