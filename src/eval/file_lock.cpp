// SPDX-License-Identifier: BSD-3-Clause
#include "file_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>

namespace adaptive_localization {
namespace {

/// What is no file, as /dev/stdout, is nobody's; nor can files be locked in every file system.
bool isTaken(int descriptor) {
  struct stat status {};
  const bool is_file = fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
  return is_file && flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
}

}  // namespace

FileLock::FileLock(const std::string& file)
    : descriptor_(open(file.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666)) {
  if (descriptor_ < 0) throw std::invalid_argument("cannot be written");
  if (!isTaken(descriptor_)) return;
  close(descriptor_);
  throw std::invalid_argument("is being written by another program");
}

FileLock::~FileLock() {
  close(descriptor_);
}

}  // namespace adaptive_localization
