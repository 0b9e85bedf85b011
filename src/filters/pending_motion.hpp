// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "adaptive_localization/core/pose2.hpp"

namespace adaptive_localization {

/// What is left to move of the motion since the last update that did not throw: one that threw may
/// have moved the belief before, and is made again with the next scan.
class PendingMotion {
 public:
  /// T_now_current, where the belief is now.
  Pose2 rest(const Pose2& motion) const { return moved_ ? between(*moved_, motion) : motion; }

  /// The belief has moved so far.
  void move(const Pose2& motion) { moved_ = motion; }

  /// The update is made, or the filter starts anew.
  void finish() { moved_.reset(); }

 private:
  std::optional<Pose2> moved_;
};

}  // namespace adaptive_localization
