// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_observe_fields_h
#define caudal_observe_fields_h

#include <caudal/observe/field_observer.h>
#include <caudal/observe/flow_quantity.h>

#include <deal.II/numerics/data_postprocessor.h>

namespace caudal
{
  /**
   * Velocity, pressure and vorticity of the fluid with what `Output/Additional fields` names, and
   * the bodies' motion and stresses.
   */
  template <int dim>
  class Fields : public FieldObserver<dim>
  {
  public:
    Fields()
        : FieldObserver<dim>(100, "solution")
    {}

    void add_parameters(ParameterHandler &prm) override;
    void check(const std::string &path) const override;

    /** What is made of the velocity's gradient: the vorticity [1/s] and the additional fields. */
    using Derived = std::vector<std::unique_ptr<DataPostprocessor<dim>>>;
    Derived make_derived_fields() const;

  protected:
    bool is_active() const override
    {
      return true;
    }
    double get_interval(const OutputParameters &output) const override
    {
      return output.field_interval;
    }
    void write_fields(const Observation<dim> &, const ObserverContext<dim> &) override;

  private:
    PluginList<FlowQuantity<dim>> quantities; // all that there are
    std::vector<std::string>      additional; // names of those that are written

    bool is_wanted(const std::string &name) const;
    void write_fluid(const Observation<dim> &observation, unsigned int n_subdivisions);
    void write_body(const Observation<dim> &observation, const BodyObservation<dim> &observed);
  };

  /** Adds to @p data_out a vector field of @p dofs, whose element has dim equal components. */
  template <class DataOut, int dim, class VectorType>
  void add_vector(DataOut &data_out, const DoFHandler<dim> &dofs, const VectorType &values,
                  const std::string &name)
  {
    data_out.add_data_vector(dofs, values, std::vector<std::string>(dim, name),
                             std::vector<DataComponentInterpretation::DataComponentInterpretation>(
                                 dim, DataComponentInterpretation::component_is_part_of_vector));
  }

  /** The displacement X - X_0 of a body's nodes [m]. */
  template <int dim>
  Vector<double> compute_displacement(const BodyObservation<dim> &observed);

  /** How far the nodes are from their places on the body's grid, which lives in its own frame [m].
   */
  template <int dim>
  Vector<double> compute_move(const BodyObservation<dim> &observed);
} // namespace caudal

#endif
