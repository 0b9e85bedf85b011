// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>

namespace adaptive_localization {

/// amcl's parameters that some filter, or the node at all, has no use for.
inline const std::set<std::string>& amclKeys() {
  static const std::set<std::string> keys{"bag_scan_period",
                                          "beam_skip_distance",
                                          "beam_skip_error_threshold",
                                          "beam_skip_threshold",
                                          "do_beamskip",
                                          "gui_publish_rate",
                                          "kld_err",
                                          "kld_z",
                                          "laser_lambda_short",
                                          "laser_likelihood_max_dist",
                                          "laser_max_beams",
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
                                          "odom_model_type",
                                          "recovery_alpha_fast",
                                          "recovery_alpha_slow",
                                          "resample_interval",
                                          "restore_defaults",
                                          "selective_resampling"};
  return keys;
}

}  // namespace adaptive_localization
