// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <string>

#include "adaptive_localization/core/rng.hpp"
#include "sim/drive_base.hpp"

namespace adaptive_localization {

/// What is wrong with the wheels. The systematic part is Borenstein and Feng's (IEEE Trans.
/// Robotics and Automation 12(6), 1996): wheels of unequal size and a wrong axle length.
struct OdometryOptions {
  double odom_wheel_ratio{1.004};
  double odom_axle_ratio{1.02};
  double odom_wheel_noise{1e-4};
  double odom_slip_rate{0.2};
  double odom_slip_share{0.2};
  double odom_axle{0.33};
  bool odom_whole_degrees{true};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("odom_wheel_ratio", odom_wheel_ratio, Range{0.5, 2}, "",
           "Right over left wheel diameter, E_d; odometry takes them for equal.");
    option("odom_axle_ratio", odom_axle_ratio, Range{0.5, 2}, "",
           "True over assumed axle length, E_b.");
    option("odom_wheel_noise", odom_wheel_noise, Range{0, 1}, "m",
           "k: each wheel's error has variance k |travel|.");
    option("odom_slip_rate", odom_slip_rate, Range{0, 100}, "1/s",
           "How often the wheels begin to slip while turning faster than 0.3 rad/s.");
    option("odom_slip_share", odom_slip_share, Range{0, 1}, "",
           "Share of the wheels' turning that is lost while they slip (0.3 s each time).");
    option("odom_axle", odom_axle, Range{0.05, 5}, "m", "True distance of the wheels.");
    option("odom_whole_degrees", odom_whole_degrees,
           "Report as p2os does: whole degrees, and ways of whole millimetres since the report "
           "before.");
  }

  /// Defaults by name: ideal (odometry is the truth), nominal, bad.
  /// Throws std::invalid_argument for another name.
  static OdometryOptions profile(const std::string& name);
};

/// Dead reckoning with wrong constants, fed with true motion.
class WheelOdometry {
 public:
  /// With two wheels, or with four that have rollers (mecanum), as far apart along the robot as
  /// across it; the right ones are the larger ones.
  WheelOdometry(const OdometryOptions& options, bool is_omni, const Rng& rng)
      : options_(options), is_omni_(is_omni), rng_(rng) {}

  /// The body really moved so for dt seconds.
  void step(const Velocity& velocity, double dt);

  /// The driver reports where the robot is some seconds after the last step, or before. p2os takes
  /// the difference of the firmware's counts of 0.485 mm since the last report and rounds it to
  /// whole millimetres, so errors add up; headings are rounded to whole degrees, each anew.
  void report(double after = 0.0);

  /// T_odom_base, some seconds after the last step or before: what was reported at last, the
  /// origin at first, and the wheels' way since then.
  Pose2 pose(double after = 0.0) const;

  /// The wheels' velocity in the last step as odometry takes it.
  const Velocity& velocity() const { return measured_; }

 private:
  Pose2 firmwarePose(double after) const;
  double slip(double turn_rate, double dt);
  Velocity measuredByTwo(const Velocity& velocity, double slipping, double dt);
  Velocity measuredByFour(const Velocity& velocity, double slipping, double dt);
  double noise(double travel) {
    return rng_.normal(0.0, std::sqrt(options_.odom_wheel_noise * std::abs(travel)));
  }

  OdometryOptions options_;
  bool is_omni_;
  Rng rng_;
  Pose2 T_odom_base_;           // the firmware's
  Pose2 at_report_, reported_;  // the firmware's and the driver's, T_odom_base at the last report
  Velocity measured_;
  double slip_left_{0.0};  // s
};

}  // namespace adaptive_localization
