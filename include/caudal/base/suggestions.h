// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_base_suggestions_h
#define caudal_base_suggestions_h

#include <caudal/base/declared_parameters.h>

#include <string>

namespace caudal
{
  /**
   * What may have been meant by the unknown entry @p name of @p section, within all that is
   * @p declared, and what is known there, as sentences. An entry of that name in another section
   * is meant rather than a similar one in this section.
   */
  std::string suggest_entry(const std::string &name, const DeclaredSection &section,
                            const DeclaredSection &declared);

  /** The same for a section @p name within @p section. */
  std::string suggest_section(const std::string &name, const DeclaredSection &section,
                              const DeclaredSection &declared);
} // namespace caudal

#endif
