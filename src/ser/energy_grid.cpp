// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/ser/energy_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "adaptive_localization/parallel.hpp"

namespace adaptive_localization {
namespace {

/// A laser that sees all round sees the same in all headings.
int orientationsFor(const ScanGeometry& geometry, const EnergyGridOptions& options) {
  return geometry.count == kDirections ? 1 : options.energy_orientations;
}

/// For each direction, the sum of the ranges of `beams` directions, `step` apart, from it on: by
/// doubling, from sums of 1, 2, 4 and so on.
class BeamSums {
 public:
  using Sums = std::array<std::uint16_t, kDirections>;

  BeamSums(int beams, int step) : beams_(beams), step_(step) {}

  const Sums& of(const std::uint8_t* ranges) {
    std::copy(ranges, ranges + kDirections, doubled_.begin());
    total_.fill(0);
    int summed = 0;  // beams in total_
    for (int many = 1;; many *= 2) {
      if ((beams_ & many) != 0) {
        add(doubled_, summed * step_, total_);
        summed += many;
      }
      if (summed == beams_) return total_;
      const Sums single = doubled_;
      add(single, many * step_, doubled_);
    }
  }

 private:
  /// to[i] += from[i + shift], round the circle.
  static void add(const Sums& from, int shift, Sums& to) {
    const auto turned = static_cast<std::size_t>(shift % kDirections);
    const std::size_t whole = kDirections - turned;
    for (std::size_t i = 0; i < whole; ++i) {
      to[i] = static_cast<std::uint16_t>(to[i] + from[i + turned]);
    }
    for (std::size_t i = whole; i < kDirections; ++i) {
      to[i] = static_cast<std::uint16_t>(to[i] + from[i - whole]);
    }
  }

  int beams_, step_;
  Sums doubled_, total_;
};

}  // namespace

int EnergyGrid::spacingFor(const OccupancyGrid& map, const ScanGeometry& geometry,
                           const EnergyGridOptions& options) {
  constexpr double kSearchBytes = 2.0 * RangeTable::kStride / 16.0;  // see RangeBlocks
  const double per_cell = RangeTable::kStride + sizeof(std::uint32_t) + kSearchBytes +
                          sizeof(std::uint32_t) * orientationsFor(geometry, options);
  const double needed = static_cast<double>(map.countFree()) * per_cell;
  const double limit = 1e6 * options.energy_grid_max_memory;
  return std::max(1, static_cast<int>(std::ceil(std::sqrt(needed / limit))));
}

EnergyGrid::EnergyGrid(const OccupancyGrid& map, const ScanGeometry& geometry,
                       const EnergyGridOptions& options, const SweepProgress& progress)
    : EnergyGrid(
          std::make_shared<const RangeTable>(
              map, geometry.max_range, spacingFor(map, geometry, options), StopToken{}, progress),
          geometry, options) {}

EnergyGrid::EnergyGrid(std::shared_ptr<const RangeTable> ranges, const ScanGeometry& geometry,
                       const EnergyGridOptions& options, const StopToken& stop)
    : EnergyGrid(std::move(ranges), geometry, options, Sorted{}) {
  sorted_ = sort(stop);
}

EnergyGrid::EnergyGrid(std::shared_ptr<const RangeTable> ranges, const ScanGeometry& geometry,
                       const EnergyGridOptions& options, Sorted sorted)
    : ranges_(std::move(ranges)),
      geometry_(geometry),
      orientations_(orientationsFor(geometry, options)),
      beams_(std::min(options.energy_beams, geometry.count)),
      beam_step_(std::max(1, geometry.count / beams_)),
      ser_delta_(options.ser_delta),
      sorted_(std::move(sorted)) {}

/// Direction of beam 0 for a heading, in [0, kDirections).
int EnergyGrid::firstDirection(int orientation) const {
  return orientation * kDirections / orientations_;
}

/// Counting sort: sums are small integers.
EnergyGrid::Sorted EnergyGrid::sort(const StopToken& stop) const {
  const std::size_t poses = ranges_->size() * static_cast<std::size_t>(orientations_);
  std::vector<std::uint16_t> sums(poses);
  parallelFor(ranges_->size(), 4096, [&](const Chunk& chunk) {
    stop.check();
    BeamSums beam_sums(beams_, beam_step_);
    std::uint16_t* sum = sums.data() + chunk.begin * static_cast<std::size_t>(orientations_);
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const BeamSums::Sums& of_cell = beam_sums.of(ranges_->ranges(i));
      for (int o = 0; o < orientations_; ++o) {
        *sum++ = of_cell[static_cast<std::size_t>(firstDirection(o))];
      }
    }
  });
  std::vector<std::uint32_t> starts(static_cast<std::size_t>(beams_ * kNoReturn) + 2, 0);
  for (const std::uint16_t sum : sums) ++starts[sum + 1U];
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  stop.check();
  std::vector<std::uint32_t> next(starts.begin(), starts.end() - 1);
  std::vector<std::uint32_t> sorted(poses);
  for (std::size_t i = 0; i < poses; ++i) sorted[next[sums[i]]++] = static_cast<std::uint32_t>(i);
  return {ConstArray<std::uint32_t>(std::move(sorted)),
          ConstArray<std::uint32_t>(std::move(starts))};
}

std::optional<ScanEnergy> EnergyGrid::energyOf(const Scan& scan) const {
  const DirectionalScan beams = toDirections(scan, geometry_);
  double sum = 0.0;
  int valid = 0;
  for (int k = 0; k < beams_; ++k) {
    const int range = beams.range[static_cast<std::size_t>(k * beam_step_)];
    if (range < 0) continue;
    sum += range;
    ++valid;
  }
  if (valid == 0) return std::nullopt;
  const double masked = 1.0 - static_cast<double>(valid) / beams_;
  return ScanEnergy{1.0 - sum / (valid * kNoReturn), ser_delta_ + 0.5 * masked};
}

EnergyGrid::Region EnergyGrid::similarTo(const ScanEnergy& energy) const {
  const double most = beams_ * kNoReturn;
  // |E - e| < delta, where E = 1 - sum / most
  const double low = (1.0 - energy.value - energy.delta) * most;
  const double high = (1.0 - energy.value + energy.delta) * most;
  const auto end = static_cast<double>(sorted_.starts.size() - 1);
  const auto first = std::clamp(std::floor(low) + 1.0, 0.0, end);
  const auto last = std::clamp(std::ceil(high), first, end);
  return {sorted_.starts[static_cast<std::size_t>(first)],
          sorted_.starts[static_cast<std::size_t>(last)]};
}

double EnergyGrid::energy(std::size_t i) const {
  const auto after = std::upper_bound(sorted_.starts.begin(), sorted_.starts.end(), i);
  return 1.0 - static_cast<double>(after - sorted_.starts.begin() - 1) / (beams_ * kNoReturn);
}

Pose2 EnergyGrid::pose(std::size_t i) const {
  return pose(i, Eigen::Vector3d::Zero());
}

Pose2 EnergyGrid::pose(std::size_t i, const Eigen::Vector3d& jitter) const {
  const auto orientations = static_cast<std::uint32_t>(orientations_);
  const std::uint32_t cell = sorted_.poses[i] / orientations;
  const int orientation = static_cast<int>(sorted_.poses[i] % orientations);
  const double step = ranges_->lattice().resolution() * ranges_->spacing();
  const Eigen::Vector2d sensor = ranges_->centre(cell) + step * jitter.head<2>();
  const double turned = ranges_->lattice().origin().theta + headingStep() * jitter.z();
  const Pose2 heading{0.0, 0.0,
                      wrapAngle(geometry_.headingOf(firstDirection(orientation)) + turned)};
  const Eigen::Vector2d base = sensor - heading * geometry_.position;
  return {base.x(), base.y(), heading.theta};
}

std::size_t EnergyGrid::bytes() const {
  return ranges_->bytes() + sorted_.poses.bytes() + sorted_.starts.bytes();
}

}  // namespace adaptive_localization
