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

class PlaceRefiner;
class PoseSearch;

/// A global search for one scan, done in parts: what it finds does not depend on how it is parted.
class PlaceSearch {
 public:
  PlaceSearch(std::shared_ptr<const GlobalSearch> search, Scan scan);
  ~PlaceSearch();

  /// Goes on for as much work as is left; whether all is done.
  bool advance(SearchWork& left);

  /// Distinct places, refined below the lattice's spacing, best first, once all is done.
  std::vector<Place> takePlaces();

 private:
  bool findPoses(SearchWork& left);
  bool partPoses(SearchWork& left);
  bool refine(SearchWork& left);
  Pose2 poseOf(const SearchPose& pose) const;

  std::shared_ptr<const GlobalSearch> search_;
  Scan scan_;
  std::unique_ptr<PoseSearch> pose_search_;  // until it is done; none for a scan without hits
  std::unique_ptr<const PlaceRefiner> refiner_;
  std::vector<SearchPose> poses_;
  std::size_t next_pose_{0};
  std::vector<Pose2> distinct_;
  std::vector<Place> places_;
};

}  // namespace adaptive_localization
