// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

namespace adaptive_localization {

/// Whether a laser sees the faces of thick walls or what is in their middles, as scans tell one by
/// one: walls painted from a plan have faces where a laser sees them, those made of scans laid over
/// each other inexactly do not.
class WallVote {
 public:
  /// What one scan tells, -1 to 1: above 0 for the middles.
  void add(double evidence) {
    constexpr double kMost = 20.0;  // so that it can change its mind
    lead_ += std::min(1.0, std::max(-1.0, evidence));
    lead_ = std::min(kMost, std::max(-kMost, lead_));
  }

  /// Above 0 for the middles.
  double leadOfMiddles() const { return lead_; }

 private:
  double lead_{0.0};
};

}  // namespace adaptive_localization
