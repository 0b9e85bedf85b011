// SPDX-License-Identifier: BSD-3-Clause
#include "occlusion.hpp"

#include <cstdint>
#include <utility>
#include <vector>

namespace adaptive_localization {
namespace {

constexpr double kOnWall = 0.1;  // m, from the map: a hit nearer agrees with it,
constexpr double kOff = 0.15;    // m: one farther, and so much before the wall, hides it
constexpr double kMostFits = 0.5;

Scan withHits(const Scan& scan, const std::vector<Eigen::Index>& hits) {
  Scan some = scan;
  const auto count = static_cast<Eigen::Index>(hits.size());
  for (Eigen::ArrayXf* row : {&some.x, &some.y, &some.range, &some.bearing}) {
    for (Eigen::Index k = 0; k < count; ++k) (*row)[k] = (*row)[hits[static_cast<std::size_t>(k)]];
    row->conservativeResize(count);
  }
  return some;
}

}  // namespace

bool seesNothing(const Scan& scan) {
  constexpr double kStray = 0.02;  // of the beams
  const auto no_returns = static_cast<double>(scan.no_return_bearing.size());
  return no_returns > 0.0 && scan.hits() <= kStray * (scan.hits() + no_returns);
}

bool isCovered(const Scan& scan) {
  if (scan.hits() == 0 || seesNothing(scan)) return true;
  constexpr double kArm = 0.6;    // m
  constexpr double kShare = 0.1;  // of the beams
  const Eigen::Index far =
      (scan.range > static_cast<float>(kArm)).count() + scan.no_return_bearing.size();
  const Eigen::Index beams = scan.range.size() + scan.no_return_bearing.size();
  return static_cast<double>(far) < kShare * static_cast<double>(beams);
}

bool areTooShort(const Scan& scan, const Pose2& T_map_base, const RangeError& range_error) {
  constexpr double kShortShare = 0.7;
  return range_error.at(T_map_base, scan).short_share > kShortShare;
}

Scan withoutObstacles(const Scan& scan, const Pose2& T_map_base, const DistanceField& field,
                      const RangeError& range_error) {
  const Transform2 to_map(T_map_base);
  std::vector<Eigen::Index> left;
  left.reserve(static_cast<std::size_t>(scan.x.size()));
  int fitting = 0;
  for (Eigen::Index i = 0; i < scan.x.size(); ++i) {
    const double off = field.at(to_map * Eigen::Vector2d(scan.x[i], scan.y[i]));
    fitting += off < kOnWall ? 1 : 0;
    const bool is_obstacle = off > kOff && range_error.missing(T_map_base, scan, i) > kOff;
    if (!is_obstacle) left.push_back(i);
  }
  const bool is_on_map = fitting > kMostFits * scan.hits();
  return is_on_map && static_cast<int>(left.size()) < scan.hits() ? withHits(scan, left) : scan;
}

Match ofWholeScan(Match match, const Scan& left, const Scan& all) {
  const auto matched = static_cast<Eigen::Index>(match.fits.size());
  if (matched != left.hits() || matched == all.hits()) return match;
  std::vector<std::uint8_t> fits(static_cast<std::size_t>(all.hits()), 0);
  for (Eigen::Index i = 0, k = 0; i < all.hits() && k < left.hits(); ++i) {
    if (left.bearing[k] != all.bearing[i] || left.range[k] != all.range[i]) continue;
    fits[static_cast<std::size_t>(i)] = match.fits[static_cast<std::size_t>(k++)];
  }
  match.fits = std::move(fits);
  match.inlier_ratio *= static_cast<double>(left.hits()) / all.hits();
  return match;
}

}  // namespace adaptive_localization
