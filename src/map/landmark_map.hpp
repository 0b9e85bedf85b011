// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

namespace adaptive_localization {

/// A point that a sensor can recognize: a post, a corner, a fiducial, a reflector.
struct Landmark {
  int id{0};              // from 0 on; landmarks that look the same share one
  Eigen::Vector2d place;  // in the map, m
  double reflector{0.0};  // width of the reflector that it is, m; 0: it is none
};

/// Known landmarks.
class LandmarkMap {
 public:
  LandmarkMap() = default;
  explicit LandmarkMap(std::vector<Landmark> all);

  /// Those that a sighting may be of: with its id, or all where it is -1, not identified.
  std::vector<Eigen::Vector2d> candidates(int id) const;

  const std::vector<Landmark>& all() const { return all_; }

 private:
  std::vector<Landmark> all_;
};

}  // namespace adaptive_localization
