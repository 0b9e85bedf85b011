// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "sim/free_space.hpp"

namespace adaptive_localization {

/// People whom no map shows: discs that walk straight from place to place and do not walk into the
/// robot.
class People {
 public:
  static constexpr double kRadius = 0.2;  // m, at the laser's height

  People(std::shared_ptr<const FreeSpace> free_space, int count, const Rng& rng);

  void step(double dt, const Eigen::Vector2d& robot);

  /// Metres along a ray to the first person, at most `limit`.
  double range(const Pose2& T_map_ray, double limit) const;

  const std::vector<Eigen::Vector2d>& places() const { return places_; }

 private:
  struct Walk {
    Eigen::Vector2d goal;
    double speed;  // m/s
  };

  void chooseGoal(std::size_t i);

  std::shared_ptr<const FreeSpace> free_space_;
  Rng rng_;
  std::vector<Eigen::Vector2d> places_;
  std::vector<Walk> walks_;
};

}  // namespace adaptive_localization
