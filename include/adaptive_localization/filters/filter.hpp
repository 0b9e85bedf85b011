// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "adaptive_localization/core/belief.hpp"
#include "adaptive_localization/core/observations.hpp"
#include "adaptive_localization/core/options.hpp"
#include "adaptive_localization/filters/models.hpp"
#include "adaptive_localization/ser/ground.hpp"

namespace adaptive_localization {

struct Match;

/// What a filter is made from.
struct FilterContext {
  const Models& models;
  Ground ground{};
  Parameters parameters{};
  std::uint64_t seed{1};
};

/// A localization filter, chosen by name (Registries).
///
/// Given the same context and calls, it gives the same bits, for any number of threads.
/// update never throws, but where memory runs out, and never returns a number that is not finite,
/// whatever it is given. One that threw is as if it had not been called: the motion of the next one
/// is that since the last one that did not.
class Filter {
 public:
  virtual ~Filter() = default;

  /// Starts anew from a prior: an initial pose, a request for global localization, or what another
  /// filter believed.
  virtual void reset(const Prior& prior) = 0;

  /// Moves the belief by the odometry since the last update, motion = T_previous_current, and
  /// corrects it by what was observed at its end.
  virtual Estimate update(const Pose2& motion, const Observations& observations) = 0;

  /// The belief now, before any further observation.
  virtual Estimate estimate() const = 0;

  /// The hypotheses behind the estimate, for the particle cloud.
  virtual const Particles& hypotheses() const = 0;

  /// The hypotheses that the others follow, for filters that have such.
  virtual Particles leaders() const { return {}; }

  /// How the last scan was aligned with the map, for filters that do that; null for others.
  virtual const Match* match() const { return nullptr; }
};

}  // namespace adaptive_localization
