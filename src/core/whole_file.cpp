// SPDX-License-Identifier: BSD-3-Clause
#include "core/whole_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <system_error>

namespace adaptive_localization {
namespace {

namespace fs = std::filesystem;

/// Opens a file for this process alone, waiting for others that write it: two nodes may have been
/// given one file. One that another process has renamed in the meantime is not it any more. Below
/// 0, and errno, where it cannot be opened.
int openAlone(const std::string& path) {
  for (;;) {
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0644);
    if (file < 0 || ::flock(file, LOCK_EX) != 0) return file;  // a file system without locks
    struct stat own {
    }, there{};
    const bool is_there = ::fstat(file, &own) == 0 && ::stat(path.c_str(), &there) == 0;
    if (is_there && own.st_ino == there.st_ino && own.st_dev == there.st_dev) return file;
    ::close(file);
  }
}

bool writeAll(int file, const std::string& contents) {
  const char* left = contents.data();
  const char* end = left + contents.size();
  while (left < end) {
    const ssize_t count = ::write(file, left, static_cast<std::size_t>(end - left));
    if (count == 0 || (count < 0 && errno != EINTR)) return false;
    if (count > 0) left += count;
  }
  return true;
}

/// Whether all was written, and is on the disk under its name; errno tells why not.
bool replace(const std::string& target, const std::string& contents) {
  const std::string part = target + ".part";
  const int file = openAlone(part);
  if (file < 0) return false;
  const bool is_done = ::ftruncate(file, 0) == 0 && writeAll(file, contents) &&
                       ::fsync(file) == 0 && std::rename(part.c_str(), target.c_str()) == 0;
  const int reason = errno;
  if (!is_done) ::unlink(part.c_str());
  ::close(file);  // others may write now
  errno = reason;
  return is_done;
}

/// The same of what is no file.
bool write(const std::string& path, const std::string& contents) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (file < 0) return false;
  const bool is_written = writeAll(file, contents);
  const int reason = errno;
  if (::close(file) != 0) return false;
  errno = reason;
  return is_written;
}

/// Links lead to the file that is written.
std::string targetOf(const std::string& file) {
  std::error_code error;
  const fs::path target = fs::canonical(file, error);
  return error ? file : target.string();
}

}  // namespace

void writeWholeFile(const std::string& file, const std::string& contents) {
  std::error_code error;
  const bool is_file = !fs::exists(file, error) || fs::is_regular_file(file, error);
  const std::string target = targetOf(file);
  if (is_file ? replace(target, contents) : write(target, contents)) return;
  const std::string reason = std::generic_category().message(errno);
  throw std::runtime_error("file '" + file + "' cannot be written: " + reason);
}

}  // namespace adaptive_localization
