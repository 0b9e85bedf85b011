// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "adaptive_localization/core/belief.hpp"
#include "sim/laser.hpp"
#include "sim/wheel_odometry.hpp"
#include "sim/world.hpp"

namespace adaptive_localization {

/// What no unbiased estimate of a pose can do better than, rms.
struct ErrorBound {
  double position{0.0};  // m, of the distance
  double heading{0.0};   // rad
};

/// Of one scan alone, and of all scans so far together with odometry.
struct ScanBounds {
  ErrorBound of_scan, of_drive;
};

/// Fisher's information about the pose of base in map, over (x, y, theta), in the ranges of a scan
/// with independent normal errors: J^T J / sigma^2, J the derivatives of the ranges by the pose. By
/// central differences of exact ray casting; beams that see an edge or nothing tell nothing.
/// Bearings in the laser's frame, rad; sigma and max_range in m.
Eigen::Matrix3d rangeInformation(const World& world, const Pose2& T_map_base,
                                 const Pose2& T_base_laser, const std::vector<double>& bearings,
                                 double max_range, double sigma);

/// The inverse's share of position and heading.
ErrorBound boundOf(const Eigen::Matrix3d& information);

/// The Cramér-Rao bound along a simulated drive, at its true poses: of each scan alone, and of all
/// scans so far together with the wheels' noise (the posterior bound of Tichavský, Muravchik and
/// Nehorai, IEEE Trans. Signal Processing 46(5), 1998):
///   I_k = (F I_k-1^-1 F^T + Q)^-1 + J^T J / sigma^2.
/// sigma holds the laser's noise and its rounding, Q the noise of both wheels, of variance k
/// |travel|. What else a simulated robot suffers (biases, slip, whole degrees, people) makes
/// estimates worse than this.
class DriveBound {
 public:
  /// Before anything is known the bound is that of the prior; anywhere is 100 m and half a turn.
  /// Throws std::invalid_argument for a laser without noise and rounding, which has no bound.
  DriveBound(std::shared_ptr<const World> world, const LaserOptions& laser,
             const OdometryOptions& odometry, const Prior& prior);

  /// The robot has been put elsewhere, which nobody was told.
  void restart() {
    information_ = anywhere();
    has_moved_ = false;
  }

  /// The robot drove here and took a scan.
  ScanBounds scan(const Pose2& T_map_base);

 private:
  static Eigen::Matrix3d anywhere();
  void predict(const Pose2& T_map_base);

  std::shared_ptr<const World> world_;
  LaserOptions laser_;
  OdometryOptions odometry_;
  double sigma_;                  // m
  std::vector<double> bearings_;  // rad in the laser's frame
  Eigen::Matrix3d information_;
  bool has_moved_{false};  // and before_ is where from
  Pose2 before_;
};

}  // namespace adaptive_localization
