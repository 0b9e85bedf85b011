// SPDX-License-Identifier: BSD-3-Clause
#include "fiducial_node.hpp"

#include <sensor_msgs/PointCloud.h>

#include <Eigen/Geometry>
#include <stdexcept>

#include "../bag/names.hpp"
#include "../bag/sighting_messages.hpp"
#include "callbacks.hpp"
#include "core/suggestion.hpp"
#include "image_messages.hpp"

namespace adaptive_localization {
namespace {

sensor_msgs::PointCloud toMessage(const std_msgs::Header& header,
                                  const std::vector<Fiducial>& fiducials) {
  sensor_msgs::PointCloud message = noSightings();
  message.header = header;
  for (const Fiducial& fiducial : fiducials) {
    addSighting(message, fiducial.centre, fiducial.id, fiducial.range_deviation,
                fiducial.bearing_deviation);
  }
  return message;
}

}  // namespace

FiducialNode::FiducialNode(ros::NodeHandle node, ros::NodeHandle private_node)
    : FiducialNode(node, readParameters(private_node)) {}

FiducialNode::FiducialNode(ros::NodeHandle node, const Parameters& parameters)
    : options_(parameters.read<FiducialNodeOptions>()),
      detector_(options_.fiducials),
      transforms_(tf_),
      landmarks_(node.advertise<sensor_msgs::PointCloud>("landmarks", 1)) {
  reportUnknown(parameters.unknownKeys(), keysOf(describe(options_)));
  cameras_ = subscribe<sensor_msgs::CameraInfo>(
      node, "camera_info", 1, [this](const auto& message) { onCamera(*message); });
  images_ = subscribe<sensor_msgs::Image>(node, "image", 1,
                                          [this](const auto& message) { onImage(*message); });
  ROS_INFO("Looks for markers in %s, calibrated by %s", images_.getTopic().c_str(),
           cameras_.getTopic().c_str());
}

void FiducialNode::onCamera(const sensor_msgs::CameraInfo& message) {
  try {
    camera_ = toCalibration(message, options_.rectified);
  } catch (const std::invalid_argument& error) {
    camera_.reset();
    drop("Message on " + cameras_.getTopic(), error.what());
  }
}

void FiducialNode::onImage(const sensor_msgs::Image& message) {
  if (landmarks_.getNumSubscribers() == 0) return;
  try {
    if (!camera_) {
      throw std::invalid_argument("there is no calibration on " + cameras_.getTopic() +
                                  " that can be used");
    }
    const cv::Mat grey = toGrey(message);
    const auto found = detector_.detect(grey, *camera_, upIn(message.header.frame_id));
    landmarks_.publish(toMessage(message.header, found));
  } catch (const std::exception& error) {
    drop("Image", error.what());
  }
}

/// The robot's z axis in the camera's frame.
Eigen::Vector3d FiducialNode::upIn(const std::string& camera_frame) const {
  if (options_.base_frame_id.empty()) return -Eigen::Vector3d::UnitY();
  try {
    const auto q =
        tf_.lookupTransform(withoutLeadingSlash(camera_frame), options_.base_frame_id, ros::Time(0))
            .transform.rotation;
    return Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized() * Eigen::Vector3d::UnitZ();
  } catch (const tf2::TransformException&) {
    throw std::invalid_argument("tf does not know how frame '" + camera_frame + "' lies to '" +
                                options_.base_frame_id + "', the base_frame_id");
  }
}

void FiducialNode::drop(const std::string& what, const std::string& why) {
  if (complaints_.isDue(why)) ROS_WARN("%s dropped: %s", what.c_str(), why.c_str());
}

}  // namespace adaptive_localization
