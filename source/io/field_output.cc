// SPDX-License-Identifier: LGPL-2.1-or-later
#include "joined_pieces.h"

#include <caudal/base/checks.h>
#include <caudal/base/collective.h>
#include <caudal/base/compatibility.h>
#include <caudal/base/safe_file.h>
#include <caudal/io/field_output.h>

#include <deal.II/grid/reference_cell.h>

#include <cmath>
#include <filesystem>
#include <regex>
#include <sstream>

using namespace dealii;

namespace caudal
{
  namespace
  {
    const int n_digits = 12; // of times

    /** Writes the data as VTU and returns their entry in the list. Collective. */
    template <int dim, int spacedim>
    std::string write_vtu(DataOutInterface<dim, spacedim> &data_out, const OutputFolder &folder,
                          const std::string &file, const std::string &name, const double time,
                          const unsigned int counter, const MPI_Comm communicator)
    {
      DataOutBase::VtkFlags flags;
      flags.time                = time;
      flags.cycle               = counter;
      flags.print_date_and_time = false; // equal runs give equal files
      flags.compression_level   = decltype(flags.compression_level)::best_speed;
      data_out.set_flags(flags);
      write_joined_pieces([&]() { return folder.add(file); },
                          [&]() {
                            std::ostringstream text;
                            data_out.write_vtu(text);
                            return text.str();
                          },
                          communicator);

      std::ostringstream entry;
      entry.precision(n_digits);
      entry << "<DataSet timestep=\"" << time << "\" name=\"" << name << "\" file=\"" << file
            << "\"/>\n";
      return entry.str();
    }

    /** Writes the data as HDF5 and returns their entry in the list. Collective. */
    template <int dim, int spacedim>
    std::string write_hdf5(const DataOutInterface<dim, spacedim> &data_out,
                           const OutputFolder &folder, const std::string &file,
                           const std::string &name, const double time, const MPI_Comm communicator)
    {
      // Points of one place stay apart: pressure and cell-wise data jump there.
      DataOutBase::DataOutFilter filter(DataOutBase::DataOutFilterFlags(false, true));
      data_out.write_filtered_data(filter);
      data_out.write_hdf5_parallel(filter, folder.add(file), communicator);
      run_on_root(communicator, [&]() { synchronise(folder.path(file)); });

      std::string entry = compatibility::get_xdmf_content<dim>(
          data_out.create_xdmf_entry(filter, file, time, communicator));
      if (const auto position = entry.find("\"mesh\""); position != std::string::npos)
        entry.replace(position, 6, "\"" + name + "\""); // the block's name
      return entry;
    }
  } // namespace

  void OutputParameters::add_folder_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Output");
    prm.add_parameter("Folder", folder,
                      "Folder of the results. It is created; a folder with files that Caudal has "
                      "not written is refused.");
    prm.add_parameter("Existing results", existing_results,
                      "What becomes of the results of an earlier run in the folder. number: they "
                      "are kept as <folder>.1, .2 and so on, unless the run can be resumed, for "
                      "which the new one is refused; replace: they are removed; refuse: the new "
                      "run is refused.",
                      Patterns::Selection("number|replace|refuse"));
    prm.leave_subsection();
  }

  void OutputParameters::add_parameters(ParameterHandler &prm)
  {
    add_folder_parameters(prm);
    prm.enter_subsection("Output");
    prm.add_parameter("Interval of fields", field_interval,
                      "Simulated time between two outputs of the fields [s]; 0: every step.");
    prm.add_parameter("Interval of statistics", statistics_interval,
                      "Steps between two rows of statistics.txt [1].", Patterns::Integer(1));
    prm.add_parameter("Format", format,
                      "File format of the fields. vtu: open solution.pvd in ParaView; "
                      "hdf5: open solution.xdmf.",
                      Patterns::Selection("vtu|hdf5"));
    prm.add_parameter("Subdivisions", n_subdivisions,
                      "Each cell of the fluid is drawn as this many cells in each direction: its "
                      "velocity is quadratic [1].",
                      Patterns::Integer(1, 8));
    prm.leave_subsection();
  }

  void OutputParameters::check() const
  {
    AssertThrow(!folder.empty(), ExcMessage("Output/Folder: the name is empty. Give a folder."));
    check_not_negative("Output/Interval of fields", field_interval,
                       "Give a positive time [s], or 0 for every step.");
#ifndef DEAL_II_WITH_HDF5
    AssertThrow(format != "hdf5",
                ExcMessage("Output/Format: the deal.II of this program was built without HDF5, "
                           "so that it can't write hdf5. Choose vtu."));
#endif
  }

  ExistingResults OutputParameters::get_existing_results() const
  {
    return existing_results == "replace"  ? ExistingResults::replace
           : existing_results == "refuse" ? ExistingResults::refuse
                                          : ExistingResults::number;
  }

  FieldOutput::FieldOutput(const OutputFolder &folder, const std::string &format,
                           const MPI_Comm communicator, const Series &series,
                           const std::string &list)
      : folder(folder)
      , is_vtu(format == "vtu")
      , communicator(communicator)
      , list(list)
      , series(series)
  {
    run_on_root(communicator, [&]() {
      std::filesystem::create_directories(folder.path("fields"));
      write_list();
    });
  }

  std::vector<std::string> FieldOutput::find_missing_files() const
  {
    std::vector<std::string> sentences;
    static const std::regex  file_name("fields/[^\"<>:]+\\.(vtu|h5)");
    for (const auto &[time, entries] : series)
      for (const auto &[name, entry] : entries)
      {
        std::smatch match;
        if (std::regex_search(entry, match, file_name) &&
            (!std::filesystem::exists(folder.path(match.str())) ||
             std::filesystem::file_size(folder.path(match.str())) == 0))
          sentences.push_back("<" + match.str() +
                              "> is missing or empty, which holds the fields of " + name +
                              " at t = " + std::to_string(time) + " s.");
      }
    return Utilities::MPI::broadcast(communicator, sentences);
  }

  template <int dim, int spacedim>
  void FieldOutput::write(DataOutInterface<dim, spacedim> &data_out, const std::string &name,
                          const double time, const unsigned int counter,
                          const MPI_Comm field_communicator)
  {
    std::string entry;
    const auto  write_data = [&]() {
      const std::string file = "fields/" + name + "-" + Utilities::int_to_string(counter, 5);
      entry = is_vtu ? write_vtu(data_out, folder, file + ".vtu", name, time, counter,
                                  field_communicator)
                      : write_hdf5(data_out, folder, file + ".h5", name, time, field_communicator);
    };
    const std::string error = catch_error([&]() {
      if (Utilities::MPI::n_mpi_processes(field_communicator) == 1)
        run_on_root(communicator, write_data);
      else
        run_on_all(communicator, write_data);
      run_on_root(communicator, [&]() {
        series[time][name] = entry;
        write_list();
      });
    });
    AssertThrow(error.empty(), ExcMessage("The fields can't be written any more: " + error +
                                          ". Make room or give access, then go on by caudal "
                                          "--resume " +
                                          folder.path() + "."));
  }

  std::string FieldOutput::get_list_name() const
  {
    return list + (is_vtu ? ".pvd" : ".xdmf");
  }

  void FieldOutput::write_list() const
  {
    std::ostringstream out;
    out.precision(n_digits);
    out << "<?xml version=\"1.0\"?>\n"
        << (is_vtu
                ? "<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n"
                : "<Xdmf Version=\"2.0\">\n<Domain>\n"
                  "<Grid Name=\"Caudal\" GridType=\"Collection\" CollectionType=\"Temporal\">\n");
    for (const auto &[time, entries] : series)
    {
      if (!is_vtu)
        out << "<Grid Name=\"fields\" GridType=\"Collection\" CollectionType=\"Spatial\">\n"
            << "<Time Value=\"" << time << "\"/>\n";
      for (const auto &[name, entry] : entries)
        out << entry;
      if (!is_vtu)
        out << "</Grid>\n";
    }
    out << (is_vtu ? "</Collection>\n</VTKFile>\n" : "</Grid>\n</Domain>\n</Xdmf>\n");
    replace_file(folder.add(get_list_name()), out.str());
  }

  template void FieldOutput::write(DataOutInterface<2> &, const std::string &, double, unsigned int,
                                   MPI_Comm);
  template void FieldOutput::write(DataOutInterface<3> &, const std::string &, double, unsigned int,
                                   MPI_Comm);
  template void FieldOutput::write(DataOutInterface<1, 2> &, const std::string &, double,
                                   unsigned int, MPI_Comm);
  template void FieldOutput::write(DataOutInterface<2, 3> &, const std::string &, double,
                                   unsigned int, MPI_Comm);
} // namespace caudal
