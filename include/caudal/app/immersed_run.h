#ifndef caudal_app_immersed_run_h
#define caudal_app_immersed_run_h

#include <caudal/app/immersed_swimmer.h>

namespace caudal
{
  /** A case of the immersed swimmer as its parameter file describes it. */
  template <int dim>
  class ImmersedRun
  {
  public:
    /** Reads and checks all parameters. */
    ImmersedRun(const ParameterFile &file, MPI_Comm communicator);

    /** Says what the case is like; a fast check makes no trial steps. Writes nothing. */
    void check(std::ostream &out, bool fast) const;

    /** Runs the case in its folder, from the start. */
    Outcome start(const std::function<bool()> &stop_requested) const;

    /** Goes on in its folder from the newest whole checkpoint. */
    Outcome resume(const std::function<bool()> &stop_requested) const;

    RunParameters<dim> parameters;

  private:
    const ParameterFile &file;
    const MPI_Comm       communicator;
    ParameterValues      values;
    std::string          text; // of all parameters

    Outcome run(ImmersedSwimmer<dim> &swimmer, OutputFolder::Start start,
                const std::vector<std::string> &messages,
                const std::function<bool()>    &stop_requested) const;
  };
} // namespace caudal

#endif
