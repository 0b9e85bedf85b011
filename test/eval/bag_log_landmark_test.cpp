// SPDX-License-Identifier: BSD-3-Clause
// Landmarks out of a bag.
#include <functional>
#include <limits>

#include "eval/bag_log_fixture.hpp"
#include "support/sighted_points.hpp"

namespace adaptive_localization {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class BagLogLandmarks : public BagLog {
 protected:
  BagLogLandmarks() {
    request_.landmarks.landmark_topic = "landmarks";
    request_.landmark_map = LandmarkMap({{3, {5.0, 0.0}}, {4, {7.0, 1.0}}});
  }

  /// Of a camera that sits 0.1 m before base, turned to the left by a quarter.
  static sensor_msgs::PointCloud picture(double stamp, float id) {
    return toMessage(stamp, "camera", {{id, {0.0F, -2.0F}}});
  }

  /// A drive of 3 s at 1 m/s with a scan in the middle between two odometry readings, and these
  /// pictures.
  void write(const std::vector<sensor_msgs::PointCloud>& pictures) const {
    BagWriter bag(request_.file);
    bag.laserTransform(100.0);
    bag.transform("/tf_static", 100.0, "base_link", "camera", 0.1, 0.0, yaw(kPi / 2));
    for (int i = 0; i <= 30; ++i) {
      const double stamp = 100.0 + 0.1 * i;
      bag.odometryTransform(stamp, {stamp - 100.0, 0.0, 0.0});
      if (i < 30) bag.scan("/scan", stamp + 0.05);
    }
    for (const auto& message : pictures) bag.write("/landmarks", 103.0, message);
  }

  /// As a driver sends them, one before each scan.
  void writeUsual(const std::function<void(sensor_msgs::PointCloud&)>& spoil = [](auto&) {}) const {
    std::vector<sensor_msgs::PointCloud> pictures;
    for (int i = 1; i < 30; ++i) {
      pictures.push_back(picture(100.03 + 0.1 * i, 3.0F));
      spoil(pictures.back());
    }
    write(pictures);
  }

  void expectDropped(const std::function<void(sensor_msgs::PointCloud&)>& spoil,
                     const std::string& why) const {
    writeUsual(spoil);
    EXPECT_THAT(readLog(request_).warnings,
                ElementsAre(AllOf(HasSubstr("messages of the landmarks dropped: 29 of 29"),
                                  HasSubstr(why))));
  }
};

TEST_F(BagLogLandmarks, ComeWithTheNextScanFromWhereTheRobotIsByThen) {
  writeUsual();
  const Log log = readLog(request_);
  EXPECT_THAT(log.warnings, IsEmpty());
  ASSERT_EQ(log.scans.size(), 30U);
  EXPECT_FALSE(log.scans[0].landmarks);
  for (std::size_t i = 1; i < log.scans.size(); ++i) {
    ASSERT_TRUE(log.scans[i].landmarks) << i;
    ASSERT_THAT(*log.scans[i].landmarks, SizeIs(1)) << i;
    const Sighting& sighting = log.scans[i].landmarks->front();
    EXPECT_EQ(sighting.id, 3);
    EXPECT_NEAR(sighting.range, 2.1 - 0.02, 1e-5);  // 20 ms later
    EXPECT_NEAR(sighting.bearing, 0.0, 1e-5);
    EXPECT_NEAR(sighting.range_deviation, 0.1, 1e-5);
  }
}

TEST_F(BagLogLandmarks, AreNotReadUnlessAskedFor) {
  writeUsual();
  request_.landmarks.landmark_topic.clear();
  EXPECT_FALSE(readLog(request_).scans[5].landmarks);
}

TEST_F(BagLogLandmarks, TheLastPictureBeforeAScanCounts) {
  write({picture(100.51, 3.0F), picture(100.53, 4.0F), picture(100.55, -1.0F)});
  const Log log = readLog(request_);
  EXPECT_THAT(log.warnings, IsEmpty());
  ASSERT_TRUE(log.scans[5].landmarks);
  EXPECT_THAT(*log.scans[5].landmarks, ElementsAre(testing::Field(&Sighting::id, -1)))
      << "at the scan's own stamp";
  EXPECT_FALSE(log.scans[4].landmarks);
  EXPECT_FALSE(log.scans[6].landmarks);
}

TEST_F(BagLogLandmarks, NoneInSightIsToldToo) {
  write({toMessage(101.53, "camera", {})});
  const Log log = readLog(request_);
  ASSERT_TRUE(log.scans[15].landmarks);
  EXPECT_THAT(*log.scans[15].landmarks, IsEmpty());
}

TEST_F(BagLogLandmarks, AnOldPictureTellsNothing) {
  {
    BagWriter bag(request_.file);
    bag.laserTransform(100.0);
    for (int i = 0; i <= 30; ++i) bag.odometryTransform(100.0 + 0.1 * i, {0.1 * i, 0.0, 0.0});
    for (const double stamp : {100.2, 101.1, 102.0}) bag.scan("/scan", stamp);
    for (const double stamp : {100.55, 101.55}) {
      bag.write("/landmarks", stamp, toMessage(stamp, "base_link", {{3.0F, {2.0F, 0.0F}}}));
    }
  }
  const Log log = readLog(request_);
  ASSERT_THAT(log.scans, SizeIs(3));
  EXPECT_FALSE(log.scans[1].landmarks) << "0.55 s later";
  EXPECT_TRUE(log.scans[2].landmarks) << "0.45 s later";
}

TEST_F(BagLogLandmarks, WhatCannotBeUsedIsCountedAndNamed) {
  expectDropped([](auto& message) { message.header.frame_id = "nowhere"; }, "nowhere");
  expectDropped([](auto& message) { message.header.frame_id = "/"; }, "its frame_id is empty");
  expectDropped([](auto& message) { message.header.stamp.sec = 0xFFFFFFFFU; },
                "its stamp is out of range");
  expectDropped([](auto& message) { message.channels[0].values = {77.0F}; },
                "id of a landmark: got 77, which is not in the map");
  expectDropped([](auto& message) { message.channels[0].values = {0.5F}; },
                "id of a landmark: got 0.5");
  expectDropped(
      [](auto& message) { message.points[0].x = std::numeric_limits<float>::quiet_NaN(); },
      "place of a landmark");
  expectDropped([](auto& message) { message.channels[1].values = {0.0F}; }, "range_std");
  expectDropped([](auto& message) { message.channels.resize(2); },
                "it has no channel 'bearing_std'");
}

TEST_F(BagLogLandmarks, LateStampsAreRefused) {
  write({picture(100.53, 3.0F), picture(101.53, 4.0F), picture(101.23, 4.0F), picture(101.53, 3.0F),
         picture(2e9, 3.0F), picture(102.53, 3.0F)});
  const Log log = readLog(request_);
  EXPECT_THAT(log.warnings,
              ElementsAre(AllOf(HasSubstr("messages of the landmarks dropped: 2 of 6"),
                                HasSubstr("its stamp does not come after the last one"))));
  EXPECT_FALSE(log.scans[12].landmarks);
  EXPECT_TRUE(log.scans[25].landmarks) << "one from the future does not spoil those after it";
}

TEST_F(BagLogLandmarks, ATopicThatIsNoneOfThemIsNamed) {
  writeUsual();
  request_.landmarks.landmark_topic = "/markers";
  EXPECT_THAT(readLog(request_).warnings,
              ElementsAre(HasSubstr("no topic '/markers' with landmarks")));
  request_.landmarks.landmark_topic = "scan";
  EXPECT_THAT(readLog(request_).warnings,
              ElementsAre("option 'landmark_topic': the messages of 'scan' are "
                          "sensor_msgs/LaserScan, expected sensor_msgs/PointCloud"));
}

TEST_F(BagLogLandmarks, AreOfUseWithAMapOfThemAlone) {
  writeUsual();
  request_.landmark_map = {};
  expectRejected("option 'landmark_topic': got 'landmarks' without a landmark_map, expected both");
}

}  // namespace
}  // namespace adaptive_localization
