// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "adaptive_localization/core/pose2.hpp"
#include "adaptive_localization/core/scan.hpp"

namespace adaptive_localization {

/// Which way base points, as a compass tells: counter-clockwise from a direction that is fixed in
/// the world. The Localizer is told by the compass's own direction, cores by the map's x axis.
struct Heading {
  double theta{0.0};      // rad
  double deviation{0.0};  // standard deviation, rad
};

/// How far base has turned, as a gyroscope tells: its rates summed up since it was first heard or
/// was silent last. Two such sums with the same beginning tell the turn between them.
struct GyroTurn {
  double angle{0.0};      // rad, counter-clockwise, not wrapped
  double deviation{0.0};  // standard deviation of a rate, rad/s
  double since{0.0};      // stamp at which the sum began, s
};

/// A landmark as it is seen from base.
struct Sighting {
  int id{-1};           // as in the map of landmarks, where several may share one; -1: unknown
  double range{0.0};    // m
  double bearing{0.0};  // rad, counter-clockwise from straight ahead
  double range_deviation{0.0};    // standard deviations, m
  double bearing_deviation{0.0};  // and rad
};

/// What one of a robot's sonars heard of its ping.
struct SonarReading {
  int sonar{0};           // which one
  Pose2 T_base_sonar{};   // where it pinged, its axis along x, from where base is now
  double range{0.0};      // m to what echoed first; infinity: nothing did
  double max_range{0.0};  // m, from which no echo is heard
  double view{0.0};       // angle of its cone, half of it on each side of the axis, rad
};

/// All that was sensed at one instant. What was not sensed is empty.
struct Observations {
  double stamp{0.0};  // s
  Scan scan{};
  std::optional<Heading> heading{};
  std::optional<GyroTurn> gyro{};
  std::optional<std::vector<Sighting>> landmarks{};  // none in sight is an observation too
  std::vector<SonarReading> sonar{};                 // of late
};

}  // namespace adaptive_localization
