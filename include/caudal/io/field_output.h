// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_io_field_output_h
#define caudal_io_field_output_h

#include <deal.II/base/data_out_base.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>

#include <map>
#include <string>

namespace caudal
{
  /** Section `Output` of the .prm. */
  struct OutputParameters
  {
    std::string  folder              = "output";
    double       field_interval      = 0.02;
    unsigned int statistics_interval = 1;
    std::string  format              = "vtu"; // or "hdf5"
    unsigned int n_subdivisions      = 1;

    void add_parameters(dealii::ParameterHandler &prm);
    void check() const;
  };

  /**
   * Writes the fields of a run so that ParaView opens all of them as one
   * series in time: solution.pvd (or solution.xdmf for HDF5) with one block for the
   * fluid and one for each body, and the data themselves in fields/. The list
   * is replaced at every write, after the data it points to are complete.
   */
  class FieldOutput
  {
  public:
    /**
     * @p folder exists; the @p format is that of OutputParameters. A resumed run keeps what was
     * written up to @p resume_time [s]. Collective.
     */
    FieldOutput(const std::string &folder, const std::string &format, MPI_Comm communicator,
                double resume_time = -1.);

    /** Takes what was written of the block @p name after @p time [s] from the list. Collective. */
    void remove_after(const std::string &name, double time);

    /**
     * Writes one field: @p name is its block's name ("fluid", "fish"), @p time is in s
     * and @p counter numbers the files. @p field_communicator is that of the field's
     * triangulation: MPI_COMM_SELF for a body that is replicated on all ranks, of
     * which rank 0 alone writes its copy. Collective.
     */
    template <int dim, int spacedim>
    void write(dealii::DataOutInterface<dim, spacedim> &data_out, const std::string &name,
               double time, unsigned int counter, MPI_Comm field_communicator);

  private:
    /** At one time: the entries of the list by the names of their blocks. */
    using Entries = std::map<std::string, std::string>;

    void        read_list(double latest_time);
    void        write_list() const;
    std::string get_list_name() const;

    const std::string folder;
    const bool        is_vtu; // one compressed .vtu per field and time; else one .h5
    const MPI_Comm    communicator;

    std::map<double, Entries> series; // by time as it is listed [s]
  };
} // namespace caudal

#endif
