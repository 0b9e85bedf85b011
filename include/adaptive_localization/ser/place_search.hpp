// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "adaptive_localization/core/observations.hpp"
#include "adaptive_localization/ser/global_search.hpp"
#include "adaptive_localization/ser/place.hpp"

namespace adaptive_localization {

class PoseSearch;

/// A global search for one scan, done in parts: what it finds does not depend on how it is parted.
class PlaceSearch {
 public:
  PlaceSearch(std::shared_ptr<const GlobalSearch> search, const Scan& scan);
  ~PlaceSearch();

  /// Goes on for as much work as is left; whether all is done but what places() does.
  bool advance(SearchWork& left);

  /// The distinct places, once the rest is done: refined below the lattice's spacing and judged by
  /// the scan that is taken a motion after the one that was searched for, best first.
  std::vector<Place> places(const Pose2& motion, const Scan& scan) const;

  /// The work that places() takes.
  SearchWork lastWork() const;

 private:
  bool findPoses(SearchWork& left);
  bool partPoses(SearchWork& left);
  Pose2 poseOf(const SearchPose& pose) const;

  std::shared_ptr<const GlobalSearch> search_;
  std::unique_ptr<PoseSearch> pose_search_;  // until it is done; none for a scan without hits
  std::vector<SearchPose> poses_;
  std::size_t next_pose_{0};
  std::vector<Pose2> distinct_;
};

/// The places where a scan can have been taken, by a search that is done at once.
std::vector<Place> findPlaces(std::shared_ptr<const GlobalSearch> search, const Scan& scan);

}  // namespace adaptive_localization
