// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>

#include <opencv2/core.hpp>

#include "../vision/fiducial_detector.hpp"

namespace adaptive_localization {

/// The grey levels of a picture in mono8, rgb8 or bgr8; those of mono8 stay in the message. Throws
/// std::invalid_argument naming what was got and expected: another encoding, a size of zero, less
/// data than the size tells.
cv::Mat toGrey(const sensor_msgs::Image& message);

/// What the camera does to its raw pictures (K, D), or to those that were rectified (P). Throws
/// std::invalid_argument naming what was got and expected: a camera that is not calibrated has
/// zeros there; fish-eyes (`equidistant`) have to be rectified first.
CameraCalibration toCalibration(const sensor_msgs::CameraInfo& message, bool is_rectified);

}  // namespace adaptive_localization
