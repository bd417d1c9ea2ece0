// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_base_outcome_h
#define caudal_base_outcome_h

namespace caudal
{
  /** How a run ended, if not by an error. */
  enum class Outcome
  {
    finished,
    stopped // on request
  };
} // namespace caudal

#endif
