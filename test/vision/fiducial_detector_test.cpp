// SPDX-License-Identifier: BSD-3-Clause
#include "vision/fiducial_detector.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>

#include "synthetic_camera.hpp"

namespace adaptive_localization {
namespace {

using testing::AllOf;
using testing::Gt;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Lt;
using testing::SizeIs;
using testing::ThrowsMessage;

constexpr double kBlur = 0.7;  // px, as of a lens in focus
constexpr double kNoise = 2.0;

FiducialOptions byPixels() {
  FiducialOptions options;
  options.place_std = 0.0;  // of a marker that is where it is said to be
  return options;
}

double rangeOf(const Eigen::Vector3d& centre) {
  return std::hypot(centre.x(), centre.z());
}
double bearingOf(const Eigen::Vector3d& centre) {
  return std::atan2(-centre.x(), centre.z());
}

/// The same for all tests, as its rays take a second.
const SyntheticCamera& camera() {
  static const SyntheticCamera only(calibrationOf(640, 480, 500.0));
  return only;
}

class Fiducials : public testing::Test {
 protected:
  cv::Mat picture(const std::vector<PlacedMarker>& markers) {
    return camera().picture(markers, options_, kBlur, kNoise, rng_);
  }
  std::vector<Fiducial> seen(const std::vector<PlacedMarker>& markers) {
    return FiducialDetector(options_).detect(picture(markers), camera().calibration());
  }

  FiducialOptions options_ = byPixels();
  Rng rng_{7};
};

TEST_F(Fiducials, AreWhereTheyAreHungUp) {
  const auto found = seen({markerAt(3, {0.3, -0.2, 1.0}, 0.4), markerAt(17, {-0.5, 0.1, 1.5}),
                           markerAt(49, {0.0, 0.3, 0.8}, -0.3, 0.5)});
  ASSERT_THAT(found, SizeIs(3));
  for (const Fiducial& fiducial : found) {
    const Eigen::Vector3d centre = fiducial.id == 3    ? Eigen::Vector3d(0.3, -0.2, 1.0)
                                   : fiducial.id == 17 ? Eigen::Vector3d(-0.5, 0.1, 1.5)
                                                       : Eigen::Vector3d(0.0, 0.3, 0.8);
    EXPECT_NEAR(rangeOf(fiducial.centre), rangeOf(centre), 0.01 * centre.z()) << fiducial.id;
    EXPECT_NEAR(bearingOf(fiducial.centre), bearingOf(centre), 1e-3) << fiducial.id;
    EXPECT_NEAR(fiducial.centre.y(), centre.y(), 0.01) << fiducial.id;
  }
}

TEST_F(Fiducials, AreFoundThroughALensThatDistorts) {
  CameraCalibration calibration = calibrationOf(640, 480, 350.0);
  calibration.distortion = {-0.25, 0.05, 0.001, -0.001, 0.0};
  const SyntheticCamera camera(calibration);
  const Eigen::Vector3d centre(0.6, 0.3, 0.9);
  const cv::Mat grey = camera.picture({markerAt(8, centre)}, options_, kBlur, kNoise, rng_);
  const auto found = FiducialDetector(options_).detect(grey, calibration);
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_LT((found[0].centre - centre).norm(), 0.015);
  calibration.distortion.clear();
  const auto blunt = FiducialDetector(options_).detect(grey, calibration);
  ASSERT_THAT(blunt, SizeIs(1));
  EXPECT_GT((blunt[0].centre - centre).norm(), 0.05) << "the lens matters here";
}

/// Errors of many sightings, and what was told of them.
struct Errors {
  int count{0};
  double range{0.0}, told_range{0.0};  // sums of squares, m^2
  double normalised_range{0.0}, normalised_bearing{0.0};

  void add(const Fiducial& fiducial, const Eigen::Vector3d& centre) {
    const double range_error = rangeOf(fiducial.centre) - rangeOf(centre);
    const double bearing_error = bearingOf(fiducial.centre) - bearingOf(centre);
    ++count;
    range += std::pow(range_error, 2);
    told_range += std::pow(fiducial.range_deviation, 2);
    normalised_range += std::pow(range_error / fiducial.range_deviation, 2);
    normalised_bearing += std::pow(bearing_error / fiducial.bearing_deviation, 2);
  }
};

/// Normalised squared errors are 1 in the mean where deviations are true. Sharp pictures of near
/// markers are better than pixel_std says; in small ones the blur moves all corners inwards. It
/// hardly moves their middle, and bearings are better than they are told to be.
TEST_F(Fiducials, AreAsFarOffAsTheirDeviationsSay) {
  const FiducialDetector detector(options_);
  for (const double depth : {0.5, 1.0, 2.0, 3.0}) {
    Errors errors;
    for (int i = 0; i < 50; ++i) {
      const Eigen::Vector3d centre =
          depth * Eigen::Vector3d(rng_.uniform(-0.35, 0.35), rng_.uniform(-0.25, 0.25), 1.0);
      const auto marker = markerAt(i, centre, rng_.uniform(-1.0, 1.0), rng_.uniform(-0.5, 0.5));
      for (const auto& fiducial : detector.detect(picture({marker}), camera().calibration())) {
        ASSERT_EQ(fiducial.id, i);
        errors.add(fiducial, centre);
      }
    }
    const double n = errors.count;
    std::printf("%.1f m: %d of 50, range off by %.4f m, told %.4f m; normalised %.2f, %.2f\n",
                depth, errors.count, std::sqrt(errors.range / n), std::sqrt(errors.told_range / n),
                errors.normalised_range / n, errors.normalised_bearing / n);
    EXPECT_GE(errors.count, 45);
    EXPECT_THAT(errors.normalised_range / n, AllOf(Gt(0.2), Lt(2.0))) << depth;
    EXPECT_THAT(errors.normalised_bearing / n, AllOf(Gt(0.01), Lt(1.0))) << depth;
  }
}

TEST_F(Fiducials, RangeGrowsUncertainWithTheSquareOfTheDistance) {
  const auto near = seen({markerAt(5, {0.0, 0.0, 0.75}, 0.7)});
  const auto far = seen({markerAt(5, {0.0, 0.0, 1.5}, 0.7)});
  ASSERT_THAT(near, SizeIs(1));
  ASSERT_THAT(far, SizeIs(1));
  EXPECT_NEAR(far[0].range_deviation / near[0].range_deviation, 4.0, 0.5);
  EXPECT_NEAR(far[0].bearing_deviation / near[0].bearing_deviation, 1.0, 0.2);
  // four corners, each off by half a pixel of 1 / 500 rad
  EXPECT_NEAR(far[0].bearing_deviation, 0.5 * 0.5 / 500.0, 2e-4);
}

TEST_F(Fiducials, APlaceThatIsNotWellKnownMakesThemUncertain) {
  options_.place_std = 0.1;
  const auto found = seen({markerAt(5, {0.0, 0.0, 1.0}, 0.7)});
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_NEAR(found[0].range_deviation, 0.1, 0.005);
  EXPECT_NEAR(found[0].bearing_deviation, 0.1, 0.005);
}

TEST_F(Fiducials, OnTheCeilingHaveTheirHorizontalDistance) {
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  const cv::Mat grey = picture({markerAt(5, {0.4, 0.0, 1.5}, 0.3)});
  const auto level = FiducialDetector(options_).detect(grey, camera().calibration());
  const auto upright = FiducialDetector(options_).detect(grey, camera().calibration(), up);
  ASSERT_THAT(level, SizeIs(1));
  ASSERT_THAT(upright, SizeIs(1));
  EXPECT_LT(upright[0].range_deviation, 0.5 * level[0].range_deviation);
  options_.max_range = 1.0;
  EXPECT_THAT(FiducialDetector(options_).detect(grey, camera().calibration()), IsEmpty());
  EXPECT_THAT(FiducialDetector(options_).detect(grey, camera().calibration(), up), SizeIs(1));
  const auto above = FiducialDetector(options_).detect(picture({markerAt(5, {0.0, 0.0, 1.5})}),
                                                       camera().calibration(), up);
  ASSERT_THAT(above, SizeIs(1)) << "a bearing that is none does no harm";
  EXPECT_GT(above[0].bearing_deviation, 0.1);
}

TEST_F(Fiducials, HalfAMarkerIsNone) {
  EXPECT_THAT(seen({markerAt(3, {0.64, 0.0, 1.0})}), IsEmpty()) << "half of it beyond the edge";
  cv::Mat grey = picture({markerAt(3, {0.0, 0.0, 1.0})});
  grey.colRange(320, 640) = 120;
  EXPECT_THAT(FiducialDetector(options_).detect(grey, camera().calibration()), IsEmpty());
}

TEST_F(Fiducials, ThereAreNoneInPicturesOfOtherThings) {
  EXPECT_THAT(seen({}), IsEmpty());
  cv::Mat noise(480, 640, CV_8UC1);
  cv::RNG random(3);
  random.fill(noise, cv::RNG::UNIFORM, 0, 256);
  EXPECT_THAT(FiducialDetector(options_).detect(noise, camera().calibration()), IsEmpty());
  options_.dictionary = "DICT_6X6_50";
  const cv::Mat other = picture({markerAt(3, {0.0, 0.0, 1.0})});
  options_.dictionary = "DICT_4X4_50";
  EXPECT_THAT(FiducialDetector(options_).detect(other, camera().calibration()), IsEmpty());
}

/// However narrow the white around them: that of a cell is the narrower, the more cells there are.
TEST_F(Fiducials, OfAllDictionariesAreFound) {
  EXPECT_THAT(dictionaryNames(), SizeIs(21));
  for (const std::string& name : dictionaryNames()) {
    options_.dictionary = name;
    const auto found = seen({markerAt(11, {0.1, 0.0, 0.8}, 0.3)});
    ASSERT_THAT(found, SizeIs(1)) << name;
    EXPECT_EQ(found[0].id, 11) << name;
  }
  options_.dictionary = "DICT_3X3";
  EXPECT_THAT([this] { FiducialDetector detector(options_); },
              ThrowsMessage<std::invalid_argument>(
                  HasSubstr("option 'dictionary': got 'DICT_3X3', expected one of OpenCV's")));
}

TEST(FiducialPictures, OfAnySizeAreLookedAt) {
  const FiducialDetector detector(byPixels());
  for (const cv::Size size : {cv::Size(1, 1), {2, 3}, {1, 2000}, {2000, 1}, {7, 7}, {20, 20}}) {
    const cv::Mat grey(size, CV_8UC1, cv::Scalar(200));
    EXPECT_THAT(detector.detect(grey, calibrationOf(size.width, size.height, 10.0)), IsEmpty())
        << size;
  }
}

TEST(FiducialPictures, OfAnotherSizeOrKindAreRefused) {
  const FiducialDetector detector(byPixels());
  const auto calibration = calibrationOf(640, 480, 500.0);
  EXPECT_THAT([&] { detector.detect(cv::Mat::zeros(240, 320, CV_8UC1), calibration); },
              ThrowsMessage<std::invalid_argument>(
                  HasSubstr("picture: got 320 x 240 pixels, expected 640 x 480")));
  EXPECT_THAT([&] { detector.detect(cv::Mat::zeros(480, 640, CV_8UC3), calibration); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("expected one channel of 8 bits")));
  EXPECT_THAT([&] { detector.detect({}, calibration); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("picture: got")));
}

/// Focal lengths that no camera has lead to no numbers that are none.
TEST_F(Fiducials, OfCamerasThatCannotBeHaveFiniteNumbersOrAreNone) {
  const cv::Mat grey = picture({markerAt(3, {0.0, 0.0, 1.0})});
  options_.max_range = 1e4;
  for (const double focal_length : {1e-300, 1e-9, 1.0, 1e9, 1e300}) {
    const auto found =
        FiducialDetector(options_).detect(grey, calibrationOf(640, 480, focal_length));
    for (const Fiducial& fiducial : found) {
      EXPECT_TRUE(fiducial.centre.allFinite()) << focal_length;
      EXPECT_GT(fiducial.range_deviation, 0.0) << focal_length;
      EXPECT_GT(fiducial.bearing_deviation, 0.0) << focal_length;
    }
  }
}

}  // namespace
}  // namespace adaptive_localization
