// SPDX-License-Identifier: BSD-3-Clause
#include "bag/sighting_messages.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "adaptive_localization/core/pose2.hpp"

namespace adaptive_localization {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::ThrowsMessage;

class Sightings : public testing::Test {
 protected:
  void add(float x, float y, float id, float range_std = 0.1F, float bearing_std = 0.05F) {
    geometry_msgs::Point32 point;
    point.x = x;
    point.y = y;
    point.z = 0.3F;
    message_.points.push_back(point);
    message_.channels.resize(3);
    const char* const names[] = {"id", "range_std", "bearing_std"};
    const float values[] = {id, range_std, bearing_std};
    for (std::size_t k = 0; k < 3; ++k) {
      message_.channels[k].name = names[k];
      message_.channels[k].values.push_back(values[k]);
    }
  }

  std::vector<Sighting> read() {
    return toSightings(message_, T_base_sensor_,
                       [this](const std::string& why) { refused_.push_back(why); });
  }

  sensor_msgs::PointCloud message_;
  Eigen::Isometry3d T_base_sensor_ = Eigen::Isometry3d::Identity();
  std::vector<std::string> refused_;
};

TEST_F(Sightings, AreRangeAndBearingOfPoints) {
  add(3.0F, 4.0F, 7.0F);
  add(0.0F, -2.0F, -1.0F, 0.2F, 0.3F);
  const auto sightings = read();
  ASSERT_THAT(sightings, SizeIs(2));
  EXPECT_EQ(sightings[0].id, 7);
  EXPECT_NEAR(sightings[0].range, 5.0, 1e-6);
  EXPECT_NEAR(sightings[0].bearing, std::atan2(4.0, 3.0), 1e-6);
  EXPECT_NEAR(sightings[0].range_deviation, 0.1, 1e-6);
  EXPECT_NEAR(sightings[0].bearing_deviation, 0.05, 1e-6);
  EXPECT_EQ(sightings[1].id, -1);
  EXPECT_NEAR(sightings[1].bearing, -kPi / 2, 1e-6);
  EXPECT_NEAR(sightings[1].bearing_deviation, 0.3, 1e-6);
  EXPECT_THAT(refused_, IsEmpty());
}

TEST_F(Sightings, OfASensorElsewhereAreOfBase) {
  T_base_sensor_.linear() = Eigen::AngleAxisd(kPi / 2, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  T_base_sensor_.translation() = Eigen::Vector3d(1.0, 0.0, 0.5);
  add(2.0F, 1.0F, 0.0F);  // 1 m before base, 1 m back: at (0, 2)
  const auto sightings = read();
  ASSERT_THAT(sightings, SizeIs(1));
  EXPECT_NEAR(sightings[0].range, 2.0, 1e-6);
  EXPECT_NEAR(sightings[0].bearing, kPi / 2, 1e-6);
}

TEST_F(Sightings, WithoutIdsAreNotIdentified) {
  add(1.0F, 0.0F, 3.0F);
  message_.channels[0].name = "colour";
  EXPECT_EQ(read().front().id, -1);
}

TEST_F(Sightings, WhatMakesNoSenseIsNamedAndLeftOut) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  add(kNan, 1.0F, 0.0F);
  add(1.0F, 1.0F, 0.0F, 0.0F);
  add(1.0F, 1.0F, 0.0F, 0.1F, kNan);
  add(1.0F, 1.0F, 0.5F);
  add(1.0F, 1.0F, -2.0F);
  add(1.0F, 1.0F, kNan);
  add(1.0F, 1.0F, 4.0F);
  EXPECT_THAT(read(), SizeIs(1));
  EXPECT_THAT(refused_,
              ElementsAre(HasSubstr("place of a landmark: got"),
                          HasSubstr("range_std of a landmark: got 0, expected one above 0"),
                          HasSubstr("bearing_std of a landmark: got nan"),
                          HasSubstr("id of a landmark: got 0.5"), HasSubstr("got -2"),
                          HasSubstr("id of a landmark: got nan")));
}

TEST_F(Sightings, AChannelThatIsMissingIsNamed) {
  add(1.0F, 0.0F, 3.0F);
  message_.channels[2].values.push_back(1.0F);
  EXPECT_THAT([this] { read(); }, ThrowsMessage<std::invalid_argument>(HasSubstr(
                                      "channel 'bearing_std': got 2 values, expected 1")));
  message_.channels.resize(2);
  EXPECT_THAT([this] { read(); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("no channel 'bearing_std'")));
}

}  // namespace
}  // namespace adaptive_localization
