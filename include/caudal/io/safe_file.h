// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_io_safe_file_h
#define caudal_io_safe_file_h

#include <filesystem>
#include <functional>
#include <string>

namespace caudal
{
  /**
   * Writes a file and waits until the disk has it. Throws std::runtime_error
   * with the system's reason: disk full, no right to write.
   */
  void write_whole_file(const std::filesystem::path &path, const std::string &text);

  /** Replaces the whole file or, if that fails, leaves the old one. Throws likewise. */
  void replace_file(const std::filesystem::path &path, const std::string &text);

  /** Waits until the disk has the names in this folder. */
  void synchronise(const std::filesystem::path &folder);

  /** Everything in a file. Throws likewise. */
  std::string read_whole_file(const std::filesystem::path &path);

  /** Runs @p action; the reason why the system refused it, "" if it did not. */
  std::string catch_file_error(const std::function<void()> &action);
} // namespace caudal

#endif
