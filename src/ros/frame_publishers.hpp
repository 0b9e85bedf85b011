// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

#include <map>
#include <string>

namespace adaptive_localization {

/// Which nodes publish which frames of tf. A frame that two of them publish jumps to and fro
/// between what the one says and the other: as where amcl was left running, or where both a robot's
/// driver and a filter of odometry publish the base. tf itself does not notice.
class FramePublishers {
 public:
  void hear(const std::string& frame, const std::string& publisher, const ros::SteadyTime& now);

  /// On /tf_static, where each is said once.
  void hearFixed(const std::string& frame, const std::string& publisher) {
    frames_[frame].fixed_by = publisher;
  }

  /// Of the last few seconds, in words: "'odom' is published by /amcl and by /robot". Empty where
  /// each frame had one publisher; one that takes over from another is none beside it.
  std::string rivals(const ros::SteadyTime& now) const;

 private:
  struct Turn {
    std::string publisher;
    ros::SteadyTime heard;
  };
  struct Frame {
    std::string fixed_by;    // empty: nobody
    Turn last, other;        // of the node that published last, and of the one before it
    ros::SteadyTime fought;  // when they took turns last
  };

  std::map<std::string, Frame> frames_;
};

}  // namespace adaptive_localization
