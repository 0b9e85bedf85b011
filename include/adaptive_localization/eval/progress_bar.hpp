// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstddef>

namespace adaptive_localization {

/// A bar on stderr for work that takes more than two seconds; silent where stderr is no terminal.
class ProgressBar {
 public:
  ProgressBar(std::size_t total, bool is_wanted);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(std::size_t done);

 private:
  std::size_t total_;
  bool is_wanted_;
  bool is_drawn_{false};
  std::chrono::steady_clock::time_point start_, last_;
};

}  // namespace adaptive_localization
