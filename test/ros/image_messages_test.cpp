// SPDX-License-Identifier: BSD-3-Clause
#include "ros/image_messages.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace adaptive_localization {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Of 2 x 2 pixels, with a byte more in each line.
sensor_msgs::Image image(const std::string& encoding, std::vector<std::uint8_t> data) {
  sensor_msgs::Image message;
  message.encoding = encoding;
  message.width = message.height = 2;
  message.step = static_cast<std::uint32_t>(data.size() / 2);
  message.data = std::move(data);
  return message;
}

sensor_msgs::CameraInfo cameraInfo() {
  sensor_msgs::CameraInfo message;
  message.width = 640;
  message.height = 480;
  message.distortion_model = "plumb_bob";
  message.D = {0.1, -0.2, 0.001, 0.002, 0.03};
  message.K = {500, 0, 321, 0, 510, 239, 0, 0, 1};
  message.P = {450, 0, 322, 0, 0, 460, 238, 0, 0, 0, 1, 0};
  return message;
}

void expectRefusal(const sensor_msgs::Image& message, const std::string& text) {
  EXPECT_THAT([&] { toGrey(message); }, ThrowsMessage<std::invalid_argument>(HasSubstr(text)));
}

void expectRefusal(const sensor_msgs::CameraInfo& message, const std::string& text,
                   bool is_rectified = false) {
  EXPECT_THAT([&] { toCalibration(message, is_rectified); },
              ThrowsMessage<std::invalid_argument>(HasSubstr(text)));
}

std::vector<int> levels(const cv::Mat& grey) {
  return {grey.at<std::uint8_t>(0, 0), grey.at<std::uint8_t>(0, 1), grey.at<std::uint8_t>(1, 0),
          grey.at<std::uint8_t>(1, 1)};
}

}  // namespace

TEST(ImageMessages, GreyOnesAreTakenAsTheyAre) {
  const auto message = image("mono8", {1, 2, 99, 3, 4, 99});
  const cv::Mat grey = toGrey(message);
  EXPECT_THAT(levels(grey), ElementsAre(1, 2, 3, 4));
  EXPECT_EQ(grey.data, message.data.data()) << "not copied";
}

TEST(ImageMessages, ColoursAreWeighedInTheirOrder) {
  const std::vector<std::uint8_t> data{200, 0, 0, 0, 200, 0, 99, 0, 0, 200, 50, 50, 50, 99};
  EXPECT_THAT(levels(toGrey(image("rgb8", data))), ElementsAre(60, 117, 23, 50));
  EXPECT_THAT(levels(toGrey(image("bgr8", data))), ElementsAre(23, 117, 60, 50));
}

TEST(ImageMessages, OtherEncodingsAreRefused) {
  for (const std::string encoding : {"bayer_rggb8", "mono16", "yuv422", "32FC1", ""}) {
    expectRefusal(image(encoding, {1, 2, 3, 4}),
                  "encoding of an image: got '" + encoding + "', expected mono8, rgb8 or bgr8");
  }
}

TEST(ImageMessages, SizesThatCannotBeAreRefused) {
  auto message = image("mono8", {1, 2, 3});
  message.step = 2;
  expectRefusal(message, "bytes of an image: got 3, expected at least 4");
  message.step = 1;
  expectRefusal(message, "step of an image: got 1, expected at least 2");
  message.width = 0;
  expectRefusal(message, "size of an image: got 0 x 2, expected 1 to 32768 pixels");
  message.width = 30000;
  message.height = std::numeric_limits<std::uint32_t>::max();
  expectRefusal(message, "size of an image: got 30000 x 4294967295");
  message.height = 30000;
  message.step = std::numeric_limits<std::uint32_t>::max();
  expectRefusal(message, "bytes of an image: got 3, expected at least 128849018850000");
}

TEST(ImageMessages, ACalibrationIsOfRawOrRectifiedImages) {
  const auto raw = toCalibration(cameraInfo(), false);
  EXPECT_EQ(raw.size, cv::Size(640, 480));
  EXPECT_EQ(raw.matrix, cv::Matx33d(500, 0, 321, 0, 510, 239, 0, 0, 1));
  EXPECT_THAT(raw.distortion, ElementsAre(0.1, -0.2, 0.001, 0.002, 0.03));
  const auto rectified = toCalibration(cameraInfo(), true);
  EXPECT_EQ(rectified.matrix, cv::Matx33d(450, 0, 322, 0, 460, 238, 0, 0, 1));
  EXPECT_THAT(rectified.distortion, IsEmpty());
}

TEST(ImageMessages, ACameraThatIsNotCalibratedIsRefused) {
  auto message = cameraInfo();
  for (const double value : {0.0, -1.0, kNan}) {
    message.K[4] = value;
    expectRefusal(message, "focal length in camera_info's K: got ");
  }
  message.K = {};
  expectRefusal(message, "focal length in camera_info's K: got 0, expected one above 0");
  message.P[5] = 0.0;
  expectRefusal(message, "focal length in camera_info's P: got 0", true);
  message = cameraInfo();
  message.K[5] = kNan;
  expectRefusal(message, "middle in camera_info's K: got nan");
  message.height = 0;
  expectRefusal(message, "size of camera_info: got 640 x 0");
}

TEST(ImageMessages, ADistortionThatIsNotOursIsRefusedUnlessTheImagesAreRectified) {
  auto message = cameraInfo();
  message.D[2] = kNan;
  expectRefusal(message, "value in camera_info's D: got nan");
  message.D.resize(2);
  expectRefusal(message, "number of values in camera_info's D: got 2, expected 0, 4, 5 or 8");
  message.distortion_model = "equidistant";
  expectRefusal(message, "distortion_model of camera_info: got 'equidistant'");
  EXPECT_NO_THROW(toCalibration(message, true));
  message.P[3] = -45.0;
  expectRefusal(message, "fourth value in camera_info's P: got -45", true);
}

}  // namespace adaptive_localization
