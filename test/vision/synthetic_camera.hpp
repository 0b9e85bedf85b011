// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <opencv2/aruco.hpp>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "adaptive_localization/core/rng.hpp"
#include "vision/fiducial_detector.hpp"

namespace adaptive_localization {

struct PlacedMarker {
  int id;
  Eigen::Isometry3d T_camera_marker;  // x right, y up, z out of the marker
};

/// A marker that faces the camera, turned about its own vertical axis, then about its horizontal
/// one, rad.
inline PlacedMarker markerAt(int id, const Eigen::Vector3d& centre, double yaw = 0.0,
                             double pitch = 0.0) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translate(centre);
  pose.rotate(Eigen::AngleAxisd(std::acos(-1.0), Eigen::Vector3d::UnitX()));
  pose.rotate(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitY()));
  pose.rotate(Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitX()));
  return {id, pose};
}

inline CameraCalibration calibrationOf(int width, int height, double focal_length) {
  return {
      {focal_length, 0.0, (width - 1) / 2.0, 0.0, focal_length, (height - 1) / 2.0, 0.0, 0.0, 1.0},
      {},
      {width, height}};
}

/// Takes pictures of markers, white around by the width of a cell, before a grey wall. Each pixel
/// is the mean of what rays through 4 x 4 of its points meet, so that edges are as soft as a
/// sensor's.
class SyntheticCamera {
 public:
  explicit SyntheticCamera(CameraCalibration calibration) : calibration_(std::move(calibration)) {
    const cv::Size fine = calibration_.size * kFine;
    std::vector<cv::Point2d> pixels;
    for (int v = 0; v < fine.height; ++v) {
      for (int u = 0; u < fine.width; ++u) {
        pixels.emplace_back((u + 0.5) / kFine - 0.5, (v + 0.5) / kFine - 0.5);
      }
    }
    const cv::TermCriteria exact(cv::TermCriteria::EPS | cv::TermCriteria::COUNT, 20, 1e-9);
    cv::undistortPoints(pixels, rays_, calibration_.matrix, calibration_.distortion, cv::noArray(),
                        cv::noArray(), exact);
  }

  const CameraCalibration& calibration() const { return calibration_; }

  /// `blur` is the deviation of the lens's, px, `noise` that of a grey level of 0 to 255.
  cv::Mat picture(const std::vector<PlacedMarker>& markers, const FiducialOptions& options,
                  double blur, double noise, Rng& rng) const {
    cv::Mat fine(calibration_.size * kFine, CV_8UC1, cv::Scalar(kWall));
    for (const PlacedMarker& marker : markers) draw(marker, options, fine);
    cv::Mat picture;
    cv::resize(fine, picture, calibration_.size, 0.0, 0.0, cv::INTER_AREA);
    if (blur > 0.0) cv::GaussianBlur(picture, picture, {}, blur);
    for (int v = 0; v < picture.rows; ++v) {
      for (int u = 0; u < picture.cols; ++u) {
        auto& grey = picture.at<std::uint8_t>(v, u);
        grey = cv::saturate_cast<std::uint8_t>(rng.normal(grey, noise));
      }
    }
    return picture;
  }

 private:
  static constexpr int kFine = 4;
  static constexpr std::uint8_t kWall = 120, kBlack = 30, kWhite = 220;

  void draw(const PlacedMarker& marker, const FiducialOptions& options, cv::Mat& fine) const {
    const auto dictionary = dictionaryNamed(options.dictionary);
    const int cells = dictionary->markerSize + 2;
    cv::Mat code;  // a pixel for each cell
    cv::aruco::drawMarker(dictionary, marker.id, cells, code);
    const Eigen::Isometry3d T_marker_camera = marker.T_camera_marker.inverse();
    const Eigen::Vector3d origin = T_marker_camera.translation();
    const cv::Rect part = partWith(marker, 0.75 * options.marker_size);
    for (int v = part.y; v < part.y + part.height; ++v) {
      for (int u = part.x; u < part.x + part.width; ++u) {
        const cv::Point2d& at = rays_[static_cast<std::size_t>(v * fine.cols + u)];
        const Eigen::Vector3d ray = T_marker_camera.linear() * Eigen::Vector3d(at.x, at.y, 1.0);
        const Eigen::Vector3d met = origin - origin.z() / ray.z() * ray;
        const double column = (met.x() / options.marker_size + 0.5) * cells;
        const double row = (0.5 - met.y() / options.marker_size) * cells;
        if (std::min(column, row) < -1.0 || std::max(column, row) > cells + 1.0) continue;
        const bool is_code = std::min(column, row) >= 0.0 && std::max(column, row) < cells;
        const bool is_black =
            is_code && code.at<std::uint8_t>(static_cast<int>(row), static_cast<int>(column)) == 0;
        fine.at<std::uint8_t>(v, u) = is_black ? kBlack : kWhite;
      }
    }
  }

  /// Of the fine picture, with a square about the marker's centre.
  cv::Rect partWith(const PlacedMarker& marker, double half) const {
    std::vector<cv::Point3d> corners;
    for (const double x : {-half, half}) {
      for (const double y : {-half, half}) {
        const Eigen::Vector3d corner = marker.T_camera_marker * Eigen::Vector3d(x, y, 0.0);
        corners.emplace_back(corner.x(), corner.y(), corner.z());
      }
    }
    std::vector<cv::Point2d> projected;
    const cv::Vec3d none;
    cv::projectPoints(corners, none, none, calibration_.matrix, calibration_.distortion, projected);
    std::vector<cv::Point> pixels;
    for (const auto& point : projected)
      pixels.emplace_back((point + cv::Point2d(0.5, 0.5)) * kFine);
    return cv::boundingRect(pixels) & cv::Rect({}, calibration_.size * kFine);
  }

  CameraCalibration calibration_;
  std::vector<cv::Point2d> rays_;  // at z = 1, line by line
};

}  // namespace adaptive_localization
