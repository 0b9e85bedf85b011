// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>

#include "adaptive_localization/core/scan.hpp"

namespace adaptive_localization {

/// How finely directions are told apart where ranges are tabulated: steps of 2 degrees.
constexpr int kDirections = 180;
constexpr double kDirectionStep = 2.0 * kPi / kDirections;

/// Bytes of a row of kDirections ranges, filled up with 0 to whole vectors.
constexpr std::size_t kRangeStride = 192;

/// Ranges in steps of max_range / 255, so that one byte holds one; 255 is "nothing before
/// max_range".
constexpr int kNoReturn = 255;

/// Where a robot's laser looks, in whole directions: direction k is `first + k` directions to the
/// left of the robot's front, and `offset` rad more, k < count. It has a beam in each of them, or
/// where its beams are farther apart than directions one every `spacing` from direction 0 on.
struct ScanGeometry {
  Eigen::Vector2d position{0.0, 0.0};  // of the sensor, in base, m
  double max_range{0.0};               // m
  double offset{0.0};                  // rad, in [0, kDirectionStep)
  int first{0};
  int count{0};
  double spacing{kDirectionStep};  // rad

  /// Number of beams, all round at the most.
  int beams() const;

  /// The direction that beam number i is nearest to.
  int directionOf(int beam) const;

  bool operator==(const ScanGeometry& other) const;

  /// Heading of base, rad, if beam 0 points into a direction of the map's lattice.
  double headingOf(int direction_of_beam_0) const;
};

/// The geometry of a scan, with ranges cut off at max_range at the most.
ScanGeometry geometryOf(const Scan& scan, double max_range);

/// A thinned scan with one range per direction, in steps; -1 where no valid beam is near.
struct DirectionalScan {
  std::array<std::int16_t, kDirections> range;  // [beam]
  int valid{0};                                 // beams that are not -1
};

DirectionalScan toDirections(const Scan& scan, const ScanGeometry& geometry);

/// What a scan tells of one direction, whatever beams laser_max_beams left of it: the range of the
/// nearest beam of its view, in steps. -1 where that one is invalid, or farther off than the next
/// should be.
int rangeIn(int direction, const Scan& scan, const ScanGeometry& geometry);

}  // namespace adaptive_localization
