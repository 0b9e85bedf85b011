// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <cstdio>
#include <functional>
#include <string>

namespace adaptive_localization {

/// A process that does what may crash, and sends what comes of it. It has 2 GB of memory and a
/// minute of the processor from one beat of its heart to the next; then it is ended.
class ChildProcess {
 public:
  /// Starts the work, which writes what it has to send. Best before there are other threads: it has
  /// none of them, but the locks that they hold. Throws std::runtime_error if that cannot be.
  explicit ChildProcess(const std::function<void(std::FILE*)>& work);

  /// Ends it, if it has not ended.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// To be called by the work now and then: it gets on.
  static void beat();

  /// Waits for so many bytes of what it sends. False: there are no more.
  bool read(void* data, std::size_t size);

  /// Ends it, if it has not ended, and says what its end was: of which signal it died, say.
  std::string end();

 private:
  pid_t process_;
  std::FILE* received_;
};

}  // namespace adaptive_localization
