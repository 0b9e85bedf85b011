// SPDX-License-Identifier: BSD-3-Clause
#include "core/audience.hpp"

#include <set>

namespace adaptive_localization {
namespace {

const std::set<std::string> kForUsers{
    // which core, and what it may cost
    "filter", "preset", "amcl_compatibility", "plugins", "recovery", "refine", "seed", "threads",
    "update_budget", "search_share", "swarm_size", "markov_cell", "markov_headings",
    "energy_grid_max_memory", "cache_dir",
    // start and end
    "start", "pose_file", "tf_rate",
    // map, scans and odometry
    "map_origin_is_cell_center", "line_map", "scan_topics", "scan_time_offset", "deskew",
    "effective_beams", "odom_noise_xy", "odom_noise_theta", "resampling_scheme",
    // other senses
    "imu_topic", "magnetic_field_topic", "heading_topic", "heading_std", "turn_rate_std",
    "heading_offset", "heading_offset_std", "landmark_topic", "landmark_map", "landmark_max_range",
    "landmark_view", "reflector_intensity", "ekf_landmarks", "sonar_topics", "sonar_frame_prefix",
    "sonar_view", "sonar_max_range", "sonar_sigma"};

const std::set<std::string> kOfAmcl{"bag_scan_period",
                                    "base_frame_id",
                                    "beam_skip_distance",
                                    "beam_skip_error_threshold",
                                    "beam_skip_threshold",
                                    "do_beamskip",
                                    "first_map_only",
                                    "force_update_after_initialpose",
                                    "force_update_after_set_map",
                                    "global_frame_id",
                                    "gui_publish_rate",
                                    "initial_cov_aa",
                                    "initial_cov_xx",
                                    "initial_cov_yy",
                                    "initial_pose_a",
                                    "initial_pose_x",
                                    "initial_pose_y",
                                    "kld_err",
                                    "kld_z",
                                    "laser_lambda_short",
                                    "laser_likelihood_max_dist",
                                    "laser_max_beams",
                                    "laser_max_range",
                                    "laser_min_range",
                                    "laser_model_type",
                                    "laser_sigma_hit",
                                    "laser_z_hit",
                                    "laser_z_max",
                                    "laser_z_rand",
                                    "laser_z_short",
                                    "max_particles",
                                    "min_particles",
                                    "odom_alpha1",
                                    "odom_alpha2",
                                    "odom_alpha3",
                                    "odom_alpha4",
                                    "odom_alpha5",
                                    "odom_frame_id",
                                    "odom_model_type",
                                    "recovery_alpha_fast",
                                    "recovery_alpha_slow",
                                    "resample_interval",
                                    "restore_defaults",
                                    "save_pose_rate",
                                    "selective_resampling",
                                    "std_warn_level_x",
                                    "std_warn_level_y",
                                    "std_warn_level_yaw",
                                    "tf_broadcast",
                                    "transform_tolerance",
                                    "update_min_a",
                                    "update_min_d",
                                    "use_map_topic"};

}  // namespace

Audience audienceOf(const std::string& option) {
  if (kForUsers.count(option)) return Audience::kUsers;
  return kOfAmcl.count(option) ? Audience::kAmcl : Audience::kExperts;
}

}  // namespace adaptive_localization
