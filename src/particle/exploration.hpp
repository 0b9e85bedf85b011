// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>

#include "adaptive_localization/core/observations.hpp"
#include "adaptive_localization/core/options.hpp"
#include "adaptive_localization/core/pose2.hpp"

namespace adaptive_localization {

struct ExplorationOptions {
  double recovery_alpha_slow{0.001};
  double recovery_alpha_fast{0.1};
  double recovery_margin{4.0};
  std::string recovery_reference{"best"};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("recovery_alpha_slow", recovery_alpha_slow, kProbability, "",
           "Decay rate of the long-term mean likelihood; 0: no recovery (amcl core).");
    option("recovery_alpha_fast", recovery_alpha_fast, kProbability, "",
           "Decay rate of the short-term mean likelihood; 0: no recovery (amcl core).");
    option("recovery_margin", recovery_margin, Range{1, 1000}, "",
           "Poses elsewhere are drawn when the short-term mean likelihood times this is below the "
           "long-term one.");
    option(
        "recovery_reference", recovery_reference, Choices{"best", "mean"},
        "Long-term mean likelihood: best, which rises to the short-term one at once and is kept "
        "after poses elsewhere were drawn, or mean, the plain running mean of Thrun et al. 2005.");
  }
};

/// What an update tells about whether the robot is where the particles are. All of it is from
/// before the weights are normalised.
struct Evidence {
  const Observations& observations;
  double mean_likelihood;  // per beam, over the particles
  Pose2 best;              // the particle that explains the observations best
  double spread;           // mean distance of the particles from their mean, m
  Eigen::Index particles;
};

/// What share of the next set shall look elsewhere.
class Exploration {
 public:
  virtual ~Exploration() = default;

  virtual void reset() = 0;

  /// Takes note of an update.
  virtual void observe(const Evidence& evidence) = 0;

  /// Share in [0, 1] of the next set.
  virtual double share() const = 0;

  /// Told that poses elsewhere were drawn.
  virtual void explored() {}
};

std::unique_ptr<Exploration> noExploration();

/// Augmented MCL (Probabilistic Robotics, table 8.3): with w the mean likelihood,
///
///     w_slow += alpha_slow (w - w_slow),  w_fast += alpha_fast (w - w_fast)
///     share = max(0, 1 - margin w_fast / w_slow)
///
/// both averages starting at the first w; the margin is Gutmann and Fox's (2002). As `mean` the
/// averages start anew after poses were drawn elsewhere, as in amcl. As `best` they go on, and
/// w_slow is at least w_fast: what a localized robot sees, though the run began with the robot
/// anywhere. The likelihood is one per beam, so that it depends neither on the number of particles
/// nor of beams.
std::unique_ptr<Exploration> augmentedExploration(const ExplorationOptions& options);

}  // namespace adaptive_localization
