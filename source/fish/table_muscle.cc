// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/fish/force_table.h>
#include <caudal/fish/lateral_force.h>

namespace caudal
{
  namespace
  {
    /** Lateral force densities from a file, see ForceTable, times g(s,y). */
    template <int dim>
    class TableMuscle : public LateralForce<dim>
    {
    public:
      void add_parameters(ParameterHandler &prm) override
      {
        prm.add_parameter("File", file,
                          "Text file of times [s] and force densities [N/m^3], a row per instant; "
                          "several columns if a first row <time, s1, s2, ...> gives their arc "
                          "lengths over the body length.");
        prm.add_parameter("Periodic", periodic,
                          "Whether the table repeats; its last row must then equal its first.");
      }

      void check(const std::string &path) const override
      {
        AssertThrow(!file.empty(),
                    ExcMessage(path + "/File: there is no file name. Give the table's."));
        ForceTable(file, periodic);
      }

      void set_up(const SharedMuscleParameters &shared, const double length,
                  const std::map<std::string, types::material_id> &region_ids) override
      {
        LateralForce<dim>::set_up(shared, length, region_ids);
        table           = std::make_shared<ForceTable>(file, periodic);
        monitored_point = shared.monitored_point;
      }

      double activation(const Contraction &contraction) const override
      {
        const double maximum = table->get_maximum();
        return maximum > 0.
                   ? amplitude(contraction, monitored_point, contraction.get_middle()) / maximum
                   : 0.;
      }

    protected:
      double amplitude(const Contraction &contraction, const double s,
                       const double time) const override
      {
        return this->ramp.value(time) * (contraction.command.gain * table->value(time, s) +
                                         contraction.command.bias * table->get_maximum());
      }

    private:
      std::string                       file;
      bool                              periodic = false;
      std::shared_ptr<const ForceTable> table;
      double                            monitored_point = 1.;
    };

    const DimensionalRegistration<Muscle, TableMuscle> registration("table",
                                                                    "a lateral force from a file");
  } // namespace
} // namespace caudal
