// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "adaptive_localization/core/pose2.hpp"

namespace adaptive_localization {

/// Why a match tells nothing. Not known from where to match: the guess is not finite, or none.
/// Where walls are so thick that hits slide in them, a cloud tells instead: no refusal.
enum class MatchFault { kNone, kNoGuess, kFewHits, kOutliers, kSingular, kJump, kSlides };
std::string toText(MatchFault fault);
bool isRefusal(MatchFault fault);

/// A scan aligned with the map: the pose, and what the scan tells of it. Each row h of H is a
/// direction over (x, y, theta) of which it tells something: h . (pose - true pose) + rest has that
/// row's variance, and rows do not depend on each other. Fewer than three rows along a corridor.
struct Match {
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, 3, 0, 3, 3>;
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1>;
  using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3>;

  Pose2 T_map_base;
  Rows H{0, 3};
  Vector variance{0};
  Vector rest{0};  // how much further the scan would go without the prior; about 0 without one
  double mean_distance{0.0};  // m, of the hits that fit
  double inlier_ratio{0.0};   // share of the hits that fit
  int iterations{0};
  std::vector<std::uint8_t> fits;  // of each hit of the scan
  MatchFault fault{MatchFault::kNone};

  bool isGood() const { return fault == MatchFault::kNone; }

  /// H^T diag(1 / variance) H; singular where there are fewer than three rows.
  Eigen::Matrix3d information() const;
};

}  // namespace adaptive_localization
