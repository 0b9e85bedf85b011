// SPDX-License-Identifier: BSD-3-Clause
// What options may be: no number without bounds, all that amcl's users may have set.
#include <gtest/gtest.h>

#include <cmath>

#include "../../src/ros/reconfigure_fields.hpp"
#include "eval/start.hpp"
#include "sim/simulation.hpp"

namespace adaptive_localization {
namespace {

std::vector<OptionDescription> everyOption() {
  std::vector<OptionDescription> all = fieldsOf(allOptions({}), {});
  for (const auto& more :
       {describe(NodeOptions{}), describe(StartOptions{}), describe(SimulationOptions{})}) {
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

TEST(OptionRanges, HaveEnds) {
  for (const auto& option : everyOption()) {
    const bool is_number = option.value.index() == 1 || option.value.index() == 2;
    if (!is_number) continue;
    EXPECT_TRUE(std::isfinite(option.range.low)) << option.key;
    EXPECT_TRUE(std::isfinite(option.range.high)) << option.key;
    EXPECT_LE(std::max(-option.range.low, option.range.high), 1e12) << option.key;
    EXPECT_TRUE(option.range.low <= 0.0 || option.range.low >= 1e-6) << option.key;
  }
}

/// The upper ends of AMCL.cfg (amcl 1.17).
TEST(OptionRanges, HoldWhatAmclTakes) {
  const std::map<std::string, double> most{{"gui_publish_rate", 100},
                                           {"save_pose_rate", 10},
                                           {"laser_min_range", 1000},
                                           {"laser_max_range", 1000},
                                           {"laser_max_beams", 250},
                                           {"min_particles", 1000},
                                           {"max_particles", 10000},
                                           {"kld_err", 1},
                                           {"kld_z", 1},
                                           {"odom_alpha1", 10},
                                           {"odom_alpha2", 10},
                                           {"odom_alpha3", 10},
                                           {"odom_alpha4", 10},
                                           {"odom_alpha5", 10},
                                           {"beam_skip_distance", 2},
                                           {"beam_skip_threshold", 1},
                                           {"laser_z_hit", 1},
                                           {"laser_z_short", 1},
                                           {"laser_z_max", 1},
                                           {"laser_z_rand", 1},
                                           {"laser_sigma_hit", 10},
                                           {"laser_lambda_short", 10},
                                           {"update_min_d", 5},
                                           {"laser_likelihood_max_dist", 20},
                                           {"resample_interval", 20},
                                           {"update_min_a", 2 * kPi},
                                           {"transform_tolerance", 2},
                                           {"recovery_alpha_slow", 0.5},
                                           {"recovery_alpha_fast", 1}};
  const std::set<std::string> may_be_0{"odom_alpha1",        "odom_alpha5",  "beam_skip_distance",
                                       "laser_lambda_short", "update_min_d", "update_min_a"};
  std::set<std::string> found;
  for (const auto& option : everyOption()) {
    const auto high = most.find(option.key);
    if (high == most.end()) continue;
    found.insert(option.key);
    EXPECT_GE(option.range.high, high->second) << option.key;
    EXPECT_TRUE(option.range.low <= 0.0 || !may_be_0.count(option.key)) << option.key;
  }
  EXPECT_EQ(found.size(), most.size());
}

}  // namespace
}  // namespace adaptive_localization
