// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_app_case_name_h
#define caudal_app_case_name_h

#include <string>

namespace caudal
{
  /**
   * Throws a sentence if @p file is no file but the name of a case without its folder or ending, or
   * the folder of a run: what was meant. Other mistakes are left to who reads the file.
   */
  void check_case_name(const std::string &file);
} // namespace caudal

#endif
