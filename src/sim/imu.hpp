// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "adaptive_localization/core/observations.hpp"
#include "adaptive_localization/core/options.hpp"
#include "adaptive_localization/core/pose2.hpp"
#include "adaptive_localization/core/rng.hpp"

namespace adaptive_localization {

/// A compass and a gyroscope in one box, as cheap ones are.
struct ImuOptions {
  bool imu{false};
  double imu_heading_noise{0.05};
  double imu_heading_bias{0.1};
  double imu_heading_offset{0.0};
  double imu_rate_noise{0.01};
  double imu_rate_bias{0.005};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("imu", imu, "The robot has a compass and a gyroscope, 100 readings per second.");
    option("imu_heading_noise", imu_heading_noise, kPositiveDeviation, "rad",
           "Standard deviation of a heading.");
    option("imu_heading_bias", imu_heading_bias, Range{0, kPi}, "rad",
           "The run's common error of all headings is drawn from plus or minus this.");
    option("imu_heading_offset", imu_heading_offset, Range{-kPi, kPi}, "rad",
           "What the compass tells, but for its errors, where the map's yaw is 0.");
    option("imu_rate_noise", imu_rate_noise, kPositiveDeviation, "rad/s",
           "Standard deviation of a turn rate.");
    option("imu_rate_bias", imu_rate_bias, Range{0, 1}, "rad/s",
           "The run's common error of all rates is drawn from plus or minus this.");
  }
};

struct ImuReading {
  double stamp{0.0};  // s
  Heading heading;
  double rate{0.0};            // rad/s
  double rate_deviation{0.0};  // standard deviation, rad/s
};

class Imu {
 public:
  Imu(const ImuOptions& options, Rng rng)
      : options_(options),
        rng_(rng),
        heading_bias_(rng_.uniform(-options.imu_heading_bias, options.imu_heading_bias)),
        rate_bias_(rng_.uniform(-options.imu_rate_bias, options.imu_rate_bias)) {}

  /// Turns all headings from now on by an angle in rad, as steel near the compass does.
  void disturb(double angle) { disturbance_ = angle; }

  /// Of a robot that points to yaw in the map and turns at a rate.
  ImuReading read(double stamp, double yaw, double rate) {
    const double error =
        heading_bias_ + disturbance_ + rng_.normal(0.0, options_.imu_heading_noise);
    const double heading = wrapAngle(yaw + options_.imu_heading_offset + error);
    const double turn = rate + rate_bias_ + rng_.normal(0.0, options_.imu_rate_noise);
    return {stamp, {heading, options_.imu_heading_noise}, turn, options_.imu_rate_noise};
  }

 private:
  ImuOptions options_;
  Rng rng_;
  double heading_bias_, rate_bias_;  // rad, rad/s
  double disturbance_{0.0};          // rad
};

}  // namespace adaptive_localization
