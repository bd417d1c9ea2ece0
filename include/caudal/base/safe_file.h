// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_base_safe_file_h
#define caudal_base_safe_file_h

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

namespace caudal
{
  /**
   * Writes a file and waits until the disk has it. Throws std::runtime_error
   * with the system's reason: disk full, no right to write.
   */
  void write_whole_file(const std::filesystem::path &path, const std::string &text);

  /** A file that is written part by part. Throws likewise. */
  class SafeFile
  {
  public:
    /** Empties the file if it is there. */
    explicit SafeFile(const std::filesystem::path &path);
    ~SafeFile();

    void write(const char *begin, std::size_t n);

    /** Waits until the disk has all. */
    void finish();

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation;
  };

  /** Replaces the whole file or, if that fails, leaves the old one. Throws likewise. */
  void replace_file(const std::filesystem::path &path, const std::string &text);

  /** Appends to the file, which may not exist yet. Throws likewise. */
  void append_to_file(const std::filesystem::path &path, const std::string &text);

  /** Waits until the disk has the file, or the names in this folder. */
  void synchronise(const std::filesystem::path &path);

  /**
   * Everything in a file. Throws likewise; so it does if the system can't read some of it, and for
   * what is no file: a folder, a device or a pipe.
   */
  std::string read_whole_file(const std::filesystem::path &path);

  /**
   * The text in a file, as editors and spreadsheets of all systems write it: without the mark of
   * its byte order, with one kind of line ends, blanks and minus signs. Throws likewise.
   */
  std::string read_text_file(const std::filesystem::path &path);

  /** The CRC-32 sum of a text, in hexadecimal digits. */
  std::string compute_checksum(const std::string &text);

  /** The place of the first byte that is not part of UTF-8 text; npos if there is none. */
  std::size_t find_invalid_utf8(const std::string &text);

  /** Runs @p action; the reason why the system refused it, "" if it did not. */
  std::string catch_file_error(const std::function<void()> &action);
} // namespace caudal

#endif
