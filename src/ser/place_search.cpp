// SPDX-License-Identifier: BSD-3-Clause
#include "ser/place_search.hpp"

#include <algorithm>
#include <utility>

#include "core/parallel.hpp"
#include "place_refiner.hpp"
#include "pose_search.hpp"

namespace adaptive_localization {
namespace {

// Work as that of looking at so many poses.
constexpr SearchWork kRefinedPlace = 3000;
constexpr SearchWork kJudgedPlace = 2000;
constexpr SearchWork kComparedPose = 8;  // with the places near it

constexpr std::size_t kJudgedAfter = 30, kRefinedAfter = 8;  // places

std::vector<Place> bestFirst(std::vector<Place> places) {
  std::stable_sort(places.begin(), places.end(), fitsBetter);
  return distinctPlaces(places);
}

}  // namespace

PlaceSearch::PlaceSearch(std::shared_ptr<const GlobalSearch> search, const Scan& scan)
    : search_(std::move(search)), scan_(scan), refiner_(search_->refinerFor(scan_)) {
  const DirectionalScan beams = toDirections(scan, search_->geometry());
  if (scan.hits() > 0 && beams.valid > 0) pose_search_ = search_->begin(beams);
}

PlaceSearch::~PlaceSearch() = default;

bool PlaceSearch::advance(SearchWork& left) {
  return findPoses(left) && partPoses(left) && refinePlaces(left);
}

bool PlaceSearch::findPoses(SearchWork& left) {
  if (!pose_search_) return true;
  if (!pose_search_->advance(left)) return false;
  poses_ = pose_search_->takePoses();
  pose_search_.reset();
  return true;
}

Pose2 PlaceSearch::poseOf(const SearchPose& pose) const {
  const RangeTable& table = search_->ranges();
  const double turn = table.lattice().origin().theta;
  const Pose2 heading{0.0, 0.0, wrapAngle(search_->geometry().headingOf(pose.direction) + turn)};
  const Eigen::Vector2d base = table.centre(pose.cell) - heading * search_->geometry().position;
  return {base.x(), base.y(), heading.theta};
}

/// The best pose of each place.
bool PlaceSearch::partPoses(SearchWork& left) {
  const auto most = static_cast<std::size_t>(search_->options().search_max_places);
  for (; next_pose_ < poses_.size() && distinct_.size() < most; ++next_pose_) {
    if (left <= 0) return false;
    const Pose2 T_map_base = poseOf(poses_[next_pose_]);
    if (!near_.hasSame(T_map_base)) {
      near_.add(T_map_base);
      distinct_.push_back(T_map_base);
    }
    left -= kComparedPose;
  }
  return true;
}

/// Below the lattice's spacing; all threads do, as many at once as there is work left for.
bool PlaceSearch::refinePlaces(SearchWork& left) {
  constexpr SearchWork kAtOnce = 8;
  if (refined_ == 0) places_.resize(distinct_.size());
  while (refined_ < distinct_.size()) {
    if (left <= 0) return false;
    const auto paid =
        static_cast<std::size_t>(std::clamp(left / kRefinedPlace, SearchWork{1}, kAtOnce));
    const std::size_t count = std::min(paid, distinct_.size() - refined_);
    parallelFor(count, 1, [&](const Chunk& chunk) {
      const std::size_t i = refined_ + chunk.begin;
      places_[i] = refiner_->refine(distinct_[i]);
    });
    refined_ += count;
    left -= kRefinedPlace * static_cast<SearchWork>(count);
  }
  places_ = bestFirst(std::move(places_));
  return true;
}

SearchWork PlaceSearch::workAfter() const {
  const auto judged = static_cast<SearchWork>(std::min(kJudgedAfter, places_.size()));
  const auto refined = static_cast<SearchWork>(std::min(kRefinedAfter, places_.size()));
  return kJudgedPlace * judged + kRefinedPlace * refined;
}

std::vector<Place> PlaceSearch::placesAfter(const Pose2& motion, const Scan& scan) const {
  const auto refiner = search_->refinerFor(scan);
  std::vector<Place> places = places_;
  for (Place& place : places) place.T_map_base = place.T_map_base * motion;
  parallelFor(std::min(kJudgedAfter, places.size()), 8, [&](const Chunk& chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      places[i].error = refiner->error(places[i].T_map_base);
    }
  });
  std::stable_sort(places.begin(), places.end(), fitsBetter);
  parallelFor(std::min(kRefinedAfter, places.size()), 1, [&](const Chunk& chunk) {
    places[chunk.begin] = refiner->refine(places[chunk.begin].T_map_base);
  });
  return bestFirst(std::move(places));
}

std::vector<Place> findPlaces(std::shared_ptr<const GlobalSearch> search, const Scan& scan) {
  PlaceSearch parts(std::move(search), scan);
  SearchWork unlimited = kUnlimitedWork;
  parts.advance(unlimited);
  return parts.places();
}

}  // namespace adaptive_localization
