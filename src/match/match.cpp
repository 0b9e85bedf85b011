// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/match/match.hpp"

namespace adaptive_localization {

std::string toText(MatchFault fault) {
  switch (fault) {
    case MatchFault::kNoGuess:
      return "not known from where to match";
    case MatchFault::kFewHits:
      return "too few hits";
    case MatchFault::kOutliers:
      return "too many hits are not of the map";
    case MatchFault::kSingular:
      return "the scan tells of no direction";
    case MatchFault::kJump:
      return "too far from where odometry says";
    case MatchFault::kSlides:
      return "left to a cloud: walls so thick that hits slide in them";
    default:
      return "none";
  }
}

bool isRefusal(MatchFault fault) {
  return fault != MatchFault::kNone && fault != MatchFault::kSlides;
}

Eigen::Matrix3d Match::information() const {
  return H.transpose() * variance.cwiseInverse().asDiagonal() * H;
}

}  // namespace adaptive_localization
