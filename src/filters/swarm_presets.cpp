// SPDX-License-Identifier: BSD-3-Clause
#include "swarm_presets.hpp"

#include <string>

namespace adaptive_localization {

Preset sourceOfSwarms() {
  return {{"swarm_size", 2000},
          {"swarm_beams", 11},
          {"swarm_error", std::string("relative")},
          {"swarm_tolerance", 0.03},
          {"swarm_max_iterations", 500},
          {"swarm_patience", 0},
          {"swarm_budget", 2000.0},
          {"swarm_ranges", std::string("cast")},
          {"swarm_answer", std::string("best")},
          {"wrap_map", true},
          {"swarm_match", false},
          {"swarm_near", std::string("ranges")},
          {"swarm_fix_deviation", 0.3},
          {"swarm_explained", 0.06},
          {"swarm_spread", true},
          {"swarm_fuse", false},
          {"elsewhere", std::string("free")},
          {"update_min_d", 0.0},
          {"update_min_a", 0.0}};
}

Preset sourceOfBats() {
  return {{"bat_frequency", 1.0},     {"bat_inertia", 1.0},    {"bat_walk_share", -1.0},
          {"bat_walk_adapts", false}, {"bat_leap_share", 0.0}, {"bat_greedy", false}};
}

Preset sourceOfLeaders() {
  return {
      {"leaders_per_bats", 300}, {"min_leaders", 1}, {"walk_center", std::string("global_best")}};
}

Preset sourceOfComparedParticles() {
  return {{"max_particles", 2000},
          {"laser_max_beams", 11},
          {"laser_model_type", std::string("beam")},
          {"laser_z_hit", 1.0},
          {"laser_z_short", 0.0},
          {"laser_z_max", 0.0},
          {"laser_z_rand", 0.0},
          {"laser_sigma_hit", 0.2},
          {"effective_beams", 1000.0},
          {"odom_alpha1", 0.0},
          {"odom_alpha2", 0.0},
          {"odom_alpha3", 0.0},
          {"odom_alpha4", 0.0},
          {"odom_noise_xy", 0.05},
          {"odom_noise_theta", 0.03},
          {"resampling_scheme", std::string("multinomial")},
          {"selective_resampling", false},
          {"min_effective_share", 0.0},
          {"update_min_d", 0.0},
          {"update_min_a", 0.0}};
}

}  // namespace adaptive_localization
