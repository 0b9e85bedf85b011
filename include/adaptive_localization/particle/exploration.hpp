// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "adaptive_localization/options.hpp"

namespace adaptive_localization {

struct ExplorationOptions {
  double recovery_alpha_slow{0.001};
  double recovery_alpha_fast{0.1};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("recovery_alpha_slow", recovery_alpha_slow, kProbability, "",
           "Decay rate of the long-term mean likelihood; 0: no recovery (amcl core).");
    option("recovery_alpha_fast", recovery_alpha_fast, kProbability, "",
           "Decay rate of the short-term mean likelihood; 0: no recovery (amcl core).");
  }
};

/// What share of the next set shall look elsewhere.
class Exploration {
 public:
  virtual ~Exploration() = default;

  virtual void reset() = 0;

  /// Takes note of the mean likelihood per beam of the particles, before weights are normalised.
  virtual void observe(double mean_likelihood) = 0;

  /// Share in [0, 1] of the next set.
  virtual double share() const = 0;

  /// Told that poses elsewhere were drawn.
  virtual void explored() = 0;
};

std::unique_ptr<Exploration> noExploration();

/// Augmented MCL (Probabilistic Robotics, table 8.3): with w the mean likelihood,
///
///     w_slow += alpha_slow (w - w_slow),  w_fast += alpha_fast (w - w_fast)
///     share = max(0, 1 - w_fast / w_slow)
///
/// both averages starting at the first w and starting anew after poses were drawn elsewhere. The
/// likelihood is one per beam, so that it depends neither on the number of particles nor of beams.
std::unique_ptr<Exploration> augmentedExploration(const ExplorationOptions& options);

}  // namespace adaptive_localization
