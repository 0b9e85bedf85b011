// SPDX-License-Identifier: BSD-3-Clause
#include "ser/energy_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "core/parallel.hpp"

namespace adaptive_localization {
namespace {

/// A laser that sees all round sees the same in all headings, if its beams are close together.
int orientationsFor(const ScanGeometry& geometry, const EnergyGridOptions& options) {
  return geometry.beams() == kDirections ? 1 : options.energy_orientations;
}

/// The directions of the beams that make an energy, evenly spread over those that the laser has.
std::vector<int> energyDirections(const ScanGeometry& geometry, const EnergyGridOptions& options) {
  const int count = std::min(options.energy_beams, geometry.beams());
  std::vector<int> directions;
  for (int k = 0; k < count; ++k) {
    directions.push_back(geometry.directionOf(k * geometry.beams() / count) % kDirections);
  }
  return directions;
}

/// For each direction of beam 0, the sum of the ranges of some directions from it on.
class BeamSums {
 public:
  using Sums = std::array<std::uint16_t, kDirections>;

  explicit BeamSums(const std::vector<int>& directions) : directions_(directions) {}

  const Sums& of(const std::uint8_t* ranges) {
    std::copy(ranges, ranges + kDirections, twice_round_.begin());
    std::copy(ranges, ranges + kDirections, twice_round_.begin() + kDirections);
    sums_.fill(0);
    for (const int direction : directions_) {
      const std::uint8_t* from = twice_round_.data() + direction;
      for (std::size_t i = 0; i < kDirections; ++i) {
        sums_[i] = static_cast<std::uint16_t>(sums_[i] + from[i]);
      }
    }
    return sums_;
  }

 private:
  const std::vector<int>& directions_;
  std::array<std::uint8_t, 2 * kDirections> twice_round_;
  Sums sums_;
};

}  // namespace

int EnergyGrid::spacingAskedFor(const OccupancyGrid& map, const EnergyGridOptions& options) {
  constexpr double kRounding = 1e-6;  // 0.1 m are two cells of 0.05 m, as float has it or double
  const double cells = options.energy_grid_pitch / map.lattice().resolution();
  return std::max(1, static_cast<int>(std::floor(cells + kRounding)));
}

int EnergyGrid::spacingFor(const OccupancyGrid& map, const ScanGeometry& geometry,
                           const EnergyGridOptions& options) {
  constexpr double kSearchBytes = 2.0 * kRangeStride / 16.0;  // see RangeBlocks
  const double per_cell = kSearchBytes + double{kRangeStride} +
                          double{sizeof(std::uint32_t)} * (1 + orientationsFor(geometry, options));
  const double needed = static_cast<double>(map.countFree()) * per_cell;
  const double limit = 1e6 * options.energy_grid_max_memory;
  return std::max(spacingAskedFor(map, options),
                  static_cast<int>(std::ceil(std::sqrt(needed / limit))));
}

EnergyGrid::EnergyGrid(const OccupancyGrid& map, const ScanGeometry& geometry,
                       const EnergyGridOptions& options, const SweepProgress& progress)
    : EnergyGrid(
          std::make_shared<const RangeTable>(
              map, geometry.max_range, spacingFor(map, geometry, options), StopToken{}, progress),
          geometry, options) {}

EnergyGrid::EnergyGrid(std::shared_ptr<const RangeTable> ranges, const ScanGeometry& geometry,
                       const EnergyGridOptions& options)
    : ranges_(std::move(ranges)),
      geometry_(geometry),
      orientations_(orientationsFor(geometry, options)),
      directions_(energyDirections(geometry, options)),
      ser_delta_(options.ser_delta) {}

/// Direction of beam 0 for a heading, in [0, kDirections).
int EnergyGrid::firstDirection(int orientation) const {
  return orientation * kDirections / orientations_;
}

/// By whoever asks first; others wait.
const EnergyGrid::Sorted& EnergyGrid::sorted() const {
  std::call_once(is_sorted_, [this] { sorted_ = sort(); });
  return sorted_;
}

/// Counting sort: sums are small integers.
EnergyGrid::Sorted EnergyGrid::sort() const {
  std::vector<std::uint16_t> sums(size());
  parallelFor(ranges_->size(), 4096, [&](const Chunk& chunk) {
    BeamSums beam_sums(directions_);
    std::uint16_t* sum = sums.data() + chunk.begin * static_cast<std::size_t>(orientations_);
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const BeamSums::Sums& of_cell = beam_sums.of(ranges_->ranges(i));
      for (int o = 0; o < orientations_; ++o) {
        *sum++ = of_cell[static_cast<std::size_t>(firstDirection(o))];
      }
    }
  });
  std::vector<std::uint32_t> starts(countSums() + 1, 0);
  for (const std::uint16_t sum : sums) ++starts[sum + 1U];
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  std::vector<std::uint32_t> next(starts.begin(), starts.end() - 1);
  std::vector<std::uint32_t> poses(sums.size());
  for (std::size_t i = 0; i < poses.size(); ++i)
    poses[next[sums[i]]++] = static_cast<std::uint32_t>(i);
  return {std::move(poses), std::move(starts)};
}

std::optional<ScanEnergy> EnergyGrid::energyOf(const Scan& scan) const {
  double sum = 0.0;
  int valid = 0;
  for (const int direction : directions_) {
    const int range = rangeIn(direction, scan, geometry_);
    if (range < 0) continue;
    sum += range;
    ++valid;
  }
  if (valid == 0) return std::nullopt;
  const double masked = 1.0 - static_cast<double>(valid) / beams();
  return ScanEnergy{1.0 - sum / (valid * kNoReturn), ser_delta_ + 0.5 * masked};
}

EnergyGrid::Region EnergyGrid::similarTo(const ScanEnergy& energy) const {
  const double most = beams() * kNoReturn;
  // |E - e| < delta, where E = 1 - sum / most
  const double low = (1.0 - energy.value - energy.delta) * most;
  const double high = (1.0 - energy.value + energy.delta) * most;
  const std::vector<std::uint32_t>& starts = sorted().starts;
  const auto end = static_cast<double>(starts.size() - 1);
  const auto first = std::clamp(std::floor(low) + 1.0, 0.0, end);
  const auto last = std::clamp(std::ceil(high), first, end);
  return {starts[static_cast<std::size_t>(first)], starts[static_cast<std::size_t>(last)]};
}

double EnergyGrid::energy(std::size_t i) const {
  const std::vector<std::uint32_t>& starts = sorted().starts;
  const auto after = std::upper_bound(starts.begin(), starts.end(), i);
  return 1.0 - static_cast<double>(after - starts.begin() - 1) / (beams() * kNoReturn);
}

Pose2 EnergyGrid::pose(std::size_t i) const {
  return pose(i, Eigen::Vector3d::Zero());
}

Pose2 EnergyGrid::pose(std::size_t i, const Eigen::Vector3d& jitter) const {
  const auto orientations = static_cast<std::uint32_t>(orientations_);
  const std::uint32_t pose = sorted().poses[i];
  const std::uint32_t cell = pose / orientations;
  const int orientation = static_cast<int>(pose % orientations);
  const double step = ranges_->lattice().resolution() * ranges_->spacing();
  const Eigen::Vector2d sensor = ranges_->centre(cell) + step * jitter.head<2>();
  const double turned = ranges_->lattice().origin().theta + headingStep() * jitter.z();
  const Pose2 heading{0.0, 0.0,
                      wrapAngle(geometry_.headingOf(firstDirection(orientation)) + turned)};
  const Eigen::Vector2d base = sensor - heading * geometry_.position;
  return {base.x(), base.y(), heading.theta};
}

}  // namespace adaptive_localization
