// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "adaptive_localization/core/observations.hpp"
#include "adaptive_localization/core/options.hpp"
#include "adaptive_localization/core/pose2.hpp"
#include "adaptive_localization/core/rng.hpp"
#include "map/landmark_map.hpp"

namespace adaptive_localization {

/// What sights the landmarks of a floor plan, range and bearing of each: a camera in the middle of
/// the robot, say.
struct CameraOptions {
  bool camera{false};
  double camera_rate{10.0};
  double camera_view{2.1};
  double camera_max_range{9.0};
  double camera_range_noise{0.1};
  double camera_bearing_noise{0.05};
  double camera_false_share{0.0};
  double camera_miss_share{0.1};
  bool camera_identifies{true};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("camera", camera, "The robot sights the floor plan's landmarks.");
    option("camera_rate", camera_rate, Range{0.1, 100}, "Hz", "Pictures per second.");
    option("camera_view", camera_view, Range{0.1, 2.0 * kPi}, "rad",
           "Angle in which landmarks are sighted, half of it on each side of straight ahead.");
    option("camera_max_range", camera_max_range, Range{0.1, 1000}, "m",
           "Landmarks farther away are not sighted.");
    option("camera_range_noise", camera_range_noise, kPositiveDeviation, "",
           "Standard deviation of a range, as a share of it, and 0.02 m besides.");
    option("camera_bearing_noise", camera_bearing_noise, kPositiveDeviation, "rad",
           "Standard deviation of a bearing.");
    option("camera_false_share", camera_false_share, Range{0.0, 0.5}, "",
           "Share of sightings that are of no landmark.");
    option("camera_miss_share", camera_miss_share, kProbability, "",
           "Share of landmarks in view that are not sighted.");
    option("camera_identifies", camera_identifies,
           "Sightings have the ids of landmarks; otherwise -1.");
  }
};

class Camera {
 public:
  /// The true range of a ray (map frame), max_range if it meets nothing.
  using Caster = std::function<double(const Pose2& T_map_ray, double max_range)>;

  Camera(const CameraOptions& options, std::vector<Landmark> landmarks, Rng rng)
      : options_(options), landmarks_(std::move(landmarks)), rng_(rng) {}

  /// What is sighted from a pose.
  std::vector<Sighting> sight(const Pose2& T_map_base, const Caster& cast);

 private:
  bool isInView(const Pose2& T_map_base, const Eigen::Vector2d& place, const Caster& cast) const;
  Sighting measured(int id, double range, double bearing);
  Sighting falseOne();

  CameraOptions options_;
  std::vector<Landmark> landmarks_;
  Rng rng_;
};

}  // namespace adaptive_localization
