// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "adaptive_localization/observation/observation_model.hpp"
#include "map/ray_caster.hpp"

namespace adaptive_localization {

struct SonarOptions {
  double sonar_sigma{0.06};
  double sonar_false_share{0.25};
  double effective_sonars{8.0};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("sonar_sigma", sonar_sigma, Range{0.005, 2}, "m",
           "Standard deviation of a sonar's range, errors of sensor and map combined; 1 % of the "
           "measured range is added to it.");
    option("sonar_false_share", sonar_false_share, Range{0.01, 0.99}, "",
           "Share of readings that are of nothing on the map: mirrored, of another sonar's ping, "
           "of people.");
    option("effective_sonars", effective_sonars, kPositive, "",
           "Number of independent readings that those of all sonars are worth at the most: they "
           "see the same surfaces.");
  }
};

/// What readings of sonars say of a pose. A sonar hears what is nearest in its cone, and hears it
/// well only where the surface faces it: walls are mirrors to sound. With r the range of the
/// nearest wall in the cone, e the probability that it echoes, 0.9 if the wall is nearer within
/// the cone than at its edge, else 0.3, s the standard deviation and f the share of false readings,
///
///     p(z | pose)       = f + (1 - f) e exp(-(z - r)^2 / (2 s^2))
///     p(no echo | pose) = f + (1 - f) (1 - e),   e = 0 where r is out of reach
///
/// Readings are independent, but tempered to effective_sonars.
///
/// After K. Konolige (1997), whose map has the same share of mirrored readings, and A. Burguera,
/// Y. González and G. Oliver (2009), who take the nearest surface in the cone.
///
/// A Kalman filter takes an echo for one of the nearest wall, seen square, where it fits.
class SonarModel : public ObservationModel {
 public:
  SonarModel(const SonarOptions& options, std::shared_ptr<const OccupancyGrid> map,
             std::shared_ptr<const DistanceField> field);

  double score(const Observations& observations, const Particles& particles,
               Eigen::Ref<Eigen::ArrayXd> log_likelihood) const override;

  std::vector<PoseObservation> linearized(const Observations& observations,
                                          const Pose2& T_map_base) const override;

  /// With echoes of four sonars or more.
  bool canLocalize(const Observations& observations) const override;

  /// Of the three quarters of the echoes that fit best.
  std::optional<double> misfit(const Observations& observations,
                               const Pose2& T_map_base) const override;

 private:
  /// The nearest wall in a cone.
  struct Wall {
    double range;    // m, the limit if there is none before
    double bearing;  // rad, from the axis
    bool is_faced;   // the sonar looks at it squarely
  };

  Wall nearestWall(const SonarReading& reading, const Pose2& T_map_base, double limit) const;
  double likelihood(const SonarReading& reading, const Pose2& T_map_base) const;
  double deviation(const SonarReading& reading) const;

  SonarOptions options_;
  double resolution_;  // of the map, m
  RayCaster ray_caster_;
};

}  // namespace adaptive_localization
