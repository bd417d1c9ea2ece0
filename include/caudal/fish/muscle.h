#ifndef caudal_fish_muscle_h
#define caudal_fish_muscle_h

#include <caudal/fish/controller.h>
#include <caudal/fish/ramp.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/base/types.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace caudal
{
  using namespace dealii;

  /** A point of the body. */
  template <int dim>
  struct MaterialPoint
  {
    /** Place in the reference shape [m], in the body frame: origin at the nose,
        x towards the tail, y lateral. */
    Point<dim> s;
    /** The region of the body that it belongs to. */
    types::material_id region;
  };

  /**
   * What drives the body: a force density f_a [N/m^3 of reference volume] and
   * an active stress S_a [Pa], a second Piola-Kirchhoff stress (P_a = F S_a),
   * both in the axes of the body frame. This base class is a passive muscle.
   *
   * A step begins with set_command() and prepare_step(), for a rejected step
   * again with the new step size; accept_step() makes its decisions final.
   */
  template <int dim>
  class Muscle
  {
  public:
    virtual ~Muscle() = default;

    void set_command(const MuscleCommand &new_command)
    {
      command = new_command;
    }

    /** Decides on the activation during the step that @p state describes. */
    virtual void prepare_step(const SwimmerState &state);

    virtual void accept_step();

    /** At @p time, which lies in the prepared step or at its end; see the muscles. */
    virtual Tensor<1, dim> force_density(const MaterialPoint<dim> &point, const double time) const;

    virtual Tensor<2, dim> active_stress(const MaterialPoint<dim> &point, const double time) const;

    virtual bool has_force() const;

    virtual bool has_active_stress() const;

    /** Activation in the middle of the prepared step, 1 at full strength (for the statistics). */
    virtual double activation() const;

    /** What a run that resumes must know, and its way back. */
    virtual std::vector<double> get_state() const;

    virtual void set_state(const std::vector<double> &state);

  protected:
    MuscleCommand command;
    double        step_begin = 0.;
    double        step       = 0.;
  };

  /**
   * A lateral force density +-F_max g(s,y) e_y that reverses whenever the
   * monitored point has been driven to the switching position on either side
   * (doi:10.1155/2014/489683, section 5).
   */
  struct BangBangParameters
  {
    double maximum_force_density = 1.5e6;
    double switching_position    = 0.05;
    double switching_duration    = 0.;
    int    initial_direction     = 1;

    void add_parameters(ParameterHandler &prm);
    void check(const std::string &path) const;
  };

  /**
   * A wave of contraction that runs from head to tail, on both sides in
   * opposition: S_a = T e_x e_x with
   *   T = T_max A(s) y/(L b) (gain sin(2 pi (f t - k s) + phase) + bias).
   * s is the arc length and b a reference half thickness, both over the body
   * length L. Like the stress of a bent beam, T is linear across the body: it
   * bends a symmetric section and does not shorten it.
   */
  struct TravellingWaveParameters
  {
    double      maximum_active_stress    = 1e5;
    std::string envelope                 = "s";
    double      wave_number              = 1.;
    double      frequency                = 1.;
    double      phase                    = 0.;
    double      reference_half_thickness = 0.06;

    void add_parameters(ParameterHandler &prm);
    void check(const std::string &path) const;
  };

  /**
   * Fibres under a tension that the .prm gives, S_a = T a a^T, P_a = T F a a^T,
   * with T and the direction a, which is normalised, functions of the place in
   * the reference shape. With a constant T it is a passive, anisotropic
   * material, such as the wall of the ring of Boffi, Gastaldi, Heltai & Peskin
   * (2008, doi:10.1016/j.cma.2007.09.015).
   */
  struct FibreParameters
  {
    std::string tension   = "1e5";
    std::string direction = "1; 0";

    void add_parameters(ParameterHandler &prm);
  };

  /** Lateral force densities from a file, see ForceTable, times g(s,y). */
  struct TableParameters
  {
    std::string file;
    bool        periodic = false;

    void add_parameters(ParameterHandler &prm);
    void check(const std::string &path) const;
  };

  /** Section `Muscle` of a body: see get_muscle_names() for its types. */
  struct MuscleParameters
  {
    std::string              type = "none";
    std::vector<std::string> regions;
    double                   monitored_point = 0.96;
    StartUpRamp              ramp;
    std::string              force_distribution = "1";

    BangBangParameters       bang_bang;
    TravellingWaveParameters travelling_wave;
    FibreParameters          fibres;
    TableParameters          table;

    /** Declares the section in the one that @p prm is in. */
    void add_parameters(ParameterHandler &prm);

    /** Throws a sentence about the first bad entry; @p path is the body's section. */
    void check(const std::string &path) const;
  };

  /**
   * The muscle that @p parameters describe, of a body of length @p length [m]
   * whose regions have the numbers @p region_ids by name.
   */
  template <int dim>
  std::unique_ptr<Muscle<dim>>
  create_muscle(const MuscleParameters &parameters, const double length,
                const std::map<std::string, types::material_id> &region_ids = {});

  /** All names of muscles, separated by '|' as Patterns::Selection wants them. */
  std::string get_muscle_names();
} // namespace caudal

#endif
