// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/ser/place_search.hpp"

#include <algorithm>
#include <utility>

#include "place_refiner.hpp"
#include "pose_search.hpp"

namespace adaptive_localization {
namespace {

// Work as that of looking at so many poses.
constexpr SearchWork kRefinedPlace = 500;
constexpr SearchWork kComparisons = 4;  // with places that are distinct, like looking at one pose

}  // namespace

PlaceSearch::PlaceSearch(std::shared_ptr<const GlobalSearch> search, const Scan& scan)
    : search_(std::move(search)) {
  const DirectionalScan beams = toDirections(scan, search_->geometry());
  if (scan.hits() > 0 && beams.valid > 0) pose_search_ = search_->begin(beams);
}

PlaceSearch::~PlaceSearch() = default;

bool PlaceSearch::advance(SearchWork& left) {
  return findPoses(left) && partPoses(left);
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
    const auto same = std::find_if(distinct_.begin(), distinct_.end(), [&](const Pose2& other) {
      return areSamePlace(T_map_base, other);
    });
    left -= 1 + (same - distinct_.begin()) / kComparisons;
    if (same == distinct_.end()) distinct_.push_back(T_map_base);
  }
  return true;
}

SearchWork PlaceSearch::lastWork() const {
  return kRefinedPlace * static_cast<SearchWork>(distinct_.size());
}

std::vector<Place> PlaceSearch::places(const Pose2& motion, const Scan& scan) const {
  const auto refiner = search_->refinerFor(scan);
  std::vector<Place> places;
  for (const Pose2& pose : distinct_) places.push_back(refiner->refine(pose * motion));
  std::stable_sort(places.begin(), places.end(),
                   [](const Place& a, const Place& b) { return a.error < b.error; });
  return distinctPlaces(places);
}

std::vector<Place> findPlaces(std::shared_ptr<const GlobalSearch> search, const Scan& scan) {
  PlaceSearch parts(std::move(search), scan);
  SearchWork unlimited = kUnlimitedWork;
  parts.advance(unlimited);
  return parts.places({}, scan);
}

}  // namespace adaptive_localization
