// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/particle/summary.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/parts.hpp"
#include "core/pose_bins.hpp"

namespace adaptive_localization {
namespace {

constexpr double kBinSide = 0.5;          // m
constexpr double kBinAngle = kPi / 18.0;  // rad

/// A number for each bin, the same for bins that touch at a side, an edge or a corner.
std::vector<int> labelClusters(const PoseBins& bins, int& clusters) {
  std::vector<int> label(static_cast<std::size_t>(bins.count()), -1);
  std::vector<int> open;
  clusters = 0;
  for (int start = 0; start < bins.count(); ++start) {
    if (label[static_cast<std::size_t>(start)] >= 0) continue;
    label[static_cast<std::size_t>(start)] = clusters;
    open.push_back(start);
    while (!open.empty()) {
      const PoseBin centre = bins.bin(open.back());
      open.pop_back();
      for (int d = 0; d < 27; ++d) {
        const int neighbour =
            bins.find({centre.x + d % 3 - 1, centre.y + d / 3 % 3 - 1, centre.theta + d / 9 - 1});
        if (neighbour == PoseBins::kNone) continue;
        int& mark = label[static_cast<std::size_t>(neighbour)];
        if (mark >= 0) continue;
        mark = clusters;
        open.push_back(neighbour);
      }
    }
    ++clusters;
  }
  return label;
}

/// Of weighted poses.
struct Sums {
  double mass{0.0}, x{0.0}, y{0.0}, cos{0.0}, sin{0.0};

  Sums& operator+=(const Sums& other) {
    mass += other.mass;
    x += other.x;
    y += other.y;
    cos += other.cos;
    sin += other.sin;
    return *this;
  }
};

}  // namespace

Mode meanAndCovariance(const Particles& particles, const Eigen::ArrayXd& weights,
                       const std::vector<Eigen::Index>& members) {
  const auto count = static_cast<Eigen::Index>(members.size());
  const auto member = [&](Eigen::Index k) { return members[static_cast<std::size_t>(k)]; };
  const auto sums = sumOverParts<Sums>(count, [&](Eigen::Index first, Eigen::Index size) {
    Sums part;
    for (Eigen::Index k = first; k < first + size; ++k) {
      const Eigen::Index i = member(k);
      part.mass += weights[i];
      part.x += weights[i] * particles.x[i];
      part.y += weights[i] * particles.y[i];
      part.cos += weights[i] * std::cos(particles.theta[i]);
      part.sin += weights[i] * std::sin(particles.theta[i]);
    }
    return part;
  });
  Mode mode;
  mode.mass = sums.mass;
  if (!(mode.mass > 0.0)) {  // weights that underflowed: any member will do
    if (!members.empty()) mode.T_map_base = particles.pose(members.front());
    return mode;
  }
  mode.T_map_base = {sums.x / mode.mass, sums.y / mode.mass, std::atan2(sums.sin, sums.cos)};
  mode.covariance =
      sumOverParts<Eigen::Matrix3d>(count, [&](Eigen::Index first, Eigen::Index size) {
        Eigen::Matrix3d part = Eigen::Matrix3d::Zero();
        for (Eigen::Index k = first; k < first + size; ++k) {
          const Eigen::Index i = member(k);
          const Eigen::Vector3d d(particles.x[i] - mode.T_map_base.x,
                                  particles.y[i] - mode.T_map_base.y,
                                  wrapAngle(particles.theta[i] - mode.T_map_base.theta));
          part += weights[i] / mode.mass * d * d.transpose();
        }
        return part;
      });
  return mode;
}

Estimate summarize(const Particles& particles, const Eigen::ArrayXd& weights) {
  PoseBins bins(kBinSide, kBinAngle);
  const std::vector<int> bin = bins.addAll(particles);
  int clusters = 0;
  const std::vector<int> label = labelClusters(bins, clusters);
  std::vector<std::vector<Eigen::Index>> members(static_cast<std::size_t>(clusters));
  if (clusters == 1) members.front().reserve(bin.size());
  for (std::size_t i = 0; i < bin.size(); ++i) {
    const auto cluster = static_cast<std::size_t>(label[static_cast<std::size_t>(bin[i])]);
    members[cluster].push_back(static_cast<Eigen::Index>(i));
  }
  Estimate estimate;
  estimate.modes.reserve(members.size());
  for (const auto& cluster : members) {
    estimate.modes.push_back(meanAndCovariance(particles, weights, cluster));
  }
  if (estimate.modes.empty()) estimate.modes.emplace_back();
  std::stable_sort(estimate.modes.begin(), estimate.modes.end(),
                   [](const Mode& a, const Mode& b) { return a.mass > b.mass; });
  estimate.T_map_base = estimate.modes.front().T_map_base;
  estimate.covariance = estimate.modes.front().covariance;
  return estimate;
}

}  // namespace adaptive_localization
