// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "adaptive_localization/core/observations.hpp"
#include "adaptive_localization/core/pose2.hpp"

namespace adaptive_localization {

/// Corrects the turns of odometry, whose wheels slip, by a gyroscope, weighed by their variances:
///
///     turn = (odo / v_odo + gyro / v_gyro) / (1 / v_odo + 1 / v_gyro)
///
/// v_odo is that of the odometry motion models with amcl's usual noise. The gyroscope's bias is
/// learned while the wheels stand still. Where the two go apart by more than wheels slip, the
/// gyroscope may be broken as well: then odometry alone counts, until they agree again.
class Gyroscope {
 public:
  /// Takes note of a scan, whether it goes through the filter or not.
  void observe(const Pose2& T_odom_base, const Observations& observations);

  /// Of the motion by odometry since the last one that was asked for: motion * slip is the
  /// corrected motion, x and y turned by half of what the turn is, as on an arc. No slip where the
  /// gyroscope does not tell.
  Pose2 slipDuring(const Pose2& motion);

  /// Forgets where it was, not its bias.
  void restart();

  double bias() const { return bias_; }  // rad/s
  bool isDoubted() const { return is_doubted_; }

  /// What becomes of its rates, for a reader: "used", "contradicts the odometry".
  std::string state() const { return is_doubted_ ? "contradicts the odometry" : "used"; }

 private:
  struct Sight {
    double stamp;
    Pose2 T_odom_base;
    GyroTurn turn;
  };

  void learnBias(const Sight& before, const Sight& now);

  std::optional<Sight> last_;  // scan
  std::optional<Sight> base_;  // scan at the last motion that was asked for
  double bias_{0.0};
  double stood_{0.0};  // s in all
  double apart_{0.0};  // rad, of late
  bool is_doubted_{false};
};

}  // namespace adaptive_localization
