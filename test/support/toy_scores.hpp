// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "adaptive_localization/filters/builtins.hpp"
#include "support/toy_parameters.hpp"
#include "support/toy_world.hpp"

namespace adaptive_localization {

using Map = std::shared_ptr<const OccupancyGrid>;

struct ToyModelOptions : ObservationOptions {
  std::string laser_model_type;
};

inline ToyModelOptions modelOptions(const std::string& type) {
  ToyModelOptions options;
  options.laser_model_type = type;
  options.laser_z_hit = 0.9;
  options.laser_z_rand = 0.1;
  options.laser_sigma_hit = 0.1;
  options.laser_sigma_sparse = 0.0;
  options.laser_likelihood_max_dist = 2.0;
  options.effective_beams = 12.0;
  return options;
}

inline std::unique_ptr<ObservationModel> makeModel(const ToyModelOptions& options, const Map& map) {
  return builtins().observations.make(options.laser_model_type,
                                      parametersOf<ObservationOptions>(options), map,
                                      std::make_shared<const DistanceField>(*map));
}

struct Scores {
  Eigen::ArrayXd log_likelihood;
  double beams;
};

inline Scores scoresOf(const ToyModelOptions& options, const Map& map, const Observations& seen,
                       const Particles& particles) {
  Scores scores{Eigen::ArrayXd::Zero(particles.size()), 0.0};
  scores.beams = makeModel(options, map)->score(seen, particles, scores.log_likelihood);
  return scores;
}

inline double scoreAt(const ToyModelOptions& options, const Map& map, const Observations& seen,
                      const Pose2& pose) {
  Particles particles(1);
  particles.setPose(0, pose);
  return scoresOf(options, map, seen, particles).log_likelihood[0];
}

/// A wall one cell thick; the hit of a beam of 2 m from the origin is so many cells before it.
inline const Map& wall() {
  static const Map map = toyWorld({Art(1, std::string(60, '.') + "#").front()}, 0.05);
  return map;
}
inline Observations hitBeforeWall(int cells, int beams = 1) {
  const double x = 0.05 * (60 - cells) + 0.025 - 1.0;
  return hitsAt(std::vector<Eigen::Vector2d>(static_cast<std::size_t>(beams), {x, 0.0}), 10.0);
}
inline const Pose2 kInLane{1.0, 0.025, 0.0};

}  // namespace adaptive_localization
