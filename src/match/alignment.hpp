// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "adaptive_localization/match/match.hpp"
#include "outliers.hpp"

namespace adaptive_localization {

/// J^T W J and J^T W r of pairs, headings in metres at the end of a lever.
struct NormalEquations {
  Eigen::Matrix3d A{Eigen::Matrix3d::Zero()};
  Eigen::Vector3d b{0.0, 0.0, 0.0};
  double weight{0.0}, squares{0.0};

  NormalEquations(const MatchPairs& pairs, double lever);
};

/// The directions that hits tell of, as columns, and how many hits do.
struct Directions {
  Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3> columns{3, 0};
  Match::Vector hits{0};

  explicit Directions(const NormalEquations& normal);
};

/// What is known before, as hits would tell it: information times the variance of a hit. Of no
/// direction nothing at all, but that it is within a kilometre: with hits it can be solved for.
struct PriorHits {
  Pose2 mean;
  bool is_none;
  Eigen::Matrix3d A;

  PriorHits(const Pose2& guess, const Eigen::Matrix3d& information, double hit_variance,
            double lever);
};

/// Gauss-Newton: with a prior in all directions, without one in those that hits tell of.
Pose2 stepToLines(const Pose2& from, const MatchPairs& pairs, double lever, const PriorHits& prior);

/// The motion that brings the hits to their points: centroids, and the angle of
/// sum(p x q) and sum(p . q) about them (Horn 1987, in the plane).
Pose2 stepToPoints(const Pose2& from, const MatchPairs& pairs);

}  // namespace adaptive_localization
