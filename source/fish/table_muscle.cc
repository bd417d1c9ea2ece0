// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/fish/lateral_force.h>
#include <caudal/fish/number_table.h>

#include <deal.II/base/function_lib.h>
#include <deal.II/base/patterns.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace caudal
{
  namespace
  {
    const std::string entry = "Muscle/Table/File";

    /** The places of the columns [body lengths], or none if they are not named. */
    std::vector<double> get_stations(const NumberTable &table)
    {
      std::vector<double> stations;
      if (table.header.empty())
        return stations;
      AssertThrow(std::tolower(table.header[0][0]) == 't', // time, Time [s], t
                  ExcMessage(table.header_place + "the first column is called <" + table.header[0] +
                             ">. It has to be the time: call it so."));
      if (table.header.size() == 2 && !is_number(table.header[1]))
        return stations; // it names the one column of amplitudes
      for (std::size_t i = 1; i < table.header.size(); ++i)
      {
        AssertThrow(is_number(table.header[i]),
                    ExcMessage(table.header_place + "the column <" + table.header[i] +
                               "> has no place. Name each by its arc length in body lengths, such "
                               "as <time, 0, 0.5, 1>."));
        const double station = parse_number(table.header[i], table.header_place);
        AssertThrow(stations.empty() || station > stations.back(),
                    ExcMessage(table.header_place + "the station <" + table.header[i] +
                               "> does not lie behind the one before it. Sort the columns by "
                               "increasing arc length."));
        stations.push_back(station);
      }
      AssertThrow(!stations.empty(),
                  ExcMessage(table.header_place +
                             "there is no station after <time>. Give their positions."));
      return stations;
    }

    void check_rows(const NumberTable &table, const std::size_t n_stations)
    {
      for (std::size_t i = 0; i < table.rows.size(); ++i)
      {
        const auto &[values, place] = table.rows[i];
        AssertThrow(values.size() == n_stations + 1,
                    ExcMessage(place + "there are " + std::to_string(values.size()) +
                               " entries, but a time and " + std::to_string(n_stations) +
                               " amplitude(s) are expected. Complete the row; name several "
                               "stations in a first row <time, s1, s2, ...>."));
        AssertThrow(i == 0 || values[0] > table.rows[i - 1].values[0],
                    ExcMessage(place + "the time <" + Patterns::Tools::to_string(values[0]) +
                               "> is not later than that of the row before. Sort the rows by "
                               "time."));
      }
    }

    /**
     * Amplitudes over time, at one or several stations along the body, from a
     * text file (see NumberTable): a row per instant, the time first. A first row
     * `time, s1, s2, ...` gives the stations (arc length over body length, increasing); it may be
     * left out if there is one column of amplitudes, which then holds for the whole body.
     *
     * Linear between the rows and between the stations, constant beyond the
     * outermost station. The last row of a periodic table repeats the first.
     */
    class ForceTable
    {
    public:
      /** Throws a sentence with file and line about the first bad row. */
      ForceTable(const std::string &file_name, const bool periodic)
          : file_name(file_name)
          , periodic(periodic)
      {
        const NumberTable   table              = read_number_table(entry, file_name, 0);
        const auto         &rows               = table.rows;
        std::vector<double> stations           = get_stations(table);
        const bool          is_same_everywhere = stations.size() <= 1;
        if (is_same_everywhere)
          stations = {0.};
        check_rows(table, stations.size());
        AssertThrow(rows.size() >= 2, ExcMessage(entry + ": " + file_name + ": there are " +
                                                 std::to_string(rows.size()) +
                                                 " rows of numbers. Give at least two."));
        AssertThrow(
            !periodic || std::equal(rows.front().values.begin() + 1, rows.front().values.end(),
                                    rows.back().values.begin() + 1),
            ExcMessage(entry + ": " + file_name +
                       ": the table is periodic, and its last row differs from its first. End "
                       "it with the first row's amplitudes, at the time where the period "
                       "ends."));
        begin = rows.front().values[0];
        end   = rows.back().values[0];

        // An interpolation needs two columns.
        if (is_same_everywhere)
          stations.push_back(1.);
        std::vector<double> times;
        Table<2, double>    values(rows.size(), stations.size());
        for (std::size_t i = 0; i < rows.size(); ++i)
        {
          times.push_back(rows[i].values[0]);
          for (std::size_t j = 0; j < stations.size(); ++j)
          {
            values[i][j] = rows[i].values[is_same_everywhere ? 1 : 1 + j];
            maximum      = std::max(maximum, std::abs(values[i][j]));
          }
        }
        amplitudes = std::make_unique<Functions::InterpolatedTensorProductGridData<2>>(
            std::array<std::vector<double>, 2>{{times, stations}}, values);
      }

      /** The amplitude at time @p time [s] and arc length @p s [body lengths]. */
      double value(double time, const double s) const
      {
        const double duration = end - begin;
        if (periodic)
        {
          const double periods = (time - begin) / duration;
          time                 = begin + duration * (periods - std::floor(periods));
        }
        // A time may miss the end of the table by rounding.
        const double tolerance = 1e-9 * duration;
        AssertThrow(time > begin - tolerance && time < end + tolerance,
                    ExcMessage(file_name + ": the time " + std::to_string(time) +
                               " s lies outside the table. Lengthen it, or make it periodic."));
        return amplitudes->value(Point<2>(time, s));
      }

      std::pair<double, double> get_time_range() const
      {
        return periodic ? std::pair(0., std::numeric_limits<double>::max()) : std::pair(begin, end);
      }

      /** The largest modulus of all amplitudes. */
      double get_maximum() const
      {
        return maximum;
      }

    private:
      const std::string file_name;
      const bool        periodic;
      double            begin = 0., end = 0.; // [s]
      double            maximum = 0.;

      std::unique_ptr<Functions::InterpolatedTensorProductGridData<2>> amplitudes; // of (t, s)
    };

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
                          "lengths over the body length.",
                          Patterns::FileName(Patterns::FileName::input));
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

      std::pair<double, double> get_time_range() const override
      {
        return table->get_time_range();
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
