// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "adaptive_localization/core/options.hpp"
#include "adaptive_localization/core/pose2.hpp"

namespace adaptive_localization {

/// A laser scan as the driver sends it (sensor_msgs/LaserScan as plain values): beam i points to
/// angle_min + i * angle_increment in the sensor's frame. The increment may be negative.
struct LaserScan {
  double stamp{0.0};  // s, of the first beam
  double angle_min{0.0};
  double angle_increment{0.0};
  double time_increment{0.0};  // s between beams
  double range_min{0.0};
  double range_max{0.0};
  std::vector<float> ranges;       // m; NaN invalid, inf no return
  std::vector<float> intensities;  // of each beam, as the driver scales them; empty: not told
};

/// The angles between which a laser sees, in its own frame, rad.
struct AngleLimits {
  double low{-std::numeric_limits<double>::infinity()};
  double high{std::numeric_limits<double>::infinity()};
};

/// Where the laser sits on the robot, seen from above: a point at p in the sensor's plane is at
/// position + axes * p in base. For a level laser the axes are a rotation, for one mounted upside
/// down a reflection, for a tilted one they shorten.
struct LaserMount {
  Eigen::Vector2d position{0.0, 0.0};
  Eigen::Matrix2d axes{Eigen::Matrix2d::Identity()};
  AngleLimits view;  // beams outside are invalid: they see the robot itself, say

  static LaserMount level(const Pose2& T_base_sensor);
  static LaserMount upsideDown(const Pose2& T_base_sensor);
};

/// A scan as it was before laser_max_beams thinned it, for what needs the same directions of every
/// scan: its beams from the rightmost to the leftmost, valid or not, or if they are closer together
/// than kFinest those nearest to every kFinest. In the base frame.
struct ScanView {
  static constexpr double kFinest = kPi / 90.0;  // rad

  double start{0.0};        // bearing of the rightmost beam, rad
  double width{0.0};        // from there to the leftmost, rad
  double spacing{kFinest};  // of the beams below, rad
  Eigen::ArrayXf range;     // m; NaN invalid, inf no return
  Eigen::ArrayXf bearing;   // rad
};

/// What was sensed by a scan, thinned, in the base frame. Three kinds of beam are kept apart: a hit
/// has an end point, a no-return saw nothing up to max_range, an invalid one tells nothing.
struct Scan {
  Eigen::Vector2d position{0.0, 0.0};  // of the sensor, in base
  double max_range{0.0};               // m
  Eigen::ArrayXf x, y;                 // end points of the hits in base, m
  Eigen::ArrayXf range, bearing;       // of the hits: m, rad in base
  Eigen::ArrayXf no_return_bearing;    // rad in base
  int invalid{0};
  ScanView view;  // not thinned

  int hits() const { return static_cast<int>(x.size()); }
};

struct ScanOptions {
  int laser_max_beams{180};
  double laser_min_range{-1.0};
  double laser_max_range{-1.0};
  double reflector_intensity{0.0};
  bool deskew{true};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("laser_max_beams", laser_max_beams, Range{2, 10000}, "",
           "Beams used of each scan at the most, evenly spread.");
    option("laser_min_range", laser_min_range, Range{-1, 1000}, "m",
           "Shorter readings are invalid; -1: as the scan message says.");
    option("laser_max_range", laser_max_range, Range{-1, 1000}, "m",
           "Longer readings are no-returns; -1: as the scan message says.");
    option("reflector_intensity", reflector_intensity, kNotNegative, "",
           "Hits of at least this intensity are sightings of landmarks of the landmark_map, "
           "without identity; 0: intensities are not used.");
    option("deskew", deskew,
           "Correct scans for the robot's motion between the first beam and the last; not where "
           "time_increment makes that longer than the time between scans.");
  }
};

/// How the robot moves while a scan is taken: in its own frame, m/s and rad/s.
struct BaseVelocity {
  double x{0.0};
  double y{0.0};
  double turn{0.0};
};

/// Seconds from the first beam of a scan to the last; 0 where the driver does not say, or says a
/// time that no laser takes.
double durationOf(const LaserScan& message);

/// Sorts and thins the beams and moves them to base as it stood at the first beam: with a velocity,
/// a beam sensed t seconds later is moved on by velocity * t, as if it had been seen at once. Each
/// scan is taken by its own shape, so scans of changing shape (sicklms alternates 181 and 180
/// beams) are fine.
/// Throws std::invalid_argument for a scan without beams or with angles or limits that make none.
Scan toScan(const LaserScan& message, const LaserMount& mount, const ScanOptions& options,
            const BaseVelocity& velocity = {});

}  // namespace adaptive_localization
