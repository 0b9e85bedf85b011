// SPDX-License-Identifier: BSD-3-Clause
#include "localizer/scan_change.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "occlusion.hpp"

namespace adaptive_localization {
namespace {

constexpr std::size_t kLasers = 4;
constexpr double kMostWay = 0.5, kMostTurn = 0.5;    // m, rad: from farther off too much is hidden
constexpr double kCompared = 0.33;                   // of the beams, at the least
constexpr double kChanged = 0.7, kEitherWay = 0.05;  // of those

/// How far the laser saw, by degrees of bearing in base; infinity where nothing is known.
class Panorama {
 public:
  Panorama() { range_.fill(kUnknown); }

  /// What lies between two points that were seen side by side is seen, too, unless one lies behind
  /// the other.
  void add(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    constexpr double kSurface = 0.5;  // m
    const double start = std::atan2(from.y(), from.x()), near = from.norm(), far = to.norm();
    const double turn = wrapAngle(std::atan2(to.y(), to.x()) - start);
    const bool is_surface = std::abs(far - near) < kSurface;
    const int steps = is_surface ? 1 + static_cast<int>(2.0 * std::abs(turn) / kBin) : 1;
    for (int i = 0; i < steps; ++i) {
      const double share = static_cast<double>(i) / steps;
      double& range = range_[indexOf(binOf(start + share * turn))];
      range = std::min(range, near + share * (far - near));
    }
  }

  /// By how much a beam is longer than all that is seen about it, m; shorter: negative. Nothing is
  /// known of it: infinity.
  double beyond(int bin, double range) const {
    double near = kUnknown, far = 0.0;
    for (int i = bin - kBeside; i <= bin + kBeside; ++i) {
      const double seen = range_[indexOf(i)];
      if (seen == kUnknown) continue;
      near = std::min(near, seen);
      far = std::max(far, seen);
    }
    if (near == kUnknown) return kUnknown;
    return range < near ? range - near : std::max(0.0, range - far);
  }

  static int binOf(double bearing) { return static_cast<int>(std::floor(bearing / kBin)); }

  static constexpr double kUnknown = std::numeric_limits<double>::infinity();

 private:
  static constexpr int kBins = 360, kBeside = 2;
  static constexpr double kBin = 2.0 * kPi / kBins;  // rad

  static std::size_t indexOf(int bin) {
    return static_cast<std::size_t>((bin % kBins + kBins) % kBins);
  }

  std::array<double, kBins> range_;
};

/// Calls `see` with the bearing and the range of each beam, at the most the laser's largest.
template <class See>
void forBeams(const Scan& scan, const See& see) {
  for (Eigen::Index i = 0; i < scan.range.size(); ++i) see(scan.bearing[i], scan.range[i]);
  for (Eigen::Index i = 0; i < scan.no_return_bearing.size(); ++i) {
    see(scan.no_return_bearing[i], scan.max_range);
  }
}

/// A scan as it would be seen after a motion.
Panorama panoramaOf(const Scan& scan, const Pose2& motion) {
  constexpr double kSideBySide = 0.06;  // rad
  const Pose2 T_now_before = inverse(motion);
  Panorama panorama;
  double last_bearing = -std::numeric_limits<double>::infinity();
  Eigen::Vector2d last;
  forBeams(scan, [&](double bearing, double range) {
    const Eigen::Vector2d beam = range * Eigen::Vector2d(std::cos(bearing), std::sin(bearing));
    const Eigen::Vector2d point =
        T_now_before * Eigen::Vector2d(scan.position + beam) - scan.position;
    panorama.add(point, point);
    if (std::abs(bearing - last_bearing) < kSideBySide) panorama.add(last, point);
    last = point;
    last_bearing = bearing;
  });
  return panorama;
}

/// Beams that could be compared, and those that are shorter or longer.
struct Comparison {
  int compared{0}, shorter{0}, longer{0};

  double changedShare() const { return static_cast<double>(shorter + longer) / compared; }
  double nearerShare() const { return static_cast<double>(shorter) / compared; }
  bool isOtherPlace() const {
    const int either_way = std::min(shorter, longer);
    return either_way > kEitherWay * compared &&
           shorter + longer + 2 * either_way > kChanged * compared;
  }
};

/// Of a scan turned by some bins; nothing if too little can be compared.
std::optional<Comparison> compare(const Panorama& before, const Scan& scan, int turn) {
  constexpr double kSame = 0.2, kSamePerMetre = 0.03;  // m
  int beams = 0;
  Comparison comparison;
  forBeams(scan, [&](double bearing, double range) {
    ++beams;
    const double beyond = before.beyond(Panorama::binOf(bearing) + turn, range);
    if (beyond == Panorama::kUnknown) return;
    ++comparison.compared;
    const double same = kSame + kSamePerMetre * range;
    comparison.shorter += beyond < -same ? 1 : 0;
    comparison.longer += beyond > same ? 1 : 0;
  });
  if (comparison.compared <= kCompared * beams) return std::nullopt;
  return comparison;
}

/// Whether it shows another place however the wheels slipped in a turn.
bool isOtherByAnyTurn(const Panorama& before, const Scan& scan) {
  constexpr int kMostSlip = 15;  // bins
  for (int turn = -kMostSlip; turn <= kMostSlip; ++turn) {
    const auto compared = compare(before, scan, turn);
    if (!compared || !compared->isOtherPlace()) return false;
  }
  return true;
}

bool isOfSameLaser(const Scan& a, const Scan& b) {
  constexpr double kBeside = 0.01;  // m
  return (a.position - b.position).norm() < kBeside && a.max_range == b.max_range;
}

}  // namespace

bool ScanChange::isElsewhere(const Pose2& T_odom_base, const Scan& scan) {
  changed_share_ = 1.0;
  nearer_share_ = 0.0;
  if (isCovered(scan)) return false;
  const auto last = std::find_if(seen_.begin(), seen_.end(),
                                 [&](const Seen& seen) { return isOfSameLaser(seen.scan, scan); });
  if (last == seen_.end()) {
    if (seen_.size() == kLasers) seen_.erase(seen_.begin());
    seen_.push_back({T_odom_base, scan});
    return false;
  }
  const bool is_other = isOtherPlace(last->scan, between(last->T_odom_base, T_odom_base), scan);
  last->T_odom_base = T_odom_base;
  last->scan = scan;
  return is_other;
}

bool ScanChange::isOtherPlace(const Scan& before, const Pose2& motion, const Scan& now) {
  if (std::hypot(motion.x, motion.y) > kMostWay || std::abs(motion.theta) > kMostTurn) return false;
  const Panorama panorama = panoramaOf(before, motion);
  const auto compared = compare(panorama, now, 0);
  if (!compared) return false;
  changed_share_ = compared->changedShare();
  nearer_share_ = compared->nearerShare();
  return compared->isOtherPlace() && isOtherByAnyTurn(panorama, now);
}

}  // namespace adaptive_localization
