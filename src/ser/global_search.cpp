// SPDX-License-Identifier: BSD-3-Clause
#include "ser/global_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "place_refiner.hpp"
#include "pose_search.hpp"

namespace adaptive_localization {

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

PoseSearchLimits GlobalSearch::limitsFor(const DirectionalScan& scan) const {
  const auto all = std::numeric_limits<std::size_t>::max();
  const auto most = static_cast<std::size_t>(options_.search_max_visits);
  return {truncation(), steps(options_.search_margin, scan), steps(options_.search_max_error, scan),
          most == 0 ? all : most};
}

std::unique_ptr<PoseSearch> GlobalSearch::begin(const DirectionalScan& scan) const {
  return std::make_unique<PoseSearch>(grid_->sharedRanges(), scan, limitsFor(scan));
}

std::unique_ptr<const PlaceRefiner> GlobalSearch::refinerFor(const Scan& scan) const {
  return std::make_unique<const PlaceRefiner>(map_, field_, scan, scan.max_range,
                                              options_.search_truncation);
}

std::vector<SearchPose> GlobalSearch::findPoses(const DirectionalScan& scan) const {
  const auto search = begin(scan);
  SearchWork unlimited = kUnlimitedWork;
  search->advance(unlimited);
  visited_share_ =
      static_cast<double>(search->visited()) / (static_cast<double>(ranges().size()) * kDirections);
  return search->takePoses();
}

}  // namespace adaptive_localization
