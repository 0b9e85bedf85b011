// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace adaptive_localization {

/// A point that a sensor can recognize: a post, a corner, a fiducial, a reflector.
struct Landmark {
  int id{0};              // from 0 on; landmarks that look the same share one
  Eigen::Vector2d place;  // in the map, m
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

/// Reads the list `landmarks` of a YAML file, which may be a floor plan:
///
///     landmarks:
///       - {id: 0, at: [4.5, 0.8]}       # m, in the map
///       - {id: 0, at: [4.5, -0.8]}      # looks the same
///
/// Throws std::invalid_argument naming the file, the entry and what was expected.
LandmarkMap loadLandmarks(const std::string& yaml_file);

}  // namespace adaptive_localization
