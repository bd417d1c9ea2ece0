// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/passage/answers.h>

namespace caudal::passage
{
  Answers compute_answers(const PassageParameters &parameters)
  {
    const Question question  = parameters.get_question();
    const auto     waterways = parameters.way.make_waterways();
    Answers        answers;
    for (const Waterway &waterway : waterways)
    {
      answers.verdicts.push_back(compute_verdict(question, parameters.power.get(), waterway));
      if (parameters.design.is_asked_for())
        answers.designs.push_back(
            solve_design(parameters.design, question, parameters.way, waterway));
    }
    if (parameters.batch.is_asked_for())
      answers.batch = answer_batch(parameters.batch, question, waterways);
    return answers;
  }

  const std::vector<std::string> &get_limits()
  {
    static const std::vector<std::string> limits{
        "Swimming ability only: whether fish find the entrance (attraction) and want to go "
        "(motivation) is left out.",
        "Endurance is that of the law's data: 3 to 1800 s unless it says otherwise, for the "
        "lengths "
        "that it names. Answers beyond are extrapolated, and marked.",
        "Temperature, oxygen, light, health and earlier efforts of the fish are not included.",
        "Fatigue is taken to add up linearly, whatever the order of fast and slow water.",
        "Turbulence, air and the route across the section are not included but by the velocity "
        "factor."};
    return limits;
  }
} // namespace caudal::passage
