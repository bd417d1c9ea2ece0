// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_passage_answer_output_h
#define caudal_passage_answer_output_h

#include <caudal/passage/answers.h>

namespace caudal::passage
{
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
