// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/LaserScan.h>
#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

#include <Eigen/Geometry>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "../bag/names.hpp"
#include "eval/log.hpp"

namespace adaptive_localization {

/// Gives each scan of a bag its odometry and mount from the transforms around it, as the bag's
/// messages come by in the order of recording.
class BagFrames {
 public:
  struct PlacedScan {
    LogScan scan;
    std::string frame;
    bool has_odometry{false};
    bool has_mount{false};
  };

  BagFrames(const FrameOptions& frames, bool keeps_intensities)
      : frames_(frames), keeps_intensities_(keeps_intensities) {}

  void add(const tf2_msgs::TFMessage& message, bool is_static);
  void add(const sensor_msgs::LaserScan& scan);

  /// Where a sensor sits on the robot, by what has come so far; throws tf2's errors.
  Eigen::Isometry3d placeOf(const std::string& frame) const;

  /// Transforms that tf refused: older than what it keeps, repeated, or not numbers.
  int refused() const { return refused_; }

  /// All scans, in order; to be called once, after the last message.
  std::vector<PlacedScan> finish();

 private:
  void placeWaiting(bool is_last_chance);
  std::optional<geometry_msgs::Transform> lookUp(const std::string& target,
                                                 const std::string& source,
                                                 const ros::Time& stamp) const;
  std::optional<Pose2> odometryAt(const ros::Time& stamp) const;
  void mount(PlacedScan& placed, const ros::Time& stamp) const;

  FrameOptions frames_;
  bool keeps_intensities_;
  tf2::BufferCore buffer_{ros::Duration(60.0)};
  double newest_{0.0};  // stamp of all transforms so far, s
  int refused_{0};
  std::deque<sensor_msgs::LaserScan> waiting_;
  std::vector<PlacedScan> placed_;
};

}  // namespace adaptive_localization
