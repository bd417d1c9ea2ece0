// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_app_resume_h
#define caudal_app_resume_h

#include <caudal/base/declared_parameters.h>

namespace caudal
{
  /**
   * What has changed since the parameters @p before: "Time/End time: 5 before, now 7". Throws
   * if one of them can't change in the middle of a run: @p fixed is a regular expression for
   * these entries.
   */
  std::vector<std::string> compare_parameters(const ParameterValues &before,
                                              const ParameterValues &now, const std::string &fixed);
} // namespace caudal

#endif
