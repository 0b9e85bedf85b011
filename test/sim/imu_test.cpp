// SPDX-License-Identifier: BSD-3-Clause
#include "sim/imu.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace adaptive_localization {
namespace {

TEST(Imu, HasTheNoiseAndTheBiasThatItsOptionsSay) {
  ImuOptions options;
  options.imu_heading_offset = 1.0;
  for (int seed = 1; seed <= 20; ++seed) {
    Imu imu(options, Rng(static_cast<std::uint64_t>(seed)));
    double sum = 0.0, squares = 0.0, rates = 0.0;
    constexpr int kCount = 4000;
    for (int i = 0; i < kCount; ++i) {
      const ImuReading reading = imu.read(0.01 * i, 0.5, 0.2);
      const double off = wrapAngle(reading.heading.theta - 1.5);
      sum += off;
      squares += off * off;
      rates += reading.rate;
    }
    const double bias = sum / kCount;
    EXPECT_LE(std::abs(bias), options.imu_heading_bias + 0.005);
    EXPECT_NEAR(std::sqrt(squares / kCount - bias * bias), options.imu_heading_noise, 0.005);
    EXPECT_NEAR(rates / kCount, 0.2, options.imu_rate_bias + 0.001);
  }
}

TEST(Imu, IsTurnedByADisturbanceUntilThatEnds) {
  ImuOptions options;
  options.imu_heading_bias = 0.0;
  options.imu_heading_noise = 1e-6;
  Imu imu(options, Rng(1));
  EXPECT_NEAR(imu.read(0.0, 0.0, 0.0).heading.theta, 0.0, 1e-4);
  imu.disturb(1.5);
  EXPECT_NEAR(imu.read(0.1, 0.0, 0.0).heading.theta, 1.5, 1e-4);
  EXPECT_NEAR(imu.read(0.2, 0.0, 0.0).rate, 0.0, 0.1);
  imu.disturb(0.0);
  EXPECT_NEAR(imu.read(0.3, 0.0, 0.0).heading.theta, 0.0, 1e-4);
}

}  // namespace
}  // namespace adaptive_localization
