// SPDX-License-Identifier: BSD-3-Clause
#include "score_field.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/parallel.hpp"
#include "field_kernel.hpp"

namespace adaptive_localization {
namespace {

constexpr std::size_t kChunk = 1024;  // particles

SumKernel sum_kernel = fastestSum();

/// From the map to the coordinates of the table, in cells; the border shifts them by one.
struct ToTable {
  double c, s, u0, v0;

  explicit ToTable(const Lattice& lattice) {
    const Pose2 T_lattice_map = lattice.toLattice(Pose2{});
    c = std::cos(T_lattice_map.theta) / lattice.resolution();
    s = std::sin(T_lattice_map.theta) / lattice.resolution();
    u0 = T_lattice_map.x / lattice.resolution() + 1.0;
    v0 = T_lattice_map.y / lattice.resolution() + 1.0;
  }

  std::pair<double, double> operator()(double x, double y) const {
    return {u0 + c * x - s * y, v0 + s * x + c * y};
  }
};

/// The poses of one chunk in table coordinates.
struct Poses {
  std::array<float, kChunk> u, v, cos, sin;

  Poses(const Lattice& lattice, const Particles& particles, const Chunk& chunk) {
    const ToTable to_table(lattice);
    const double turn = lattice.toLattice(Pose2{}).theta;
    for (std::size_t k = 0; k < chunk.end - chunk.begin; ++k) {
      const auto i = static_cast<Eigen::Index>(chunk.begin + k);
      const auto heading = static_cast<float>(particles.theta[i] + turn);
      const auto [column, row] = to_table(particles.x[i], particles.y[i]);
      u[k] = static_cast<float>(column);
      v[k] = static_cast<float>(row);
      cos[k] = std::cos(heading);
      sin[k] = std::sin(heading);
    }
  }

  PoseColumns columns() const { return {u.data(), v.data(), cos.data(), sin.data()}; }
};

/// How far the farthest hit is from base, m. Numbers that are none do not count.
double reachOf(const Eigen::ArrayXf& x, const Eigen::ArrayXf& y) {
  float most = 0.0F;
  for (Eigen::Index j = 0; j < x.size(); ++j) {
    const float square = x[j] * x[j] + y[j] * y[j];
    if (square > most) most = square;
  }
  return std::sqrt(static_cast<double>(most));
}

}  // namespace

ScoreField::ScoreField(std::shared_ptr<const DistanceField> field, double max_distance,
                       const std::function<double(double)>& value, Table table)
    : field_(std::move(field)) {
  at_max_ = value(max_distance);
  const double range = value(0.0) - at_max_;
  step_ = std::copysign(std::max(std::abs(range), 1e-12) / 65535.0, range);

  const int reach = field_->reachInSteps();
  by_nearness_.resize(static_cast<std::size_t>(reach) + 1);
  for (int d = 0; d < reach; ++d) {
    const double distance = d * field_->metresPerStep();
    const double level = distance < max_distance ? value(distance) : at_max_;
    by_nearness_[static_cast<std::size_t>(reach - d)] =
        static_cast<std::uint16_t>(std::lround((level - at_max_) / step_));
  }
  if (table == Table::kNone) return;
  const SparseGrid& nearness = field_->nearness();
  table_.emplace(field_->lattice().width() + 2, field_->lattice().height() + 2);
  is_made_around_.resize(table_->tiles(), 0);
  for (std::size_t tile = 0; tile < nearness.tiles(); ++tile) to_make_ += nearness.isWritten(tile);
}

/// Those that a hit can fall on from a tile with a particle in it. One beside the map sees no
/// farther into it than the nearest place on it.
void ScoreField::makeTiles(const Eigen::ArrayXf& x, const Eigen::ArrayXf& y,
                           const Particles& particles) const {
  if (to_make_ == 0) return;
  constexpr int kColumns = SparseGrid::kTileColumns, kRows = SparseGrid::kTileRows;
  const int across = table_->stride() / kColumns;
  const int down = static_cast<int>(table_->tiles()) / across;
  const double reach = reachOf(x, y) / field_->lattice().resolution() + 2.0;  // cells
  constexpr double kMost = 65534.0;                                           // tiles
  const int rows = static_cast<int>(std::min(std::ceil(reach / kRows), kMost));
  const int columns = static_cast<int>(std::min(std::ceil(reach / kColumns), kMost));
  const ToTable to_table(field_->lattice());
  std::vector<std::size_t> wanted;
  for (Eigen::Index i = 0; i < particles.size(); ++i) {
    const auto [u, v] = to_table(particles.x[i], particles.y[i]);
    const int column = static_cast<int>(std::max(0.0, std::min(u / kColumns, across - 1.0)));
    const int row = static_cast<int>(std::max(0.0, std::min(v / kRows, down - 1.0)));
    std::uint16_t& made = is_made_around_[static_cast<std::size_t>(row * across + column)];
    if (made > rows) continue;
    made = static_cast<std::uint16_t>(rows + 1);
    for (int r = std::max(0, row - rows); r <= std::min(row + rows, down - 1); ++r) {
      for (int c = std::max(0, column - columns); c <= std::min(column + columns, across - 1);
           ++c) {
        const auto tile = static_cast<std::size_t>(r * across + c);
        if (table_->isWritten(tile) || !field_->nearness().isWritten(tile)) continue;
        table_->write(tile);
        wanted.push_back(tile);
      }
    }
  }
  to_make_ -= wanted.size();
  parallelFor(wanted.size(), 64, [&](const Chunk& chunk) {
    for (std::size_t k = chunk.begin; k < chunk.end; ++k) {
      const std::uint16_t* near = field_->nearness().tile(wanted[k]);
      std::transform(near, near + SparseGrid::kTileSize, table_->write(wanted[k]),
                     [&](std::uint16_t n) { return by_nearness_[n]; });
    }
  });
}

void ScoreField::sum(const Eigen::ArrayXf& x, const Eigen::ArrayXf& y, const Particles& particles,
                     Eigen::Ref<Eigen::ArrayXd> sums) const {
  makeTiles(x, y, particles);
  sumUp(x, y, particles, sums);
}

void ScoreField::sumUp(const Eigen::ArrayXf& x, const Eigen::ArrayXf& y, const Particles& particles,
                       Eigen::Ref<Eigen::ArrayXd> sums) const {
  const Lattice& lattice = field_->lattice();
  const auto per_metre = static_cast<float>(1.0 / lattice.resolution());
  const Eigen::ArrayXf hit_x = x * per_metre;
  const Eigen::ArrayXf hit_y = y * per_metre;
  const int hits = static_cast<int>(std::min<Eigen::Index>(x.size(), kMaxHits));
  const SparseGrid& table = table_ ? *table_ : field_->nearness();
  const FieldView view{table.values(), table.stride(), static_cast<float>(lattice.width()) + 1.5F,
                       static_cast<float>(lattice.height()) + 1.5F,
                       table_ ? nullptr : by_nearness_.data()};
  parallelFor(static_cast<std::size_t>(particles.size()), kChunk, [&](const Chunk& chunk) {
    const Poses poses(lattice, particles, chunk);
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
  makeTiles(x, y, particles);
  for (Eigen::Index j = 0; j < x.size(); ++j) {
    sumUp(x.segment(j, 1), y.segment(j, 1), particles, values);
    share[j] = static_cast<double>((values > value).count()) /
               static_cast<double>(std::max<Eigen::Index>(1, particles.size()));
  }
  return share;
}

void ScoreField::usePortableInstructions(bool portable) {
  sum_kernel = portable ? sumPortable : fastestSum();
}

}  // namespace adaptive_localization
