// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "adaptive_localization/core/belief.hpp"
#include "adaptive_localization/map/occupancy_grid.hpp"
#include "eval/log.hpp"

namespace adaptive_localization {

/// How sure the start pose of a replay is; amcl's keys.
struct StartOptions {
  double initial_cov_xx{0.2 * 0.2};
  double initial_cov_yy{0.2 * 0.2};
  double initial_cov_aa{0.14 * 0.14};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("initial_cov_xx", initial_cov_xx, kVariance, "m^2", "Variance of the start in x.");
    option("initial_cov_yy", initial_cov_yy, kVariance, "m^2", "Variance of the start in y.");
    option("initial_cov_aa", initial_cov_aa, kVariance, "rad^2",
           "Variance of the start's heading.");
  }

  Gaussian2 around(const Pose2& mean) const {
    Gaussian2 prior;
    prior.mean = mean;
    prior.covariance.diagonal() << initial_cov_xx, initial_cov_yy, initial_cov_aa;
    return prior;
  }
};

/// The prior that `start` asks for: "truth" (the reference pose of the first scan; scans before the
/// reference begins are taken out of the log), "X,Y,YAW" in metres and radians, "global", or empty
/// for truth where the log has a reference and global elsewhere.
/// Throws std::invalid_argument saying what was expected.
Prior startPrior(const std::string& start, const StartOptions& options, Log& log);

/// X,Y,YAW in metres and radians. Throws std::invalid_argument naming the argument, what it got and
/// what was expected.
Pose2 toPose(const std::string& argument, const std::string& text, const std::string& expected);

/// Where that is, for people: a pose, and whether it is the reference's, or anywhere.
std::string startText(const std::string& start, const Prior& prior);

/// Throws std::invalid_argument naming the pose, and from where to where the map goes, if the prior
/// is a pose outside of it.
void checkStart(const std::string& start, const Prior& prior, const OccupancyGrid& map);

}  // namespace adaptive_localization
