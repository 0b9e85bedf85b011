// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "adaptive_localization/core/pose2.hpp"

namespace adaptive_localization {

/// A pose at an instant, seconds.
struct StampedPose {
  double stamp{0.0};
  Pose2 pose;
};

/// The pose between two, at share 0 (from) to 1 (to): straight in position, the short way round in
/// heading.
Pose2 interpolate(const Pose2& from, const Pose2& to, double share);

/// Poses in the order of their stamps, to be asked for the pose at any instant between.
class Trajectory {
 public:
  Trajectory() = default;
  /// Sorts the poses; of several with the same stamp the last one counts.
  explicit Trajectory(std::vector<StampedPose> poses);

  /// The interpolated pose. None outside the trajectory and none inside a gap longer than max_gap
  /// seconds, except within a millisecond of a pose, which then is the answer.
  std::optional<Pose2> at(double stamp,
                          double max_gap = std::numeric_limits<double>::infinity()) const;

  const std::vector<StampedPose>& poses() const { return poses_; }
  bool empty() const { return poses_.empty(); }

 private:
  std::vector<StampedPose> poses_;
};

/// Reads the TUM format: lines of `stamp x y z qx qy qz qw`, comments begin with #. A broken line
/// is skipped and named by number in `warnings`. Throws std::invalid_argument naming the file when
/// it cannot be read or holds no pose.
Trajectory loadTum(const std::string& file, std::vector<std::string>& warnings);
Trajectory readTum(std::istream& input, const std::string& name,
                   std::vector<std::string>& warnings);

/// Writes the TUM format. Throws std::runtime_error naming the file that could not be written.
void saveTum(const std::vector<StampedPose>& poses, const std::string& file);
void writeTum(const std::vector<StampedPose>& poses, std::ostream& output);

}  // namespace adaptive_localization
