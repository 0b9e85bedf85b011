// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <variant>
#include <vector>

#include "adaptive_localization/map/distance_field.hpp"
#include "adaptive_localization/map/occupancy_grid.hpp"
#include "adaptive_localization/observations.hpp"
#include "adaptive_localization/options.hpp"
#include "adaptive_localization/particles.hpp"
#include "adaptive_localization/pose2.hpp"

namespace adaptive_localization {

/// A Gaussian over poses of base in map; covariance over (x, y, theta) in m^2, m rad, rad^2.
struct Gaussian2 {
  Pose2 mean;
  Eigen::Matrix3d covariance{Eigen::Matrix3d::Zero()};
};

/// Uniform over the map's free cells and all headings.
struct Anywhere {};

/// What is believed before the first observation. Particles are a belief taken over from another
/// filter: those that know no particles of their own can start from summarize()'s heaviest mode.
using Prior = std::variant<Gaussian2, Anywhere, Particles>;

/// One place where the robot may be.
struct Mode {
  Pose2 T_map_base;
  Eigen::Matrix3d covariance{Eigen::Matrix3d::Zero()};  // of this mode alone
  double mass{0.0};                                     // share of the belief, in [0, 1]
};

/// What a filter believes: the heaviest mode, and all modes, heaviest first (never empty).
struct Estimate {
  Pose2 T_map_base;
  Eigen::Matrix3d covariance{Eigen::Matrix3d::Zero()};
  std::vector<Mode> modes;
};

class Places;
struct Match;

/// What a filter is made from. Map and distance field are immutable and shared. The places tell
/// where in the map a scan can have been taken; they cost nothing until they are asked.
struct FilterContext {
  std::shared_ptr<const OccupancyGrid> map;
  std::shared_ptr<const DistanceField> distance_field;
  Parameters parameters;
  std::uint64_t seed{1};
  std::shared_ptr<Places> places = nullptr;
};

/// A localization filter, chosen by name through the FilterRegistry.
///
/// Given the same context and calls, it gives the same bits, for any number of threads.
/// update never throws and never returns a number that is not finite, whatever it is given.
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
