// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>

#include "adaptive_localization/core/belief.hpp"
#include "adaptive_localization/motion/motion_model.hpp"
#include "adaptive_localization/observation/composed_model.hpp"
#include "adaptive_localization/ser/ground.hpp"
#include "match/scan_matcher.hpp"
#include "match/scan_tracker.hpp"

namespace adaptive_localization {

/// Polishes a filter's estimates: a Kalman filter on odometry and matched scans (as ekf_icp) that
/// goes where the filter goes. It starts from an estimate, and starts anew from the filter's as
/// soon as that is too far from its own, or nothing was matched.
class EstimateRefiner {
 public:
  EstimateRefiner(MatchScan match, std::unique_ptr<MotionModel> motion, Senses senses = noSenses());

  /// What the filter says after it moved by odometry, motion = T_previous_current, and observed,
  /// with the matched pose and its covariance in place of its own. The same estimate where a cloud
  /// is wide and the match leaves much of the scan unexplained, as it may then be anything, unless
  /// it is where odometry lets expect it since matches that did explain a scan; and where the scan
  /// does not match nearby.
  Estimate refine(Estimate estimate, const Pose2& motion, const Observations& observations);

  /// Forgets where the filter was.
  void reset();

  /// How the last scan was aligned with the map; null if it was not tried.
  const Match* match() const { return match_ ? &*match_ : nullptr; }

 private:
  bool goesOnFrom(const Estimate& estimate, const Pose2& motion);

  ScanTracker tracker_;
  std::unique_ptr<MotionModel> motion_;
  Senses senses_;
  bool is_on_{false};          // was matched with the last scan
  bool has_explained_{false};  // most of a scan since it began
  std::optional<Match> match_;
};

/// By the options of matching and motion. Throws std::invalid_argument as makeScanMatcher() and
/// makeMotionModel().
std::unique_ptr<EstimateRefiner> makeEstimateRefiner(const Registry<MotionDescription>& motions,
                                                     const Parameters& given, const Ground& ground,
                                                     Senses senses);

}  // namespace adaptive_localization
