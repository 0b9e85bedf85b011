// SPDX-License-Identifier: BSD-3-Clause
#include "outliers.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "adaptive_localization/core/rng.hpp"

namespace adaptive_localization {
namespace {

constexpr double kLeastShare = 0.4;  // that may be kept
constexpr double kExponent = 1.3;    // Phillips et al. in the plane
constexpr int kDraws = 40;  // one is free of outliers, nearly surely, if half the pairs are
constexpr double kLongestStep = 0.5;  // m, rad: what a draw may say

/// The number of distances to keep, which are sorted.
std::size_t bestCount(const std::vector<double>& distances, int hits, double noise) {
  double sum = 0.0, least = 0.0;
  std::size_t best = distances.size();
  for (std::size_t k = 1; k <= distances.size(); ++k) {
    sum += distances[k - 1] * distances[k - 1];
    const double share = static_cast<double>(k) / hits;
    if (share < kLeastShare) continue;
    const double mean = sum / static_cast<double>(k) + noise * noise;
    const double value = std::sqrt(mean) / std::pow(share, kExponent);
    if (least > 0.0 && value >= least) continue;
    least = value;
    best = k;
  }
  return best;
}

/// The motion that brings three pairs together; too long where they do not tell one.
Eigen::Vector3d stepOf(const MatchPair& a, const MatchPair& b, const MatchPair& c) {
  Eigen::Matrix3d rows;
  rows << a.row().transpose(), b.row().transpose(), c.row().transpose();
  return rows.fullPivLu().solve(Eigen::Vector3d(-a.residual, -b.residual, -c.residual));
}

}  // namespace

void weighByKernel(MatchPairs& pairs, double scale) {
  const double square = scale * scale;
  for (MatchPair& pair : pairs) {
    const double root = square / (square + pair.residual * pair.residual);
    pair.weight = root * root;
  }
}

void keepBest(MatchPairs& pairs, int hits, double noise) {
  std::vector<double> distances;
  for (const MatchPair& pair : pairs) distances.push_back(std::abs(pair.residual));
  std::sort(distances.begin(), distances.end());
  const std::size_t count = bestCount(distances, hits, noise);
  const double limit = count > 0 ? distances[count - 1] : 0.0;
  for (MatchPair& pair : pairs) pair.weight = std::abs(pair.residual) <= limit ? 1.0 : 0.0;
}

void keepConsensus(MatchPairs& pairs, double tolerance) {
  if (pairs.size() < 3) return;
  Rng rng(1);
  const auto any = [&] { return pairs[rng.below(pairs.size())]; };
  const auto agrees = [&](const MatchPair& pair, const Eigen::Vector3d& step) {
    return std::abs(pair.residual + pair.row().dot(step)) < tolerance;
  };
  Eigen::Vector3d best{0.0, 0.0, 0.0};
  std::ptrdiff_t most = -1;
  for (int k = 0; k <= kDraws; ++k) {
    const Eigen::Vector3d step = k == 0 ? best : stepOf(any(), any(), any());
    if (!(step.cwiseAbs().maxCoeff() < kLongestStep)) continue;
    const auto count = std::count_if(pairs.begin(), pairs.end(),
                                     [&](const MatchPair& pair) { return agrees(pair, step); });
    if (count <= most) continue;
    most = count;
    best = step;
  }
  for (MatchPair& pair : pairs) pair.weight = agrees(pair, best) ? 1.0 : 0.0;
}

}  // namespace adaptive_localization
