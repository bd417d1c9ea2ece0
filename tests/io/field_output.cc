// SPDX-License-Identifier: LGPL-2.1-or-later
// Fields of a distributed mesh and of a body that each rank has, in both
// formats: the list that ParaView opens, and its continuation in a resumed run.

#include <caudal/base/compatibility.h>
#include <caudal/io/field_output.h>

#include <deal.II/base/function_lib.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/numerics/data_out.h>
#include <deal.II/numerics/vector_tools.h>

#include <filesystem>
#include <fstream>
#include <iostream>

using namespace dealii;
using namespace caudal;

namespace
{
  void write_unit_square(FieldOutput &output, const std::string &name, const Triangulation<2> &mesh,
                         const double time, const unsigned int counter)
  {
    const FE_Q<2> element(1);
    DoFHandler<2> dof_handler(mesh);
    dof_handler.distribute_dofs(element);
    LinearAlgebra::distributed::Vector<double> values(
        dof_handler.locally_owned_dofs(), DoFTools::extract_locally_relevant_dofs(dof_handler),
        compatibility::get_communicator(mesh));
    VectorTools::interpolate(dof_handler, Functions::SquareFunction<2>(), values);
    values.update_ghost_values();

    DataOut<2> data_out;
    data_out.attach_dof_handler(dof_handler);
    data_out.add_data_vector(values, "pressure");
    data_out.build_patches();
    output.write(data_out, name, time, counter, compatibility::get_communicator(mesh));
  }
} // namespace

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const bool                       is_root = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;

  parallel::distributed::Triangulation<2> fluid(MPI_COMM_WORLD);
  GridGenerator::hyper_cube(fluid);
  fluid.refine_global(3);
  Triangulation<2> fish;
  GridGenerator::hyper_cube(fish, 0.4, 0.6);

  for (const std::string format : {"vtu", "hdf5"})
  {
    const std::string folder = "fields_" + format;
    // Goes on with a series, and returns what it was after the second time.
    const auto write_times = [&](const FieldOutput::Series       &series,
                                 const std::vector<unsigned int> &counters) {
      const OutputFolder  results(folder, MPI_COMM_WORLD,
                                 counters[0] == 0 ? OutputFolder::Start::fresh
                                                   : OutputFolder::Start::resume);
      FieldOutput         output(results, format, MPI_COMM_WORLD, series);
      FieldOutput::Series result;
      for (const unsigned int counter : counters)
      {
        write_unit_square(output, "fluid", fluid, 0.1 * counter, counter);
        write_unit_square(output, "fish", fish, 0.1 * counter, counter);
        if (counter == 1)
          result = output.get_series();
      }
      return result;
    };
    write_times(write_times({}, {0, 1, 2}), {3});

    if (is_root)
    {
      std::ifstream in(folder + (format == "vtu" ? "/solution.pvd" : "/solution.xdmf"));
      std::cout << in.rdbuf();
      for (const std::string name : {"fluid-00003", "fish-00003"})
      {
        const std::string ending = format == "vtu" ? ".vtu" : ".h5";
        std::cout << name
                  << (std::filesystem::exists(folder + "/fields/" + name + ending)
                          ? " exists\n"
                          : " is missing\n");
      }
      std::filesystem::remove_all(folder);
    }
  }
}
