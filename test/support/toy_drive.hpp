// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "adaptive_localization/core/rng.hpp"
#include "support/toy_world.hpp"

namespace adaptive_localization {

/// One step of a drive: where the robot is, what its odometry says it did, what it sees.
struct ToyStep {
  Pose2 T_map_base;
  Pose2 motion;
  Observations observations;
};

/// A drive of 9 m with two left turns through the asymmetric world, with noise of two per cent on
/// odometry and a centimetre on ranges. The first step is the start.
inline std::vector<ToyStep> toyDrive(const std::shared_ptr<const OccupancyGrid>& map,
                                     std::uint64_t seed, int beams = 31) {
  std::vector<Pose2> plan{{}};
  const auto repeat = [&](int times, const Pose2& motion) {
    plan.insert(plan.end(), static_cast<std::size_t>(times), motion);
  };
  repeat(20, {0.2, 0.0, 0.0});
  repeat(8, {0.0, 0.0, kPi / 16});
  repeat(9, {0.2, 0.0, 0.0});
  repeat(8, {0.0, 0.0, kPi / 16});
  repeat(15, {0.2, 0.0, 0.0});

  Rng rng(seed);
  std::vector<ToyStep> drive;
  Pose2 truth{1.0, 1.0, 0.0};
  for (const Pose2& motion : plan) {
    truth = truth * motion;
    const Pose2 read{motion.x * rng.normal(1.0, 0.02), 0.0, motion.theta * rng.normal(1.0, 0.02)};
    Observations seen = ToyLaser{beams, -2.0, 2.0, 12.0}.observe(map, truth);
    Scan& scan = seen.scan;
    for (Eigen::Index i = 0; i < scan.x.size(); ++i) {
      const auto off = static_cast<float>(rng.normal(0.0, 0.01));
      scan.range[i] += off;
      scan.x[i] += off * std::cos(scan.bearing[i]);
      scan.y[i] += off * std::sin(scan.bearing[i]);
    }
    drive.push_back({truth, read, seen});
  }
  return drive;
}

}  // namespace adaptive_localization
