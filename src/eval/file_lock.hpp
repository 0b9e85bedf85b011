// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace adaptive_localization {

/// Keeps a file for one program alone, among those that lock it, until it is destroyed or the
/// program ends, however it does.
class FileLock {
 public:
  /// Makes the file if there is none. Throws std::invalid_argument saying why not: it cannot be
  /// written, another one has it.
  explicit FileLock(const std::string& file);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  int descriptor_;
};

}  // namespace adaptive_localization
