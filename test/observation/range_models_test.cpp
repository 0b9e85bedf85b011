// SPDX-License-Identifier: BSD-3-Clause
#include "observation/range_models.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/toy_scores.hpp"

namespace adaptive_localization {
namespace {

TEST(BeamModel, IsTheFourPartMixture) {
  ToyModelOptions options = modelOptions("beam");
  options.laser_z_short = 0.05;
  options.laser_lambda_short = 0.2;
  options.laser_z_max = 0.07;
  const double expected = 2.025;  // from x = 1 to the middle of the wall's cell
  const auto direct = [&](double z) {
    const double d = (z - expected) / 0.1;
    return 0.9 * std::exp(-0.5 * d * d) + (z < expected ? 0.05 * 0.2 * std::exp(-0.2 * z) : 0.0) +
           0.1 / 10.0;
  };
  for (const double z : {1.0, 1.9, 2.05, 4.0}) {
    EXPECT_NEAR(scoreAt(options, wall(), hitsAt({{z, 0.0}}, 10.0), kInLane), std::log(direct(z)),
                1e-5);
  }
  Observations mixed = hitsAt({{1.9, 0.0}}, 10.0);
  mixed.scan.no_return_bearing = Eigen::ArrayXf::Zero(1);
  // the no-return is read as 10 m where about 2 m are expected
  EXPECT_NEAR(scoreAt(options, wall(), mixed, kInLane), std::log(direct(1.9)) + std::log(0.07),
              1e-5);
}

TEST(BeamModel, LooksFromWhereTheSensorIs) {
  const ToyModelOptions options = modelOptions("beam");
  Observations seen = hitsAt({{2.025, 0.0}}, 10.0);
  seen.scan.position = {0.5, 0.0};
  seen.scan.range[0] = 1.526F;  // not short of the wall
  EXPECT_NEAR(scoreAt(options, wall(), seen, kInLane), std::log(0.9 + 0.01), 1e-3);
}

TEST(InverseL1, IsTheInverseSumOfAbsoluteErrors) {
  const auto options = modelOptions("inverse_l1");
  EXPECT_NEAR(scoreAt(options, wall(), hitsAt({{1.525, 0.0}, {2.275, 0.0}}, 10.0), kInLane),
              -std::log(0.75), 1e-6);
  EXPECT_NEAR(scoreAt(options, wall(), hitsAt({{2.025, 0.0}}, 10.0), kInLane), -std::log(1e-3),
              1e-3);
}

}  // namespace
}  // namespace adaptive_localization
