// SPDX-License-Identifier: BSD-3-Clause
#include "core/whole_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <system_error>

namespace adaptive_localization {
namespace {

namespace fs = std::filesystem;

/// Whether all was written, and is on the disk; errno tells why not.
bool write(const std::string& path, const std::string& contents, bool is_file) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (file < 0) return false;
  const char* left = contents.data();
  const char* end = left + contents.size();
  bool is_written = true;
  while (is_written && left < end) {
    const ssize_t count = ::write(file, left, static_cast<std::size_t>(end - left));
    is_written = count > 0 || (count < 0 && errno == EINTR);
    if (count > 0) left += count;
  }
  is_written = is_written && (!is_file || ::fsync(file) == 0);
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
  const std::string part = is_file ? target + ".part" : target;
  const bool is_written = write(part, contents, is_file) &&
                          (!is_file || std::rename(part.c_str(), target.c_str()) == 0);
  if (is_written) return;
  const std::string reason = std::generic_category().message(errno);
  if (is_file) ::unlink(part.c_str());
  throw std::runtime_error("file '" + file + "' cannot be written: " + reason);
}

}  // namespace adaptive_localization
