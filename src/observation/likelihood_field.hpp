// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>

#include "adaptive_localization/observation/observation_model.hpp"

namespace adaptive_localization {

class ScoreField;

/// Likelihood field (Thrun, Burgard, Fox, Probabilistic Robotics, table 6.3): a hit at distance d
/// from the nearest obstacle has
///
///     p(d) = z_hit exp(-d^2 / (2 sigma_hit^2)) + z_rand / max_range
///
/// d at most laser_likelihood_max_dist. What a scan of B hits is worth:
///
///     likelihood_field         sum_i log p_i * min(1, effective_beams / B)      (our default)
///     likelihood_field_prob    sum_i log p_i over the beams not skipped         (amcl)
///     likelihood_field_cubed   log(1 + sum_i p_i^3)                  (amcl's ad hoc form)
///
/// Where the particles are fewer than 30 per bin of half a metre and 10 degrees, none may be within
/// sigma_hit of the truth; sigma_hit is then at least laser_sigma_sparse.
///
/// No-returns tell nothing, but where they are most of the beams. There the few hits may be of
/// people, or stray, and a pose at which they happen to lie on walls is as likely as the next one,
/// unless the beams beside them should have met these walls as well. So likelihood_field then takes
/// all beams together, B counts the no-returns too, and each of them has p = 1, but where it misses
/// a wall (missedWalls()): there p = max(z_max, 0.01, share of no-returns that miss one, on average
/// of the particles), as on a map that has what is not there many do.
///
/// On a map with thick walls likelihood_field measures from their faces or their middles, as scans
/// tell (ThickWallsField).
///
/// One table look-up per particle and hit. The beam model knows in addition that a wall hides what
/// is behind it, at a hundred times the price.
class LikelihoodField : public ObservationModel {
 public:
  enum class Form { kTempered, kSum, kCubed };  // in the order above

  LikelihoodField(const ObservationOptions& options, Form form,
                  std::shared_ptr<const DistanceField> field);
  ~LikelihoodField() override;

  double score(const Observations& observations, const Particles& particles,
               Eigen::Ref<Eigen::ArrayXd> log_likelihood) const override;

 private:
  /// What one kind of scan is worth. Clouds are sparse for a few updates at a time: a table would
  /// not pay for them.
  struct Fields {
    std::unique_ptr<ScoreField> dense, sparse;
  };

  double logOfMiss(double usual) const;
  double likelihood(double distance, double max_range, double sigma) const;
  std::unique_ptr<ScoreField> fieldOf(double max_range, bool is_sparse) const;
  const ScoreField& fieldFor(double max_range, const Particles& particles) const;

  /// The scan without the beams that few particles explain, if there are few of those.
  Scan skipBeams(const Scan& scan, const Particles& particles) const;

  ObservationOptions options_;
  Form form_;
  std::shared_ptr<const DistanceField> field_;
  std::unique_ptr<ScoreField> nearness_;     // minus the distance; where beams may be skipped
  mutable std::map<double, Fields> fields_;  // by the laser's max_range
};

}  // namespace adaptive_localization
