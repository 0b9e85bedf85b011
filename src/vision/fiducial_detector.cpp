// SPDX-License-Identifier: BSD-3-Clause
#include "fiducial_detector.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string>

namespace adaptive_localization {
namespace {

const std::map<std::string, cv::aruco::PREDEFINED_DICTIONARY_NAME>& dictionaries() {
  using namespace cv::aruco;
  static const std::map<std::string, PREDEFINED_DICTIONARY_NAME> all{
      {"DICT_4X4_50", DICT_4X4_50},
      {"DICT_4X4_100", DICT_4X4_100},
      {"DICT_4X4_250", DICT_4X4_250},
      {"DICT_4X4_1000", DICT_4X4_1000},
      {"DICT_5X5_50", DICT_5X5_50},
      {"DICT_5X5_100", DICT_5X5_100},
      {"DICT_5X5_250", DICT_5X5_250},
      {"DICT_5X5_1000", DICT_5X5_1000},
      {"DICT_6X6_50", DICT_6X6_50},
      {"DICT_6X6_100", DICT_6X6_100},
      {"DICT_6X6_250", DICT_6X6_250},
      {"DICT_6X6_1000", DICT_6X6_1000},
      {"DICT_7X7_50", DICT_7X7_50},
      {"DICT_7X7_100", DICT_7X7_100},
      {"DICT_7X7_250", DICT_7X7_250},
      {"DICT_7X7_1000", DICT_7X7_1000},
      {"DICT_ARUCO_ORIGINAL", DICT_ARUCO_ORIGINAL},
      {"DICT_APRILTAG_16h5", DICT_APRILTAG_16h5},
      {"DICT_APRILTAG_25h9", DICT_APRILTAG_25h9},
      {"DICT_APRILTAG_36h10", DICT_APRILTAG_36h10},
      {"DICT_APRILTAG_36h11", DICT_APRILTAG_36h11}};
  return all;
}

std::string text(const cv::Size& size) {
  return std::to_string(size.width) + " x " + std::to_string(size.height);
}

void check(const cv::Mat& grey, const CameraCalibration& camera) {
  if (grey.type() != CV_8UC1) {
    throw std::invalid_argument("picture: got pixels of type " + std::to_string(grey.type()) +
                                ", expected one channel of 8 bits");
  }
  if (grey.size() != camera.size || grey.empty()) {
    throw std::invalid_argument("picture: got " + text(grey.size()) + " pixels, expected " +
                                text(camera.size) + ", as the calibration has them");
  }
}

/// Corners of a square in its own frame (x right, y up, z to who looks at it), as the solver wants
/// them: clockwise from the top left.
std::vector<cv::Point3d> squareOf(double side) {
  const double half = side / 2.0;
  return {{-half, half, 0.0}, {half, half, 0.0}, {half, -half, 0.0}, {-half, -half, 0.0}};
}

/// Covariance of the translation by least squares, and by how many pixels the corners are off.
struct Fit {
  Eigen::Matrix3d covariance;  // m^2, for a deviation of 1 px
  double residual;             // px, per degree of freedom
};

Fit fitOf(const std::vector<cv::Point3d>& square, const std::vector<cv::Point2f>& corners,
          const cv::Vec3d& rotation, const cv::Vec3d& translation,
          const CameraCalibration& camera) {
  constexpr double kFreedom = 2.0;  // eight coordinates, six of a pose
  std::vector<cv::Point2d> projected;
  cv::Mat derivatives;  // first by the rotation, then by the translation
  cv::projectPoints(square, rotation, translation, camera.matrix, camera.distortion, projected,
                    derivatives);
  Eigen::Matrix<double, 6, 6> information = Eigen::Matrix<double, 6, 6>::Zero();
  double sum = 0.0;
  for (int row = 0; row < 8; ++row) {
    Eigen::Matrix<double, 6, 1> gradient;
    for (int k = 0; k < 6; ++k) gradient[k] = derivatives.at<double>(row, k);
    information += gradient * gradient.transpose();
  }
  for (std::size_t i = 0; i < projected.size(); ++i) {
    sum += std::pow(projected[i].x - static_cast<double>(corners[i].x), 2) +
           std::pow(projected[i].y - static_cast<double>(corners[i].y), 2);
  }
  return {information.inverse().bottomRightCorner<3, 3>(), std::sqrt(sum / kFreedom)};
}

bool isFinite(const Fiducial& fiducial) {
  return fiducial.centre.allFinite() && std::isfinite(fiducial.range_deviation) &&
         std::isfinite(fiducial.bearing_deviation) && fiducial.range_deviation > 0.0 &&
         fiducial.bearing_deviation > 0.0;
}

}  // namespace

Choices dictionaryNames() {
  Choices names;
  for (const auto& entry : dictionaries()) names.push_back(entry.first);
  return names;
}

cv::Ptr<cv::aruco::Dictionary> dictionaryNamed(const std::string& name) {
  const auto found = dictionaries().find(name);
  if (found != dictionaries().end()) return cv::aruco::getPredefinedDictionary(found->second);
  throw std::invalid_argument("option 'dictionary': got '" + name +
                              "', expected one of OpenCV's, such as DICT_4X4_50");
}

FiducialDetector::FiducialDetector(const FiducialOptions& options)
    : options_(options),
      dictionary_(dictionaryNamed(options.dictionary)),
      parameters_(cv::aruco::DetectorParameters::create()) {
  // OpenCV's 0.05 takes a marker for the same as the white paper around it, where that is narrower
  // than a seventh of the marker: one cell of a code of 6 x 6
  parameters_->minMarkerDistanceRate = 0.03;
}

std::vector<Fiducial> FiducialDetector::detect(const cv::Mat& grey, const CameraCalibration& camera,
                                               const Eigen::Vector3d& up) const {
  check(grey, camera);
  std::vector<Corners> all;
  std::vector<int> ids;
  cv::aruco::detectMarkers(grey, dictionary_, all, ids, parameters_);
  std::vector<Fiducial> fiducials;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    refine(grey, all[i]);
    Fiducial fiducial = place(all[i], camera, up);
    fiducial.id = ids[i];
    const Eigen::Vector3d flat = fiducial.centre - up.dot(fiducial.centre) * up;
    if (isFinite(fiducial) && flat.norm() <= options_.max_range) fiducials.push_back(fiducial);
  }
  return fiducials;
}

/// To a fraction of a pixel, by the gradients in a window that holds nothing but the corner: less
/// than a cell of the code on each side.
void FiducialDetector::refine(const cv::Mat& grey, Corners& corners) const {
  constexpr double kShareOfCell = 0.7;
  constexpr int kMost = 5;  // px
  double side = 1e9;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    side = std::min(side, cv::norm(corners[i] - corners[(i + 1) % corners.size()]));
  }
  const double cell = side / (dictionary_->markerSize + 2);
  const int room = (std::min(grey.cols, grey.rows) - 5) / 2;  // as cornerSubPix wants it
  const int window = std::min({kMost, room, static_cast<int>(kShareOfCell * cell)});
  if (window < 1) return;
  cv::cornerSubPix(grey, corners, {window, window}, {-1, -1},
                   {cv::TermCriteria::EPS | cv::TermCriteria::COUNT, 30, 0.01});
}

Fiducial FiducialDetector::place(const Corners& corners, const CameraCalibration& camera,
                                 const Eigen::Vector3d& up) const {
  constexpr double kLeast = 1e-3;  // m; a marker right above has no bearing
  const auto square = squareOf(options_.marker_size);
  cv::Vec3d rotation, translation;
  cv::solvePnP(square, corners, camera.matrix, camera.distortion, rotation, translation, false,
               cv::SOLVEPNP_IPPE_SQUARE);
  cv::solvePnPRefineLM(square, corners, camera.matrix, camera.distortion, rotation, translation);
  const Fit fit = fitOf(square, corners, rotation, translation, camera);
  const double deviation = std::max(options_.pixel_std, fit.residual);
  const Eigen::Matrix3d covariance =
      deviation * deviation * fit.covariance +
      options_.place_std * options_.place_std * Eigen::Matrix3d::Identity();

  Fiducial fiducial;
  fiducial.centre = {translation[0], translation[1], translation[2]};
  const Eigen::Vector3d flat = fiducial.centre - up.dot(fiducial.centre) * up;
  const Eigen::Vector3d out = flat.norm() > kLeast ? flat.normalized() : up.unitOrthogonal();
  const Eigen::Vector3d aside = up.cross(out);
  fiducial.range_deviation = std::sqrt(out.dot(covariance * out));
  fiducial.bearing_deviation =
      std::sqrt(aside.dot(covariance * aside)) / std::max(flat.norm(), kLeast);
  return fiducial;
}

}  // namespace adaptive_localization
