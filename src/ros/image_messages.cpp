// SPDX-License-Identifier: BSD-3-Clause
#include "image_messages.hpp"

#include <sensor_msgs/distortion_models.h>
#include <sensor_msgs/image_encodings.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <sstream>
#include <stdexcept>
#include <string>

namespace adaptive_localization {
namespace {

constexpr std::uint32_t kMostPixels = 1U << 15U;  // along a side

template <class Value>
[[noreturn]] void reject(const std::string& what, const Value& value, const std::string& expected) {
  std::ostringstream text;
  text << what << ": got " << value << ", expected " << expected;
  throw std::invalid_argument(text.str());
}

cv::Size sizeOf(const std::string& what, std::uint32_t width, std::uint32_t height) {
  if (std::min(width, height) == 0 || std::max(width, height) > kMostPixels) {
    reject("size of " + what, std::to_string(width) + " x " + std::to_string(height),
           "1 to 32768 pixels each way");
  }
  return {static_cast<int>(width), static_cast<int>(height)};
}

int channelsOf(const std::string& encoding) {
  namespace enc = sensor_msgs::image_encodings;
  if (encoding == enc::MONO8) return 1;
  if (encoding == enc::RGB8 || encoding == enc::BGR8) return 3;
  reject("encoding of an image", "'" + encoding + "'",
         "mono8, rgb8 or bgr8; image_proc makes such of others");
}

/// Focal lengths and middle from a matrix whose rows have so many columns.
cv::Matx33d pinholeOf(const std::string& name, const double* matrix, int columns) {
  const double fx = matrix[0], fy = matrix[columns + 1];
  const double cx = matrix[2], cy = matrix[columns + 2];
  for (const double focal_length : {fx, fy}) {
    if (!(focal_length > 0.0 && std::isfinite(focal_length))) {
      reject("focal length in camera_info's " + name, focal_length,
             "one above 0, in pixels: a calibrated camera");
    }
  }
  for (const double middle : {cx, cy}) {
    if (!std::isfinite(middle)) reject("middle in camera_info's " + name, middle, "a number");
  }
  return {fx, 0.0, cx, 0.0, fy, cy, 0.0, 0.0, 1.0};
}

std::vector<double> distortionOf(const sensor_msgs::CameraInfo& message) {
  namespace models = sensor_msgs::distortion_models;
  const std::string& model = message.distortion_model;
  if (!model.empty() && model != models::PLUMB_BOB && model != models::RATIONAL_POLYNOMIAL) {
    reject("distortion_model of camera_info", "'" + model + "'",
           "plumb_bob or rational_polynomial, or rectified images");
  }
  const std::size_t count = message.D.size();
  if (count != 0 && count != 4 && count != 5 && count != 8) {
    reject("number of values in camera_info's D", count, "0, 4, 5 or 8");
  }
  for (const double value : message.D) {
    if (!std::isfinite(value)) reject("value in camera_info's D", value, "a number");
  }
  return message.D;
}

}  // namespace

cv::Mat toGrey(const sensor_msgs::Image& message) {
  const int channels = channelsOf(message.encoding);
  const cv::Size size = sizeOf("an image", message.width, message.height);
  const std::size_t step = message.step;
  const std::size_t line =
      static_cast<std::size_t>(size.width) * static_cast<std::size_t>(channels);
  if (step < line) reject("step of an image", step, "at least " + std::to_string(line));
  const std::size_t needed = step * static_cast<std::size_t>(size.height);
  if (message.data.size() < needed) {
    reject("bytes of an image", message.data.size(), "at least " + std::to_string(needed));
  }
  // read only; cv::Mat knows no other
  const cv::Mat picture(size, CV_8UC(channels), const_cast<std::uint8_t*>(message.data.data()),
                        step);
  if (channels == 1) return picture;
  cv::Mat grey;
  const bool is_rgb = message.encoding == sensor_msgs::image_encodings::RGB8;
  cv::cvtColor(picture, grey, is_rgb ? cv::COLOR_RGB2GRAY : cv::COLOR_BGR2GRAY);
  return grey;
}

CameraCalibration toCalibration(const sensor_msgs::CameraInfo& message, bool is_rectified) {
  CameraCalibration calibration;
  calibration.size = sizeOf("camera_info", message.width, message.height);
  if (is_rectified) {
    calibration.matrix = pinholeOf("P", message.P.data(), 4);
    if (message.P[3] != 0.0) {
      reject("fourth value in camera_info's P", message.P[3], "0, as of a pair's first camera");
    }
  } else {
    calibration.matrix = pinholeOf("K", message.K.data(), 3);
    calibration.distortion = distortionOf(message);
  }
  return calibration;
}

}  // namespace adaptive_localization
