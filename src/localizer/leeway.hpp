// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "adaptive_localization/core/belief.hpp"
#include "core/gate.hpp"
#include "ser/place.hpp"

namespace adaptive_localization {

/// How far off the known place can be: the core's estimate of it, or, once the core is elsewhere,
/// the last one carried on by odometry, with the core's covariance. A robot that drives where
/// little is to be seen can be anywhere in its core's cloud, and where the cloud shrinks to, there
/// it is.
class Leeway {
 public:
  void end() { belief_.reset(); }

  void ride(const Pose2& motion) {
    if (belief_) belief_->mean = belief_->mean * motion;
  }

  /// Takes note of the core's estimate, unless the core is elsewhere. As long as the place may be
  /// one of several, the widest covariance so far counts.
  void note(const Estimate& estimate, bool is_known) {
    if (belief_ && !isAt(estimate.T_map_base)) return;
    moveTo(estimate.T_map_base);
    const bool is_wider = estimate.covariance.trace() > belief_->covariance.trace();
    if (is_known || is_wider) belief_->covariance = estimate.covariance;
  }

  void moveTo(const Pose2& T_map_base) {
    if (!belief_) belief_.emplace();
    belief_->mean = T_map_base;
  }

  /// The place is there.
  bool isAt(const Pose2& T_map_base) const {
    return belief_ && areSamePlace(belief_->mean, T_map_base);
  }

  /// Or can be.
  bool allows(const Pose2& T_map_base) const { return belief_ && isWithin(*belief_, T_map_base); }

 private:
  std::optional<Gaussian2> belief_;
};

}  // namespace adaptive_localization
