// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "adaptive_localization/core/pose2.hpp"
#include "adaptive_localization/core/scan.hpp"

namespace adaptive_localization {

/// Reads beams one by one, as base would have seen them when the first was sent: what toScan()
/// makes a scan of.
class BeamReader {
 public:
  struct Beam {
    double range{0.0};  // m, seen from above; NaN invalid, inf no return
    double bearing{0.0};
    Eigen::Vector2d point;  // of a hit
  };

  BeamReader(const LaserScan& message, const LaserMount& mount, const ScanOptions& options,
             const BaseVelocity& velocity)
      : message_(message), mount_(mount), velocity_(velocity) {
    min_range_ = std::max(message.range_min, options.laser_min_range);
    // a driver may say that its laser has no limit; the models need a number
    const double limit = std::min<double>(message.range_max, std::numeric_limits<float>::max());
    max_range_ = options.laser_max_range > 0.0 ? std::min(limit, options.laser_max_range) : limit;
    const bool moves = velocity.x != 0.0 || velocity.y != 0.0 || velocity.turn != 0.0;
    if (options.deskew && moves && durationOf(message) > 0.0) {
      between_beams_ = message.time_increment;
    }
  }

  double maxRange() const { return max_range_; }

  Beam read(Eigen::Index i) const {
    const double range = message_.ranges[static_cast<std::size_t>(i)];
    const double angle = angleOf(i);
    const Eigen::Vector2d direction =
        mount_.axes * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    Beam beam;
    beam.range = kindOrRange(range, angle, direction.norm());
    beam.bearing = std::atan2(direction.y(), direction.x());
    beam.point = mount_.position + range * direction;
    if (between_beams_ > 0.0) deskew(static_cast<double>(i) * between_beams_, beam);
    return beam;
  }

 private:
  /// One beam alone needs no increment.
  double angleOf(Eigen::Index i) const {
    return i == 0 ? message_.angle_min
                  : message_.angle_min + static_cast<double>(i) * message_.angle_increment;
  }

  double kindOrRange(double range, double angle, double scale) const {
    const bool in_view = angle >= mount_.view.low && angle <= mount_.view.high;
    if (std::isnan(range) || range <= 0.0 || range < min_range_ || !in_view) {
      return std::numeric_limits<double>::quiet_NaN();
    }
    return range >= max_range_ ? std::numeric_limits<double>::infinity() : range * scale;
  }

  void deskew(double t, Beam& beam) const {
    const Pose2 T_first_now{velocity_.x * t, velocity_.y * t, velocity_.turn * t};
    beam.bearing = wrapAngle(beam.bearing + T_first_now.theta);
    beam.point = T_first_now * beam.point;
  }

  const LaserScan& message_;
  const LaserMount& mount_;
  BaseVelocity velocity_;
  double min_range_{0.0};
  double max_range_{0.0};
  double between_beams_{0.0};  // s; 0 where nothing is to be undone
};

}  // namespace adaptive_localization
