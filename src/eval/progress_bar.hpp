// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace adaptive_localization {

/// A bar on stderr for work that takes more than two seconds; silent where stderr is no terminal.
class ProgressBar {
 public:
  /// The unit is what is counted: "scans".
  ProgressBar(std::size_t total, bool is_wanted, std::string unit = "scans");
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(std::size_t done);

 private:
  std::size_t total_;
  bool is_wanted_;
  std::string unit_;
  bool is_drawn_{false};
  std::chrono::steady_clock::time_point start_, last_;
};

}  // namespace adaptive_localization
