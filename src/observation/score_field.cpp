// SPDX-License-Identifier: BSD-3-Clause
#include "score_field.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "adaptive_localization/core/parallel.hpp"
#include "field_kernel.hpp"

namespace adaptive_localization {
namespace {

constexpr std::size_t kChunk = 1024;  // particles

SumKernel sum_kernel = fastestSum();

/// The poses of one chunk in table coordinates; the border shifts them by one cell.
struct Poses {
  std::array<float, kChunk> u, v, cos, sin;

  Poses(const Lattice& lattice, const Particles& particles, const Chunk& chunk) {
    const Pose2 T_lattice_map = lattice.toLattice(Pose2{});
    const double c = std::cos(T_lattice_map.theta) / lattice.resolution();
    const double s = std::sin(T_lattice_map.theta) / lattice.resolution();
    const double u0 = T_lattice_map.x / lattice.resolution() + 1.0;
    const double v0 = T_lattice_map.y / lattice.resolution() + 1.0;
    for (std::size_t k = 0; k < chunk.end - chunk.begin; ++k) {
      const auto i = static_cast<Eigen::Index>(chunk.begin + k);
      const double x = particles.x[i];
      const double y = particles.y[i];
      const auto heading = static_cast<float>(particles.theta[i] + T_lattice_map.theta);
      u[k] = static_cast<float>(u0 + c * x - s * y);
      v[k] = static_cast<float>(v0 + s * x + c * y);
      cos[k] = std::cos(heading);
      sin[k] = std::sin(heading);
    }
  }

  PoseColumns columns() const { return {u.data(), v.data(), cos.data(), sin.data()}; }
};

}  // namespace

ScoreField::ScoreField(const DistanceField& field, double max_distance,
                       const std::function<double(double)>& value)
    : lattice_(field.lattice()), table_(lattice_.width() + 2, lattice_.height() + 2) {
  at_max_ = value(max_distance);
  const double range = value(0.0) - at_max_;
  step_ = std::copysign(std::max(std::abs(range), 1e-12) / 65535.0, range);

  const int reach = field.reachInSteps();
  std::vector<std::uint16_t> by_nearness(static_cast<std::size_t>(reach) + 1);
  for (int d = 0; d < reach; ++d) {
    const double distance = d * field.metresPerStep();
    const double level = distance < max_distance ? value(distance) : at_max_;
    by_nearness[static_cast<std::size_t>(reach - d)] =
        static_cast<std::uint16_t>(std::lround((level - at_max_) / step_));
  }

  const SparseGrid& nearness = field.nearness();
  for (std::size_t tile = 0; tile < nearness.tiles(); ++tile) {
    if (!nearness.isWritten(tile)) continue;
    const std::uint16_t* near = nearness.tile(tile);
    std::transform(near, near + SparseGrid::kTileSize, table_.write(tile),
                   [&](std::uint16_t n) { return by_nearness[n]; });
  }
}

void ScoreField::sum(const Eigen::ArrayXf& x, const Eigen::ArrayXf& y, const Particles& particles,
                     Eigen::Ref<Eigen::ArrayXd> sums) const {
  const auto per_metre = static_cast<float>(1.0 / lattice_.resolution());
  const Eigen::ArrayXf hit_x = x * per_metre;
  const Eigen::ArrayXf hit_y = y * per_metre;
  const int hits = static_cast<int>(std::min<Eigen::Index>(x.size(), kMaxHits));
  const FieldView view{table_.values(), table_.stride(),
                       static_cast<float>(lattice_.width()) + 1.5F,
                       static_cast<float>(lattice_.height()) + 1.5F};
  parallelFor(static_cast<std::size_t>(particles.size()), kChunk, [&](const Chunk& chunk) {
    const Poses poses(lattice_, particles, chunk);
    std::array<std::int32_t, kChunk> steps;
    const std::size_t count = chunk.end - chunk.begin;
    sum_kernel(view, poses.columns(), 0, count, hit_x.data(), hit_y.data(), hits, steps.data());
    for (std::size_t k = 0; k < count; ++k) {
      sums[static_cast<Eigen::Index>(chunk.begin + k)] = at_max_ * hits + step_ * steps[k];
    }
  });
}

Eigen::ArrayXd ScoreField::shareAbove(double value, const Eigen::ArrayXf& x,
                                      const Eigen::ArrayXf& y, const Particles& particles) const {
  Eigen::ArrayXd share(x.size());
  Eigen::ArrayXd values(particles.size());
  for (Eigen::Index j = 0; j < x.size(); ++j) {
    sum(x.segment(j, 1), y.segment(j, 1), particles, values);
    share[j] = static_cast<double>((values > value).count()) /
               static_cast<double>(std::max<Eigen::Index>(1, particles.size()));
  }
  return share;
}

void ScoreField::usePortableInstructions(bool portable) {
  sum_kernel = portable ? sumPortable : fastestSum();
}

}  // namespace adaptive_localization
