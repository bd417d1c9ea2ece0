// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/safe_file.h>

#include <deal.II/base/utilities.h>

#include <boost/crc.hpp>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <iomanip>
#include <sstream>
#include <stdexcept>

namespace caudal
{
  namespace
  {
    /** An open file; what goes wrong throws the system's reason. */
    class File
    {
    public:
      File(const std::filesystem::path &path, const int flags)
          : path(path)
          , descriptor(open(path.c_str(), flags, 0666))
      {
        check(descriptor >= 0, "opened");
      }

      ~File()
      {
        if (descriptor >= 0)
          close(descriptor);
      }

      File(const File &)            = delete;
      File &operator=(const File &) = delete;

      void write_all(const char *const begin, const std::size_t size) const
      {
        for (std::size_t written = 0; written < size;)
        {
          const ssize_t n = ::write(descriptor, begin + written, size - written);
          if (n < 0 && errno == EINTR)
            continue;
          check(n > 0, "written");
          written += n;
        }
      }

      void check(const bool good, const char *const what) const
      {
        if (!good)
          throw std::runtime_error("<" + path.string() + "> can't be " + what + ": " +
                                   std::strerror(errno));
      }

      const std::filesystem::path path;
      const int                   descriptor;
    };
  } // namespace

  struct SafeFile::Implementation
  {
    explicit Implementation(const std::filesystem::path &path)
        : file(path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC)
    {}

    const File file;
  };

  SafeFile::SafeFile(const std::filesystem::path &path)
      : implementation(std::make_unique<Implementation>(path))
  {}

  SafeFile::~SafeFile() = default;

  void SafeFile::write(const char *const begin, const std::size_t n)
  {
    implementation->file.write_all(begin, n);
  }

  void SafeFile::finish()
  {
    const File &file = implementation->file;
    file.check(fsync(file.descriptor) == 0, "written");
  }

  void write_whole_file(const std::filesystem::path &path, const std::string &text)
  {
    SafeFile file(path);
    file.write(text.data(), text.size());
    file.finish();
  }

  void append_to_file(const std::filesystem::path &path, const std::string &text)
  {
    const File file(path, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC);
    file.write_all(text.data(), text.size());
  }

  void replace_file(const std::filesystem::path &path, const std::string &text)
  {
    const std::filesystem::path temporary = path.string() + ".tmp";
    write_whole_file(temporary, text);
    std::filesystem::rename(temporary, path);
  }

  void synchronise(const std::filesystem::path &path)
  {
    const File file(path, O_RDONLY | O_CLOEXEC);
    // Some file systems can't do it for folders, which is no error.
    file.check(fsync(file.descriptor) == 0 || errno == EINVAL, "synchronised");
  }

  std::string read_whole_file(const std::filesystem::path &path)
  {
    // Opening a pipe would wait for somebody to write to it.
    const File  file(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    struct stat properties;
    file.check(fstat(file.descriptor, &properties) == 0, "read");
    if (!S_ISREG(properties.st_mode))
      throw std::runtime_error("<" + path.string() + "> is no file but a folder, device or pipe");
    std::string text;
    char        buffer[1 << 16];
    for (;;)
    {
      const ssize_t n = read(file.descriptor, buffer, sizeof(buffer));
      if (n < 0 && errno == EINTR)
        continue;
      file.check(n >= 0, "read");
      if (n == 0)
        return text;
      text.append(buffer, n);
    }
  }

  std::size_t find_invalid_utf8(const std::string &text)
  {
    const auto continues = [&](const std::size_t i) {
      return i < text.size() && (text[i] & 0xC0) == 0x80;
    };
    for (std::size_t i = 0; i < text.size();)
    {
      const unsigned char first  = text[i];
      const std::size_t   length = first < 0x80                    ? 1
                                   : first >= 0xC2 && first < 0xE0 ? 2
                                   : first >= 0xE0 && first < 0xF0 ? 3
                                   : first >= 0xF0 && first < 0xF5 ? 4
                                                                   : 0;
      if (length == 0)
        return i;
      for (std::size_t k = 1; k < length; ++k)
        if (!continues(i + k))
          return i;
      i += length;
    }
    return std::string::npos;
  }

  std::string read_text_file(const std::filesystem::path &path)
  {
    const std::string byte_order_mark = "\xEF\xBB\xBF";
    std::string       text            = read_whole_file(path);
    const std::size_t invalid         = find_invalid_utf8(text);
    if (invalid != std::string::npos)
      throw std::runtime_error(
          "<" + path.string() + "> is no text in UTF-8 (line " +
          std::to_string(1 + std::count(text.begin(), text.begin() + invalid, '\n')) +
          "); save it in this encoding");
    if (text.rfind(byte_order_mark, 0) == 0)
      text.erase(0, byte_order_mark.size());
    for (const auto &[foreign, plain] :
         {std::pair("\r\n", "\n"), std::pair("\r", "\n"), std::pair("\xC2\xA0", " "),
          std::pair("\xE2\x80\xAF", " "), std::pair("\xE2\x88\x92", "-")})
      text = dealii::Utilities::replace_in_string(text, foreign, plain);
    return text;
  }

  std::string compute_checksum(const std::string &text)
  {
    boost::crc_32_type crc;
    crc.process_bytes(text.data(), text.size());
    std::ostringstream result;
    result << std::hex << std::setw(8) << std::setfill('0') << crc.checksum();
    return result.str();
  }

  std::string catch_file_error(const std::function<void()> &action)
  {
    try
    {
      action();
    }
    catch (const std::filesystem::filesystem_error &exception)
    {
      return exception.code().message();
    }
    catch (const std::runtime_error &exception)
    {
      return exception.what();
    }
    return "";
  }
} // namespace caudal
