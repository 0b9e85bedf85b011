// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ctime>

namespace adaptive_localization {

/// Measures from its making on: time as on the wall, or that of the processor, of all threads
/// (CLOCK_PROCESS_CPUTIME_ID) or this one (CLOCK_THREAD_CPUTIME_ID).
class Stopwatch {
 public:
  explicit Stopwatch(clockid_t clock = CLOCK_MONOTONIC) : clock_(clock), start_(now()) {}

  double seconds() const { return now() - start_; }
  double milliseconds() const { return 1e3 * seconds(); }

 private:
  double now() const {
    timespec time{};
    clock_gettime(clock_, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }

  clockid_t clock_;
  double start_;
};

}  // namespace adaptive_localization
