// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_passage_answers_h
#define caudal_passage_answers_h

#include <caudal/passage/passage_parameters.h>
#include <caudal/passage/verdict.h>

namespace caudal::passage
{
  /** All answers of a run. */
  struct Answers
  {
    std::vector<Verdict>      verdicts; // by discharge
    std::vector<DesignAnswer> designs;  // likewise, if they are asked for
    std::vector<BatchAnswer>  batch;
  };

  Answers compute_answers(const PassageParameters &parameters);

  /** What holds and what does not: sentences for every place where answers are told. */
  const std::vector<std::string> &get_limits();
} // namespace caudal::passage

#endif
