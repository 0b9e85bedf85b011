// SPDX-License-Identifier: BSD-3-Clause
#include "swarm/range_objective.hpp"

#include <algorithm>
#include <cmath>

#include "core/parallel.hpp"
#include "map/ray_caster.hpp"

namespace adaptive_localization {
namespace {

constexpr std::uint32_t kNoRow = 0xFFFFFFFF;
constexpr std::size_t kCastChunk = 16, kTableChunk = 512;  // poses

template <class CostAt>
void evaluateEach(const Eigen::ArrayXXd& positions, Eigen::Ref<Eigen::ArrayXd> costs,
                  std::size_t chunk_size, const CostAt& cost_at) {
  parallelFor(static_cast<std::size_t>(positions.rows()), chunk_size, [&](const Chunk& chunk) {
    for (std::size_t k = chunk.begin; k < chunk.end; ++k) {
      const auto i = static_cast<Eigen::Index>(k);
      costs[i] = cost_at(Pose2{positions(i, 0), positions(i, 1), positions(i, 2)});
    }
  });
}

double wrapSteps(double steps) {
  return steps - kDirections * std::floor(steps / kDirections);
}

}  // namespace

double worstOf(const RangeObjectiveOptions& options) {
  constexpr double kTruncation = 0.25;  // m
  return options.swarm_error == "relative" ? 1.0 : kTruncation;
}

RangeObjective::RangeObjective(const RangeObjectiveOptions& options, const Scan& scan,
                               double max_range)
    : is_relative_(options.swarm_error == "relative"),
      worst_(worstOf(options)),
      max_range_(std::min(max_range, scan.max_range)),
      position_(scan.position) {
  std::vector<Beam> all;
  const auto add = [&](double bearing, double range) {
    if (std::isfinite(bearing) && std::isfinite(range)) all.push_back({bearing, range});
  };
  for (Eigen::Index j = 0; j < scan.range.size(); ++j) {
    add(scan.bearing[j], std::min<double>(scan.range[j], max_range_));
  }
  for (Eigen::Index j = 0; scan.range.size() > 0 && j < scan.no_return_bearing.size(); ++j) {
    add(scan.no_return_bearing[j], max_range_);
  }
  std::sort(all.begin(), all.end(),
            [](const Beam& a, const Beam& b) { return a.bearing < b.bearing; });
  const auto count = std::min(all.size(), static_cast<std::size_t>(options.swarm_beams));
  for (std::size_t k = 0; k < count; ++k) {
    beams_.push_back(all[(2 * k + 1) * all.size() / (2 * count)]);
  }
}

double RangeObjective::error(const Beam& beam, double expected) const {
  const double off = std::abs(expected - beam.range);
  return is_relative_ ? std::min(1.0, off / std::max(beam.range, 0.1)) : std::min(off, worst_);
}

RayCast castOverCells(std::shared_ptr<const OccupancyGrid> map,
                      std::shared_ptr<const DistanceField> field) {
  return [caster = RayCaster(std::move(map), std::move(field))](
             const Pose2& ray, double max_range) { return caster.range(ray, max_range); };
}

CastObjective::CastObjective(const RangeObjectiveOptions& options, const Scan& scan,
                             double max_range, std::shared_ptr<const OccupancyGrid> map,
                             RayCast cast)
    : RangeObjective(options, scan, max_range), map_(std::move(map)), cast_(std::move(cast)) {}

double CastObjective::costAt(const Pose2& T_map_base) const {
  const Eigen::Vector2d sensor = T_map_base * position_;
  if (!map_->isFree(map_->lattice().cellAt(sensor))) return worst_;
  double sum = 0.0;
  for (const Beam& beam : beams_) {
    const Pose2 ray{sensor.x(), sensor.y(), wrapAngle(T_map_base.theta + beam.bearing)};
    sum += error(beam, cast_(ray, max_range_));
  }
  return sum / static_cast<double>(beams_.size());
}

void CastObjective::evaluate(const Eigen::ArrayXXd& positions,
                             Eigen::Ref<Eigen::ArrayXd> costs) const {
  if (isEmpty()) {
    costs.setZero();
    return;
  }
  evaluateEach(positions, costs, kCastChunk, [this](const Pose2& pose) { return costAt(pose); });
}

RangeRows::RangeRows(std::shared_ptr<const RangeTable> table) : table_(std::move(table)) {
  const Lattice& lattice = table_->lattice();
  const int spacing = table_->spacing();
  width_ = (lattice.width() + spacing - 1) / spacing;
  const auto height = static_cast<std::size_t>((lattice.height() + spacing - 1) / spacing);
  rows_.assign(static_cast<std::size_t>(width_) * height, kNoRow);
  for (std::size_t i = 0; i < table_->size(); ++i) {
    const Cell cell = table_->cell(i);
    rows_[static_cast<std::size_t>(cell.y / spacing) * static_cast<std::size_t>(width_) +
          static_cast<std::size_t>(cell.x / spacing)] = static_cast<std::uint32_t>(i);
  }
}

const std::uint8_t* RangeRows::at(const Eigen::Vector2d& point_map) const {
  const Cell cell = table_->lattice().cellAt(point_map);
  if (!table_->lattice().contains(cell)) return nullptr;
  const int spacing = table_->spacing();
  const std::size_t at =
      static_cast<std::size_t>((cell.y + spacing / 2) / spacing) *
          static_cast<std::size_t>(width_) +
      static_cast<std::size_t>(std::min((cell.x + spacing / 2) / spacing, width_ - 1));
  return at < rows_.size() && rows_[at] != kNoRow ? table_->ranges(rows_[at]) : nullptr;
}

TableObjective::TableObjective(const RangeObjectiveOptions& options, const Scan& scan,
                               std::shared_ptr<const RangeRows> rows)
    : RangeObjective(options, scan, rows->table().maxRange()), rows_(std::move(rows)) {
  const RangeTable& table = rows_->table();
  for (const Beam& beam : beams_) {
    const double in_lattice = beam.bearing - table.lattice().origin().theta;
    steps_.push_back(wrapSteps(in_lattice / kDirectionStep));
    for (int step = 0; step <= kNoReturn; ++step) {
      const double expected = std::min(step * table.metresPerStep(), max_range_);
      errors_.push_back(
          static_cast<float>(error(beam, expected) / static_cast<double>(beams_.size())));
    }
  }
}

double TableObjective::costAt(const Pose2& T_map_base) const {
  const std::uint8_t* ranges = rows_->at(T_map_base * position_);
  if (!ranges) return worst_;
  const double heading = wrapSteps(T_map_base.theta / kDirectionStep) + 0.5;
  float sum = 0.0F;
  const float* errors = errors_.data();
  for (const double bearing : steps_) {
    const int direction = static_cast<int>(heading + bearing);
    sum += errors[ranges[direction < kDirections       ? direction
                         : direction < 2 * kDirections ? direction - kDirections
                                                       : direction - 2 * kDirections]];
    errors += kNoReturn + 1;
  }
  return static_cast<double>(sum);
}

void TableObjective::evaluate(const Eigen::ArrayXXd& positions,
                              Eigen::Ref<Eigen::ArrayXd> costs) const {
  if (isEmpty()) {
    costs.setZero();
    return;
  }
  evaluateEach(positions, costs, kTableChunk, [this](const Pose2& pose) { return costAt(pose); });
}

}  // namespace adaptive_localization
