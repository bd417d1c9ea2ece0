// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/io/safe_file.h>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
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

      void check(const bool good, const char *const what) const
      {
        if (!good)
          throw std::runtime_error("<" + path.string() + "> can't be " + what + ": " +
                                   std::strerror(errno));
      }

      const std::filesystem::path &path;
      const int                    descriptor;
    };
  } // namespace

  void write_whole_file(const std::filesystem::path &path, const std::string &text)
  {
    const File file(path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC);
    for (std::size_t written = 0; written < text.size();)
    {
      const ssize_t n = write(file.descriptor, text.data() + written, text.size() - written);
      if (n < 0 && errno == EINTR)
        continue;
      file.check(n > 0, "written");
      written += n;
    }
    file.check(fsync(file.descriptor) == 0, "written");
  }

  void replace_file(const std::filesystem::path &path, const std::string &text)
  {
    const std::filesystem::path temporary = path.string() + ".tmp";
    write_whole_file(temporary, text);
    std::filesystem::rename(temporary, path);
  }

  void synchronise(const std::filesystem::path &folder)
  {
    const File file(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    // Some file systems can't do it for folders, which is no error.
    file.check(fsync(file.descriptor) == 0 || errno == EINVAL, "synchronised");
  }

  std::string read_whole_file(const std::filesystem::path &path)
  {
    std::ifstream      file(path, std::ios::binary);
    std::ostringstream text;
    if (file && !std::filesystem::is_directory(path))
      text << file.rdbuf();
    if (!file)
      throw std::runtime_error("<" + path.filename().string() + "> is missing or can't be read");
    return text.str();
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
