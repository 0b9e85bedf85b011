// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "adaptive_localization/core/rng.hpp"
#include "adaptive_localization/core/scan.hpp"
#include "map/floor_plan.hpp"
#include "match/line_features.hpp"

namespace adaptive_localization {

/// For a map and a laser whose errors are noise alone.
inline LineOptions exactly(double range_std = 0.03) {
  LineOptions options;
  options.line_range_std = range_std;
  options.line_map_std = options.line_map_turn_std = 0.0;
  return options;
}

/// A room of 6 x 4 m, seen from within.
inline std::vector<Segment> room() {
  FloorPlan plan;
  plan.outline = {{0, 0}, {6, 0}, {6, 4}, {0, 4}};
  return surfacesOf(plan);
}

/// The maze that comes with the package.
inline std::vector<Segment> maze() {
  return surfacesOf(loadFloorPlan(SOURCE_DIR "/maps/maze/world.yaml"));
}

/// A round leg or body.
struct Person {
  Eigen::Vector2d centre;
  double radius;
};

/// Metres along a ray to a person's skin, infinity if it misses.
inline double hitPerson(const Person& person, const Eigen::Vector2d& start,
                        const Eigen::Vector2d& direction) {
  const Eigen::Vector2d to = person.centre - start;
  const double along = direction.dot(to);
  const double inside = person.radius * person.radius - (to.squaredNorm() - along * along);
  return along > 0.0 && inside > 0.0 ? along - std::sqrt(inside)
                                     : std::numeric_limits<double>::infinity();
}

/// A laser of half a circle (181 beams) or a whole one (360 beams).
struct ToyLaser {
  LaserMount mount = LaserMount::level({0.1, 0.0, 0.0});
  bool is_round{false};
  double noise{0.0};  // m, of ranges
  std::vector<Person> people;

  LaserScan message(const Pose2& T_map_base, const std::vector<Segment>& walls, Rng& rng) const {
    LaserScan scan;
    scan.angle_min = is_round ? -kPi : -kPi / 2;
    scan.angle_increment = kPi / 180;
    scan.range_max = 30.0;
    const Eigen::Vector2d start = T_map_base * mount.position;
    for (int i = 0; i < (is_round ? 360 : 181); ++i) {
      const double angle = scan.angle_min + i * scan.angle_increment;
      const Eigen::Vector2d direction =
          Pose2{0, 0, T_map_base.theta} * (mount.axes * Point(std::cos(angle), std::sin(angle)));
      double range = std::numeric_limits<double>::infinity();
      for (const auto& wall : walls) range = std::min(range, hit(wall, start, direction));
      for (const auto& person : people)
        range = std::min(range, hitPerson(person, start, direction));
      scan.ranges.push_back(static_cast<float>(range + rng.normal(0.0, noise)));
    }
    return scan;
  }

  Scan scan(const Pose2& T_map_base, const std::vector<Segment>& walls, Rng& rng) const {
    ScanOptions options;
    options.laser_max_beams = 360;
    return toScan(message(T_map_base, walls, rng), mount, options);
  }

 private:
  using Point = Eigen::Vector2d;
};

}  // namespace adaptive_localization
