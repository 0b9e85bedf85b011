// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <opencv2/aruco.hpp>
#include <string>
#include <vector>

#include "adaptive_localization/core/options.hpp"

namespace adaptive_localization {

/// Names of the predefined dictionaries, as OpenCV has them: DICT_4X4_50 and so on.
Choices dictionaryNames();

/// Throws std::invalid_argument where OpenCV has none of this name.
cv::Ptr<cv::aruco::Dictionary> dictionaryNamed(const std::string& name);

/// What is known of markers and of how well they are seen.
struct FiducialOptions {
  double marker_size{0.15};
  std::string dictionary{"DICT_4X4_50"};
  double pixel_std{0.5};
  double place_std{0.02};
  double max_range{4.0};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("marker_size", marker_size, Range{1e-3, 100.0}, "m",
           "Side of a marker's black square, all of one size.");
    option("dictionary", dictionary, dictionaryNames(), "Which set the markers are of.");
    option("pixel_std", pixel_std, Range{1e-3, 100.0}, "px",
           "Standard deviation of a corner in the picture, in each of its two directions; those of "
           "range and bearing follow from it.");
    option("place_std", place_std, Range{0.0, 10.0}, "m",
           "Standard deviation of where a marker is, as it was measured for the map.");
    option("max_range", max_range, Range{0.01, 1e4}, "m", "Markers farther away are left out.");
  }
};

/// What a camera does to a point of its optical frame (x right, y down, z ahead): a pinhole with
/// OpenCV's polynomial distortion.
struct CameraCalibration {
  cv::Matx33d matrix;              // px
  std::vector<double> distortion;  // k1, k2, p1, p2, k3, ... or none
  cv::Size size;                   // of its pictures, px
};

/// A marker as it is seen.
struct Fiducial {
  int id{0};                      // in its dictionary
  Eigen::Vector3d centre;         // in the camera's optical frame, m
  double range_deviation{0.0};    // standard deviations of the horizontal distance, m,
  double bearing_deviation{0.0};  // and of the direction as seen from above, rad
};

/// Finds square markers with a code (S. Garrido-Jurado et al. 2014, OpenCV's aruco) in pictures.
///
/// A marker's pose is the one whose corners, projected, are nearest to those seen (T. Collins and
/// A. Bartoli 2014, then least squares). With J the derivatives of the projected corners by the
/// pose and s the deviation of a corner in pixels, pixel_std, or what the corners are off the
/// square by, where that is more, the covariance of the pose is
///
///     P = s^2 (J^T J)^-1        (R. Hartley and A. Zisserman 2004, 5.2)
///
/// of which its part of the centre, enlarged by place_std^2 in each direction, is turned to the
/// horizontal plane: there range and bearing have their deviations, for who localizes a robot on a
/// floor. Range grows uncertain with the square of the distance, bearing hardly.
class FiducialDetector {
 public:
  /// Throws std::invalid_argument where there is no such dictionary.
  explicit FiducialDetector(const FiducialOptions& options);

  /// `up` is of unit length, in the optical frame; a camera that looks level has it at -y. Throws
  /// std::invalid_argument where the picture is not of one channel of 8 bits or has another size
  /// than the calibration.
  std::vector<Fiducial> detect(const cv::Mat& grey, const CameraCalibration& camera,
                               const Eigen::Vector3d& up = -Eigen::Vector3d::UnitY()) const;

 private:
  using Corners = std::vector<cv::Point2f>;  // clockwise from the marker's top left
  void refine(const cv::Mat& grey, Corners& corners) const;
  Fiducial place(const Corners& corners, const CameraCalibration& camera,
                 const Eigen::Vector3d& up) const;

  FiducialOptions options_;
  cv::Ptr<cv::aruco::Dictionary> dictionary_;
  cv::Ptr<cv::aruco::DetectorParameters> parameters_;
};

}  // namespace adaptive_localization
