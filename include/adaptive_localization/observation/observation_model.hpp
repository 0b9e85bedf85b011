// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "adaptive_localization/core/observations.hpp"
#include "adaptive_localization/core/options.hpp"
#include "adaptive_localization/core/particles.hpp"
#include "adaptive_localization/core/pose_observation.hpp"
#include "adaptive_localization/core/registry.hpp"
#include "adaptive_localization/map/distance_field.hpp"
#include "adaptive_localization/map/occupancy_grid.hpp"

namespace adaptive_localization {

/// What the built-in models read. Names and meanings are amcl's; effective_beams is ours.
struct ObservationOptions {
  double laser_z_hit{0.95};
  double laser_z_short{0.1};
  double laser_z_max{0.05};
  double laser_z_rand{0.2};
  double laser_sigma_hit{0.0};  // what it is for a map: sigmaHit()
  double laser_sigma_sparse{0.2};
  double laser_lambda_short{0.1};
  double laser_likelihood_max_dist{2.0};
  double effective_beams{15.0};
  bool do_beamskip{false};
  double beam_skip_distance{0.5};
  double beam_skip_threshold{0.3};
  double beam_skip_error_threshold{0.9};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("laser_z_hit", laser_z_hit, kProbability, "",
           "Weight of a hit near the expected place.");
    option("laser_z_short", laser_z_short, kProbability, "", "Weight of a short reading (beam).");
    option(
        "laser_z_max", laser_z_max, kProbability, "",
        "Weight of a no-return where the map has a wall (beam; likelihood_field, where most beams "
        "see nothing).");
    option("laser_z_rand", laser_z_rand, kProbability, "", "Weight of a random reading.");
    option("laser_sigma_hit", laser_sigma_hit, Range{0, 10}, "m",
           "Standard deviation of a hit, of sensor and map together; 0: from the map's looks, 0.04 "
           "m where walls are thin, up to 0.2 m where they are thick and rough.");
    option("laser_sigma_sparse", laser_sigma_sparse, Range{0, 10}, "m",
           "Lower bound of laser_sigma_hit while particles are sparse: too few for the region they "
           "cover to have one near the truth (likelihood fields).");
    option("laser_lambda_short", laser_lambda_short, kNotNegative, "1/m",
           "Decay of the share of short readings (beam).");
    option("laser_likelihood_max_dist", laser_likelihood_max_dist, Range{1e-3, 50}, "m",
           "Distances of hits from obstacles are truncated to this; above 5 m it has no further "
           "effect (likelihood fields).");
    option("effective_beams", effective_beams, kPositive, "",
           "Largest number of independent beams that a scan counts as: neighbouring beams share "
           "errors, and the log likelihood is scaled down to it. With a smaller number scans weigh "
           "less (likelihood_field, beam).");
    option("do_beamskip", do_beamskip,
           "Leave out beams that few particles explain (likelihood_field_prob).");
    option("beam_skip_distance", beam_skip_distance, kNotNegative, "m",
           "Largest distance from an obstacle at which a particle explains a hit.");
    option("beam_skip_threshold", beam_skip_threshold, kProbability, "",
           "Share of particles that must explain a beam for it to be used.");
    option("beam_skip_error_threshold", beam_skip_error_threshold, kProbability, "",
           "If more than this share of the beams were left out, all are used.");
  }
};

/// laser_sigma_hit, m, for a map: the one that was given, else the one that the map lets expect.
inline double sigmaHit(const ObservationOptions& options, const MapQuality& quality) {
  return options.laser_sigma_hit > 0.0 ? options.laser_sigma_hit : quality.hitDeviation();
}

/// How well observations fit poses.
class ObservationModel {
 public:
  virtual ~ObservationModel() = default;

  /// Adds log p(observations | pose, map) of each particle, up to a constant that all share, and
  /// returns the number of independent beams behind it: exp(sum / number) is a likelihood per beam
  /// that does not depend on how many were used. Without a hit it adds nothing and returns 0.
  virtual double score(const Observations& observations, const Particles& particles,
                       Eigen::Ref<Eigen::ArrayXd> log_likelihood) const = 0;

  /// What the observations say of the pose near one, to first order, for Kalman filters; nothing
  /// where a model cannot tell. Scans have their matchers for that.
  virtual std::vector<PoseObservation> linearized(const Observations& /*observations*/,
                                                  const Pose2& /*T_map_base*/) const {
    return {};
  }

  // Of senses beside the laser, which may have to do without it.

  /// What it says against a place, in all, as log odds: a sense that is disturbed is so for long,
  /// and all that it says then is one mistake.
  virtual double mostInAll() const { return std::numeric_limits<double>::infinity(); }

  /// Whether the observations tell where the robot is, as a scan does.
  virtual bool canLocalize(const Observations& /*observations*/) const { return false; }

  /// How badly the observations fit a pose, as a laser's mean range error would be, m; nothing
  /// where they cannot localize.
  virtual std::optional<double> misfit(const Observations& /*observations*/,
                                       const Pose2& /*T_map_base*/) const {
    return std::nullopt;
  }

  /// Whether explanations() knows of all places there may be; else those that are followed are all
  /// that is known.
  virtual bool namesPlaces(const Observations& /*observations*/) const { return false; }

  /// Poses that explain the observations, for observations that can localize: few that they tell,
  /// or, where they tell but a curve or an area, none, unless samples of that are asked for.
  virtual std::vector<Pose2> explanations(const Observations& /*observations*/,
                                          bool /*are_samples_asked*/) const {
    return {};
  }
};

/// An observation model as it is registered.
struct ObservationDescription {
  std::string name;
  std::string sentence;
  std::function<std::unique_ptr<ObservationModel>(
      const Parameters& given, const std::shared_ptr<const OccupancyGrid>& map,
      const std::shared_ptr<const DistanceField>& field)>
      make;
  std::vector<OptionDescription> options;  // all that make() reads
  double price{1.0};  // of a beam and particle, in look-ups of the likelihood field
};

struct ObservationChoice {
  std::string laser_model_type{"likelihood_field"};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("laser_model_type", laser_model_type, Choices{}, "Observation model.");
  }
};

/// The model that the parameters name. Throws std::invalid_argument naming key and value.
inline std::unique_ptr<ObservationModel> makeObservationModel(
    const Registry<ObservationDescription>& known, const Parameters& given,
    const std::shared_ptr<const OccupancyGrid>& map,
    const std::shared_ptr<const DistanceField>& field) {
  return known.make(given.read<ObservationChoice>().laser_model_type, given, map, field);
}

}  // namespace adaptive_localization
