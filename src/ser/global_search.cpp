// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/ser/global_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "adaptive_localization/core/parallel.hpp"
#include "place_refiner.hpp"
#include "range_blocks.hpp"
#include "range_kernel.hpp"
#include "scan_targets.hpp"

namespace adaptive_localization {
namespace {

constexpr int kHeadingsPerGroup = 3;

const RangeKernel kSumOfDistances = fastestSumOfDistances();

bool isBefore(const SearchPose& a, const SearchPose& b) {
  return std::tie(a.cost, a.cell, a.direction) < std::tie(b.cost, b.cell, b.direction);
}

/// The best poses so far: those within the margin of the best, and the first kMost of them at the
/// most, so that a scan that fits everywhere does not fill the memory.
class BestPoses {
 public:
  static constexpr std::size_t kMost = 100000;

  /// Poses of more than the greatest cost are none at all.
  BestPoses(int margin, int greatest) : margin_(margin), limit_(greatest) {}

  int limit() const { return limit_; }

  void add(const SearchPose& pose) {
    if (pose.cost > limit_) return;
    poses_.push_back(pose);
    limit_ = std::min(limit_, pose.cost + margin_);
    if (poses_.size() == 2 * kMost) drop();
  }

  std::vector<SearchPose> sorted() {
    drop();
    std::sort(poses_.begin(), poses_.end(), isBefore);
    return std::move(poses_);
  }

 private:
  void drop() {
    const auto worse = [this](const SearchPose& pose) { return pose.cost > limit_; };
    poses_.erase(std::remove_if(poses_.begin(), poses_.end(), worse), poses_.end());
    if (poses_.size() <= kMost) return;
    const auto last = poses_.begin() + (kMost - 1);
    std::nth_element(poses_.begin(), last, poses_.end(), isBefore);
    limit_ = last->cost;
    poses_.resize(kMost);
  }

  int margin_;
  int limit_;
  std::vector<SearchPose> poses_;
};

/// Indices of values, ascending by value; a counting sort.
std::vector<std::uint32_t> ascending(const std::vector<std::uint16_t>& values) {
  const std::uint16_t most = values.empty() ? 0 : *std::max_element(values.begin(), values.end());
  std::vector<std::uint32_t> starts(most + 2U, 0);
  for (const std::uint16_t value : values) ++starts[value + 1U];
  for (std::size_t i = 1; i < starts.size(); ++i) starts[i] += starts[i - 1];
  std::vector<std::uint32_t> order(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    order[starts[values[i]]++] = static_cast<std::uint32_t>(i);
  }
  return order;
}

}  // namespace

GlobalSearch::GlobalSearch(std::shared_ptr<const EnergyGrid> grid,
                           std::shared_ptr<const OccupancyGrid> map,
                           std::shared_ptr<const DistanceField> field,
                           const GlobalSearchOptions& options)
    : grid_(std::move(grid)), map_(std::move(map)), field_(std::move(field)), options_(options) {}

int GlobalSearch::truncation() const {
  const double steps = options_.search_truncation / grid_->ranges().metresPerStep();
  return static_cast<int>(std::clamp(std::round(steps), 1.0, 255.0));
}

int GlobalSearch::steps(double error, const DirectionalScan& scan) const {
  const double worst = static_cast<double>(kRangeStride) * kNoReturn;
  const double steps = std::ceil(error * scan.valid / grid_->ranges().metresPerStep());
  return static_cast<int>(std::min(steps, worst));
}

std::size_t GlobalSearch::mostVisits() const {
  return options_.search_max_visits == 0 ? std::numeric_limits<std::size_t>::max()
                                         : static_cast<std::size_t>(options_.search_max_visits);
}

/// Bounds of all blocks and heading groups: [block * groups + group].
std::vector<std::uint16_t> GlobalSearch::bounds(const DirectionalScan& scan) const {
  const RangeBlocks& blocks = grid_->ranges().blocks();
  const ScanTargets groups(scan, kHeadingsPerGroup);
  const auto per_block = static_cast<std::size_t>(groups.size());
  std::vector<std::uint16_t> bounds(blocks.size() * per_block);
  const int most = truncation();
  parallelFor(blocks.size(), 256, [&](const Chunk& chunk) {
    for (std::size_t b = chunk.begin; b < chunk.end; ++b) {
      for (int g = 0; g < groups.size(); ++g) {
        bounds[b * per_block + static_cast<std::size_t>(g)] = static_cast<std::uint16_t>(
            kSumOfDistances(blocks.low(b), blocks.high(b), groups.low(g), groups.high(g), most));
      }
    }
  });
  return bounds;
}

std::vector<SearchPose> GlobalSearch::findPoses(const DirectionalScan& scan) const {
  const RangeTable& table = grid_->ranges();
  const RangeBlocks& blocks = table.blocks();
  const ScanTargets targets(scan, 1);
  const int most = truncation();
  const std::vector<std::uint16_t> bound = bounds(scan);
  constexpr std::size_t kGroups = kDirections / kHeadingsPerGroup;
  BestPoses best(steps(options_.search_margin, scan), steps(options_.search_max_error, scan));
  std::size_t visited = 0;
  for (const std::uint32_t node : ascending(bound)) {
    if (bound[node] > best.limit() || visited >= mostVisits()) break;
    const std::size_t block = node / kGroups;
    const int first = static_cast<int>(node % kGroups) * kHeadingsPerGroup;
    for (const std::uint32_t* cell = blocks.begin(block); cell != blocks.end(block); ++cell) {
      const std::uint8_t* ranges = table.ranges(*cell);
      for (int d = first; d < first + kHeadingsPerGroup; ++d) {
        best.add(
            {*cell, d, kSumOfDistances(ranges, ranges, targets.low(d), targets.high(d), most)});
      }
      visited += kHeadingsPerGroup;
    }
  }
  visited_share_ = static_cast<double>(visited) / (static_cast<double>(table.size()) * kDirections);
  return best.sorted();
}

std::vector<SearchPose> GlobalSearch::findPosesPlainly(const DirectionalScan& scan) const {
  const RangeTable& table = grid_->ranges();
  const ScanTargets targets(scan, 1);
  const int most = truncation();
  BestPoses best(steps(options_.search_margin, scan), steps(options_.search_max_error, scan));
  for (std::uint32_t cell = 0; cell < table.size(); ++cell) {
    const std::uint8_t* ranges = table.ranges(cell);
    for (int d = 0; d < kDirections; ++d) {
      best.add({cell, d, kSumOfDistances(ranges, ranges, targets.low(d), targets.high(d), most)});
    }
  }
  visited_share_ = 1.0;
  return best.sorted();
}

std::vector<Place> GlobalSearch::find(const Scan& scan) const {
  const DirectionalScan beams = toDirections(scan, grid_->geometry());
  if (scan.hits() == 0 || beams.valid == 0) return {};
  const PlaceRefiner refiner(map_, field_, scan, scan.max_range, options_.search_truncation);
  const double turn = grid_->ranges().lattice().origin().theta;
  std::vector<Pose2> distinct;
  for (const SearchPose& pose : findPoses(beams)) {
    const Pose2 heading{0.0, 0.0, wrapAngle(grid_->geometry().headingOf(pose.direction) + turn)};
    const Eigen::Vector2d base =
        grid_->ranges().centre(pose.cell) - heading * grid_->geometry().position;
    const Pose2 T_map_base{base.x(), base.y(), heading.theta};
    const auto isSame = [&](const Pose2& other) { return areSamePlace(T_map_base, other); };
    if (std::any_of(distinct.begin(), distinct.end(), isSame)) continue;
    distinct.push_back(T_map_base);
    if (distinct.size() >= static_cast<std::size_t>(options_.search_max_places)) break;
  }
  std::vector<Place> places;
  for (const Pose2& pose : distinct) places.push_back(refiner.refine(pose));
  std::stable_sort(places.begin(), places.end(),
                   [](const Place& a, const Place& b) { return a.error < b.error; });
  return distinctPlaces(places);
}

}  // namespace adaptive_localization
