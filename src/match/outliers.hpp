// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

namespace adaptive_localization {

/// A hit and the piece of the map's surface that it is taken to be on, both in map.
struct MatchPair {
  Eigen::Index hit;
  Eigen::Vector2d arm;     // from base to the hit
  Eigen::Vector2d normal;  // of the surface
  Eigen::Vector2d target;  // the surface's point nearest to the hit
  double residual;         // m, normal . (hit - target)
  double precision;        // of the residual, as a multiple of that at right angles to the wall
  double weight{1.0};

  /// Derivative of the residual by (x, y, theta).
  Eigen::Vector3d row() const {
    return {normal.x(), normal.y(), normal.y() * arm.x() - normal.x() * arm.y()};
  }
};
using MatchPairs = std::vector<MatchPair>;

/// Geman-McClure: w = (c^2 / (c^2 + r^2))^2.
void weighByKernel(MatchPairs& pairs, double scale);

/// Weight 1 for the best share f of `hits`, 0 for the others: the one with the least fractional
/// root mean square distance, rms(f) / f^1.3 (Phillips, Liu and Tomasi 2007), the noise (m)
/// included in the mean.
void keepBest(MatchPairs& pairs, int hits, double noise);

/// Weight 1 for the pairs that agree, within the tolerance, with the motion that most agree with,
/// of some that are drawn from three pairs each; 0 for the others (RANSAC, Fischler and Bolles
/// 1981). The draws are always the same ones.
void keepConsensus(MatchPairs& pairs, double tolerance);

}  // namespace adaptive_localization
