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

  /** All answers in words. */
  std::string print_text(const PassageParameters &parameters, const Answers &answers);

  /** A row of numbers for each discharge. */
  std::string print_summary(const PassageParameters &parameters, const Answers &answers);

  /** The ways of the fish of all bands at all discharges, place by place. */
  std::string print_ways(const Answers &answers);

  /** A row for each fish and discharge of the batch. */
  std::string print_batch(const Answers &answers);

  /** Everything for other programs and the report. */
  std::string print_json(const PassageParameters &parameters, const Answers &answers);
} // namespace caudal::passage

#endif
