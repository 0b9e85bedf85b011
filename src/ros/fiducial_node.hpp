// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <tf2_ros/buffer.h>

#include <optional>
#include <string>

#include "../vision/fiducial_detector.hpp"
#include "complaints.hpp"
#include "ros_params.hpp"
#include "transform_input.hpp"

namespace adaptive_localization {

struct FiducialNodeOptions {
  std::string base_frame_id{"base_link"};
  bool rectified{false};
  FiducialOptions fiducials;

  template <class Visitor>
  void visit(Visitor&& option) {
    option("base_frame_id", base_frame_id, Choices{},
           "Frame of the robot, whose z axis tells what is level; empty: the camera is.");
    option("rectified", rectified, "Images are rectified: camera_info's P holds, not its K and D.");
    fiducials.visit(option);
  }
};

/// Turns a camera's pictures (topics image and camera_info) into sightings of landmarks (topic
/// landmarks, sensor_msgs/PointCloud in the camera's frame, with channels id, range_std and
/// bearing_std): the markers in each, none perhaps. One thread, but for tf and within OpenCV.
class FiducialNode {
 public:
  /// Throws std::invalid_argument naming what is wrong with a parameter.
  FiducialNode(ros::NodeHandle node, ros::NodeHandle private_node);

 private:
  FiducialNode(ros::NodeHandle node, const Parameters& parameters);
  void onCamera(const sensor_msgs::CameraInfo& message);
  void onImage(const sensor_msgs::Image& message);
  Eigen::Vector3d upIn(const std::string& camera_frame) const;
  void drop(const std::string& what, const std::string& why);

  FiducialNodeOptions options_;
  FiducialDetector detector_;
  std::optional<CameraCalibration> camera_;
  Complaints complaints_;
  tf2_ros::Buffer tf_;
  TransformInput transforms_;
  ros::Publisher landmarks_;
  ros::Subscriber cameras_, images_;
};

}  // namespace adaptive_localization
