// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "adaptive_localization/observation/observation_model.hpp"
#include "map/landmark_map.hpp"
#include "map/ray_caster.hpp"

namespace adaptive_localization {

struct LandmarkOptions {
  std::string landmark_map;
  std::string landmark_association{"all"};
  std::string landmark_likelihood{"gaussian"};
  double landmark_false_share{0.1};
  double landmark_miss_share{0.2};
  double landmark_max_range{0.0};
  double landmark_view{2.0 * kPi};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("landmark_map", landmark_map, Choices{},
           "YAML file with landmarks, or a floor plan that has some; empty: none.");
    option("landmark_association", landmark_association,
           Choices{"all", "nearest", "nearest_distance"},
           "Landmark of a sighting that may be of several: all, each by its likelihood; nearest, "
           "the likeliest; nearest_distance, the one whose range fits best.");
    option("landmark_likelihood", landmark_likelihood, Choices{"gaussian", "exponential"},
           "Likelihood of differences in range and bearing: gaussian, by their standard "
           "deviations, or exponential, exp(-|m| / 2 - |rad| / 2) (Fidelis and Colombini 2017).");
    option("landmark_false_share", landmark_false_share, kProbability, "",
           "Share of sightings that are of no landmark.");
    option("landmark_miss_share", landmark_miss_share, kProbability, "",
           "Share of the landmarks in view that are not sighted; used with landmark_max_range.");
    option(
        "landmark_max_range", landmark_max_range, kNotNegative, "m",
        "Range within which a landmark that is in view and not hidden by a wall should be sighted; "
        "if it is not, that counts against the pose. 0: missing sightings are ignored.");
    option("landmark_view", landmark_view, Range{0.0, 2.0 * kPi}, "rad",
           "Angle of view in which landmarks are sighted, centred straight ahead.");
  }
};

/// The landmarks in the landmark_map; none without one. Throws std::invalid_argument naming the
/// option, the file and what is wrong with it.
LandmarkMap knownLandmarks(const LandmarkOptions& options);

/// What sightings of landmarks say of a pose. With f the share of false sightings, d the
/// Mahalanobis distance between the range and bearing of a sighting and those expected of a
/// landmark,
///
///     log p(sighting | pose) = log((1 - f) m + f),
///     m = mean over candidates of exp(-d^2 / 2)      ("all")
///       = their maximum                              ("nearest")
///
/// the candidates being the landmarks that look as the sighting does. Sightings are independent.
/// Each landmark that should be sighted and is not has the share of misses for a factor.
///
/// After J. G. D. Fidelis and E. L. Colombini (2017), whose own form is "nearest_distance" with
/// "exponential"; the weighted mean over all correspondences is their other strategy.
///
/// A Kalman filter takes each sighting for one of its likeliest landmark, in range and bearing.
class LandmarkModel : public ObservationModel {
 public:
  /// The map's walls hide landmarks. Throws std::invalid_argument as loadLandmarks() does.
  LandmarkModel(const LandmarkOptions& options, std::shared_ptr<const OccupancyGrid> map,
                std::shared_ptr<const DistanceField> field);
  LandmarkModel(const LandmarkOptions& options, LandmarkMap landmarks,
                std::shared_ptr<const OccupancyGrid> map,
                std::shared_ptr<const DistanceField> field);

  double score(const Observations& observations, const Particles& particles,
               Eigen::Ref<Eigen::ArrayXd> log_likelihood) const override;

  std::vector<PoseObservation> linearized(const Observations& observations,
                                          const Pose2& T_map_base) const override;

  std::optional<double> misfit(const Observations& observations,
                               const Pose2& T_map_base) const override;

  /// Of pairs of sightings; of single ones samples of the circles that they tell.
  std::vector<Pose2> explanations(const Observations& observations,
                                  bool are_samples_asked) const override;

  bool canLocalize(const Observations& observations) const override;

  bool namesPlaces(const Observations& observations) const override {
    return canLocalize(observations);
  }

 private:
  std::vector<Sighting> sightingsIn(const Observations& observations) const;
  double likelihood(const Sighting& sighting, const Pose2& T_map_base,
                    const std::vector<Eigen::Vector2d>& candidates) const;
  double logOfMisses(const std::vector<Sighting>& sightings, const Pose2& T_map_base) const;
  bool isFree(const Eigen::Vector2d& place) const;
  void addRing(const Sighting& sighting, std::vector<Pose2>& poses) const;
  void addPair(const Sighting& a, const Sighting& b, std::vector<Pose2>& poses) const;

  LandmarkOptions options_;
  LandmarkMap landmarks_;
  std::shared_ptr<const OccupancyGrid> map_;
  RayCaster ray_caster_;
};

}  // namespace adaptive_localization
