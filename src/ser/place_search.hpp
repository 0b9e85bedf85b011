// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "adaptive_localization/core/observations.hpp"
#include "ser/global_search.hpp"
#include "ser/place.hpp"
#include "ser/place_map.hpp"

namespace adaptive_localization {

class PlaceRefiner;
class PoseSearch;

/// A global search for one scan, done in parts: what it finds does not depend on how it is parted.
class PlaceSearch {
 public:
  PlaceSearch(std::shared_ptr<const GlobalSearch> search, const Scan& scan);
  ~PlaceSearch();

  /// Goes on for as much work as is left; whether all is done.
  bool advance(SearchWork& left);

  /// The distinct places, once all is done, best first.
  const std::vector<Place>& places() const { return places_; }

  /// The same for a robot that moved on since: on the odometry, the best thirty judged by the scan
  /// that it takes now, and where that scan fits best nearby for those that it fits best already.
  std::vector<Place> placesAfter(const Pose2& motion, const Scan& scan) const;

  /// The work that placesAfter() takes.
  SearchWork workAfter() const;

 private:
  bool findPoses(SearchWork& left);
  bool partPoses(SearchWork& left);
  bool refinePlaces(SearchWork& left);
  Pose2 poseOf(const SearchPose& pose) const;

  std::shared_ptr<const GlobalSearch> search_;
  const Scan scan_;
  std::unique_ptr<const PlaceRefiner> refiner_;  // of that scan
  std::unique_ptr<PoseSearch> pose_search_;      // until it is done; none for a scan without hits
  std::vector<SearchPose> poses_;
  std::size_t next_pose_{0};
  std::vector<Pose2> distinct_;
  PlaceMap near_;           // of those
  std::size_t refined_{0};  // of those
  std::vector<Place> places_;
};

/// The places where a scan can have been taken, by a search that is done at once.
std::vector<Place> findPlaces(std::shared_ptr<const GlobalSearch> search, const Scan& scan);

}  // namespace adaptive_localization
