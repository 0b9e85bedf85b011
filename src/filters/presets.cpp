// SPDX-License-Identifier: BSD-3-Clause
#include "presets.hpp"

#include "adaptive_localization/core/pose2.hpp"

namespace adaptive_localization {

Preset operator+(Preset first, const Preset& second) {
  first.insert(second.begin(), second.end());
  return first;
}

Preset sourceOfAll() {
  return {{"odom_alpha1", 0.0},         {"odom_alpha2", 0.0},
          {"odom_alpha3", 0.0},         {"odom_alpha4", 0.0},
          {"odom_noise_xy", 0.020},     {"odom_noise_theta", 0.015},
          {"laser_max_beams", 30},      {"laser_model_type", std::string("inverse_l1")},
          {"laser_max_range", 10.0},    {"update_min_d", 0.0},
          {"update_min_a", 0.0},        {"selective_resampling", false},
          {"min_effective_share", 0.0}, {"laser_sigma_sparse", 0.0}};
}

Preset sourceOfKld() {
  return {{"min_particles", 200},
          {"max_particles", 9000},
          {"kld_err", 0.02},
          {"kld_bin_xy", 0.3},
          {"kld_bin_theta", 2.0 * kPi},
          {"kld_count", std::string("resampled")}};
}

Preset sourceOfSamcl() {
  return {{"elsewhere", std::string("ser")},
          {"kidnap_mean_abs_error", 0.74},
          {"kidnap_arm_spread", 0.14},
          {"local_share", 0.7}};
}

Preset sourceOfEkfIcp() {
  return {{"match_metric", std::string("point")},
          {"match_outliers", std::string("none")},
          {"match_reach", 1.0},
          {"match_reach_end", 1.0},
          {"match_max_iterations", 30},
          {"match_least_inliers", 0.0},
          {"ekf_gate_probability", 1.0},
          {"ekf_rejected_scans", 1000},
          {"ekf_weigh_cloud", false},
          {"match_map_std", 0.0},
          {"match_map_turn_std", 0.0},
          {"update_min_d", 0.0},
          {"update_min_a", 0.0}};
}

Preset sourceOfMarkov() {
  return {{"markov_cell", 0.15},
          {"markov_headings", 180},
          {"laser_max_beams", 30},
          {"update_min_d", 0.0},
          {"update_min_a", 0.0}};
}

Preset stockAmcl() {
  return {{"odom_alpha1", 0.2},
          {"odom_alpha2", 0.2},
          {"odom_alpha3", 0.2},
          {"odom_alpha4", 0.2},
          {"odom_alpha5", 0.2},
          {"odom_noise_xy", 0.0},
          {"odom_noise_theta", 0.0},
          {"laser_model_type", std::string("likelihood_field_cubed")},
          {"laser_z_rand", 0.05},
          {"laser_max_beams", 30},
          {"laser_sigma_hit", 0.2},
          {"min_particles", 100},
          {"kld_err", 0.01},
          {"kld_z", 0.99},
          {"odom_model_type", std::string("diff")},
          {"update_min_d", 0.2},
          {"update_min_a", kPi / 6.0},
          {"resample_interval", 2},
          {"selective_resampling", false},
          {"min_effective_share", 0.0},
          {"laser_sigma_sparse", 0.0},
          {"recovery_alpha_slow", 0.001},
          {"recovery_margin", 1.0},
          {"recovery_reference", std::string("mean")},
          {"elsewhere", std::string("free")},
          {"max_particles", 5000}};
}

}  // namespace adaptive_localization
