// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <string>

namespace adaptive_localization {

/// Confidence and status of the last two minutes in ROS time, thinned for a plot: of each quarter
/// of a second the least confidence, and each change of the status.
class ConfidenceHistory {
 public:
  static constexpr double kSpan = 120.0;  // s

  struct Sample {
    double stamp{0.0};       // s
    double confidence{0.0};  // 0 to 1
    std::string status;
  };

  /// What is more than a second older than the newest tells that time jumped back, and what was
  /// known is dropped; what is a little older, as with two lasers, is left out.
  void add(const Sample& sample);

  /// Oldest first.
  const std::deque<Sample>& samples() const { return samples_; }

  /// For how long the status has been what it is, s. Zero without samples.
  double secondsInStatus() const;

 private:
  std::deque<Sample> samples_;
  double newest_{0.0};        // s
  double status_since_{0.0};  // s
};

}  // namespace adaptive_localization
