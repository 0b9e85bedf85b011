// SPDX-License-Identifier: BSD-3-Clause
#include "scan_tracker.hpp"

#include <Eigen/LU>

namespace adaptive_localization {

Match ScanTracker::matchAt(const Pose2& T_map_base, const Scan& scan) const {
  const Eigen::Matrix3d prior = kalman_.covariance().inverse();
  return match_(T_map_base, scan, prior.allFinite() ? prior : Eigen::Matrix3d::Zero());
}

bool ScanTracker::correct(Match& match, const MatchGate& gate) {
  if (!match.isGood()) return false;
  if (gate(match) && kalman_.correct(observationOf(kalman_.mean(), match))) return true;
  match.fault = MatchFault::kJump;
  return false;
}

}  // namespace adaptive_localization
