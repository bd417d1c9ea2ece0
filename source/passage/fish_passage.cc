// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/collective.h>
#include <caudal/base/safe_file.h>
#include <caudal/passage/answer_output.h>
#include <caudal/passage/fish_passage.h>

namespace caudal
{
  using namespace passage;

  void FishPassage::start()
  {
    run_on_root(communicator, [&]() { answers = compute_answers(parameters); });
  }

  void FishPassage::check(std::ostream &out, bool /*fast*/) const
  {
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      out << print_text(parameters, answers) << "\nNo problems found.\n";
  }

  Outcome FishPassage::run(const OutputFolder &folder, Log &log,
                           const std::function<bool()> & /*stop_requested*/)
  {
    run_on_root(communicator, [&]() {
      const std::string text = print_text(parameters, answers);
      replace_file(folder.add("verdict.txt"), text);
      replace_file(folder.add("summary.csv"), print_summary(parameters, answers));
      replace_file(folder.add("way.csv"), print_ways(answers));
      if (!answers.batch.empty())
        replace_file(folder.add("batch.csv"), print_batch(answers));
      replace_file(folder.add("passage.json"), print_json(parameters, answers));
      log << '\n' << text;
    });
    log << "CPU of rank 0: " << timer.cpu_time() << " s." << std::endl;
    return Outcome::finished;
  }
} // namespace caudal
