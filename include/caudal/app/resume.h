#ifndef caudal_app_resume_h
#define caudal_app_resume_h

#include <caudal/app/run_state.h>

namespace caudal
{
  /**
   * What has changed since the parameters @p before: "Time/End time: 5 before, now 7". Throws
   * if one of them can't change in the middle of a run.
   */
  std::vector<std::string> compare_parameters(const ParameterValues &before,
                                              const ParameterValues &now);
} // namespace caudal

#endif
