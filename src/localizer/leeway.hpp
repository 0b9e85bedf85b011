// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "adaptive_localization/core/belief.hpp"
#include "core/gate.hpp"
#include "ser/place.hpp"

namespace adaptive_localization {

/// How far off the known place can be: where the core has it, by odometry once the core is
/// elsewhere, with what the core did not know of it. A robot that drives where little is to be seen
/// can be anywhere in its core's cloud, and where the cloud shrinks to, there it is.
class Leeway {
 public:
  void end() { belief_.reset(); }

  void ride(const Pose2& motion) {
    if (belief_) belief_->mean = belief_->mean * motion;
  }

  /// Takes note of the core's estimate, of a place that is known or may be one of several: then
  /// what was not known of it before may be so still.
  void note(const Estimate& estimate, bool is_known) {
    const bool is_wider = !belief_ || estimate.covariance.trace() > belief_->covariance.trace();
    if (belief_ && !isAt(estimate.T_map_base)) return;
    moveTo(estimate.T_map_base);
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
