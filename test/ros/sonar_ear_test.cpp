// SPDX-License-Identifier: BSD-3-Clause
#include "bag/sonar_ear.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace adaptive_localization {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

class Sonars : public testing::Test {
 protected:
  Sonars() { topics_.sonar_topics = "sonar, /more/sonar"; }

  template <class Message>
  std::optional<SonarRound> hear(const Message& message, const std::string& topic = "/sonar") {
    BagMessage bag;
    bag.topic = topic;
    bag.type = ros::message_traits::DataType<Message>::value();
    bag.bytes.resize(ros::serialization::serializationLength(message));
    ros::serialization::OStream stream(bag.bytes.data(),
                                       static_cast<std::uint32_t>(bag.bytes.size()));
    ros::serialization::serialize(stream, message);
    return ear_.hear(bag);
  }

  /// sonar_0 looks ahead from 0.2 m before base, sonar_1 to the left; `pole` looks up.
  static Eigen::Isometry3d placeOf(const std::string& frame) {
    Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
    if (frame == "sonar_0") {
      place.translation() = Eigen::Vector3d(0.2, 0.0, 0.2);
    } else if (frame == "sonar_1") {
      place.linear() = Eigen::AngleAxisd(kPi / 2, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    } else if (frame == "pole") {
      place.linear() = Eigen::AngleAxisd(-kPi / 2, Eigen::Vector3d::UnitY()).toRotationMatrix();
    } else if (frame != "sonar") {
      throw std::invalid_argument("nobody knows frame '" + frame + "'");
    }
    return place;
  }

  sensor_msgs::Range range(float metres, const std::string& frame = "sonar_0") {
    sensor_msgs::Range message;
    message.header.frame_id = frame;
    message.header.stamp = ros::Time(stamp_ += 0.1);
    message.field_of_view = 0.4F;
    message.min_range = 0.2F;
    message.max_range = 4.0F;
    message.range = metres;
    return message;
  }

  SonarArray array(const std::vector<double>& ranges) {
    SonarArray message;
    message.header.stamp = ros::Time(stamp_ += 0.1);
    message.ranges_count = static_cast<std::int32_t>(ranges.size());
    message.ranges = ranges;
    return message;
  }

  sensor_msgs::PointCloud cloud(const std::vector<Eigen::Vector2f>& points) {
    sensor_msgs::PointCloud message;
    message.header.stamp = ros::Time(stamp_ += 0.1);
    message.header.frame_id = "sonar";
    for (const Eigen::Vector2f& point : points) {
      message.points.emplace_back();
      message.points.back().x = point.x();
      message.points.back().y = point.y();
    }
    return message;
  }

  SonarTopics topics_;
  std::vector<std::string> complaints_;
  SonarEar ear_{topics_, placeOf, [this](const std::string& why) { complaints_.push_back(why); }};
  double stamp_{100.0};
};

TEST_F(Sonars, AreHeardEachOnItsOwnTopicOrAllOnOne) {
  const auto round = hear(range(1.5F));
  ASSERT_TRUE(round);
  EXPECT_NEAR(round->stamp, 100.1, 1e-6);
  ASSERT_THAT(round->readings, SizeIs(1));
  const SonarReading& reading = round->readings[0];
  EXPECT_NEAR(reading.range, 1.5, 1e-6);
  EXPECT_NEAR(reading.max_range, 4.0, 1e-6);
  EXPECT_NEAR(reading.view, 0.4, 1e-6);
  EXPECT_NEAR(reading.T_base_sonar.x, 0.2, 1e-9);
  const auto left = hear(range(1.0F, "/sonar_1"), "more/sonar");
  ASSERT_TRUE(left);
  EXPECT_NEAR(left->readings[0].T_base_sonar.theta, kPi / 2, 1e-9);
  EXPECT_NE(left->readings[0].sonar, reading.sonar);
  EXPECT_EQ(hear(range(1.6F))->readings[0].sonar, reading.sonar);
  EXPECT_EQ(ear_.heard().received, 3);
  EXPECT_EQ(ear_.heard().dropped, 0);
}

TEST_F(Sonars, HearNothingOnOtherTopics) {
  EXPECT_FALSE(hear(range(1.5F), "/elsewhere"));
  EXPECT_EQ(ear_.heard().received, 0);
}

TEST_F(Sonars, MayHearNoEcho) {
  for (const float none : {4.0F, kInfinity}) {
    const auto round = hear(range(none));
    ASSERT_TRUE(round);
    EXPECT_TRUE(std::isinf(round->readings[0].range));
  }
}

TEST_F(Sonars, WhatMakesNoSenseIsNamedAndCounted) {
  sensor_msgs::Range odd_view = range(1.0F), odd_reach = range(1.0F), odd_least = range(1.0F);
  odd_view.field_of_view = kNan;
  odd_reach.max_range = kInfinity;
  odd_least.min_range = 5.0F;
  hear(range(kNan));
  hear(range(-kInfinity));
  hear(range(0.1F));
  hear(range(4.5F));
  hear(odd_view);
  hear(odd_reach);
  hear(odd_least);
  hear(range(1.0F, ""));
  hear(range(1.0F, "nowhere"));
  hear(range(1.0F, "pole"));
  EXPECT_THAT(
      complaints_,
      ElementsAre(HasSubstr("range of a sonar: got nan, expected 0.2 to 4 m"),
                  HasSubstr("got -inf"), HasSubstr("got 0.1"), HasSubstr("got 4.5"),
                  HasSubstr("field_of_view"), HasSubstr("max_range"), HasSubstr("min_range"),
                  HasSubstr("frame_id is empty"), HasSubstr("'nowhere'"), HasSubstr("up or down")));
  EXPECT_EQ(ear_.heard().dropped, 10);
}

TEST_F(Sonars, ReadingsThatComeTwiceOrLateAreRefused) {
  const auto first = range(1.0F), second = range(1.1F);
  EXPECT_TRUE(hear(second));
  EXPECT_FALSE(hear(second));
  EXPECT_FALSE(hear(first));
  EXPECT_THAT(complaints_, ElementsAre(HasSubstr("after the last"), HasSubstr("after the last")));
}

TEST_F(Sonars, BeginAnewWhereTimeDid) {
  EXPECT_TRUE(hear(range(1.0F)));
  stamp_ = 10.0;
  EXPECT_TRUE(hear(range(1.0F)));
}

TEST_F(Sonars, OfAnArrayAreKnownByTheirPlaceInIt) {
  const auto round = hear(array({1.0, 2.0}));
  ASSERT_TRUE(round);
  ASSERT_THAT(round->readings, SizeIs(2));
  EXPECT_EQ(round->readings[1].sonar, 1);
  EXPECT_EQ(round->readings[1].range, 2.0);
  EXPECT_EQ(round->readings[1].max_range, topics_.sonar_max_range);
  EXPECT_EQ(round->readings[1].view, topics_.sonar_view);
}

TEST_F(Sonars, OfAnArrayRepeatOldRangesThatAreNotNew) {
  hear(array({1.0, 2.0}));
  const auto round = hear(array({1.0, 2.1}));
  ASSERT_THAT(round->readings, SizeIs(1));
  EXPECT_EQ(round->readings[0].sonar, 1);
  EXPECT_EQ(ear_.heard().dropped, 0);
}

TEST_F(Sonars, OfAnArrayMayBeUnknownOneByOne) {
  const auto round = hear(array({1.0, 2.0, 3.0, 7.0}));
  ASSERT_THAT(round->readings, SizeIs(2));
  EXPECT_THAT(complaints_, ElementsAre(HasSubstr("sonar_2"), HasSubstr("sonar_3")));
  EXPECT_EQ(ear_.heard().dropped, 1);  // message
}

TEST_F(Sonars, OfAnArrayThatContradictsItselfAreRefused) {
  SonarArray message = array({1.0, 2.0});
  message.ranges_count = 16;
  EXPECT_FALSE(hear(message));
  EXPECT_FALSE(hear(array(std::vector<double>(300, 1.0))));
  EXPECT_THAT(complaints_, ElementsAre(HasSubstr("ranges_count: got 16, expected 2"),
                                       HasSubstr("number of sonars: got 300, expected 256")));
}

TEST_F(Sonars, OfACloudAreWhereTheirEchoesCameFrom) {
  const auto round = hear(cloud({{1.7F, 0.0F}, {0.0F, 5.0F}}));
  ASSERT_TRUE(round);
  ASSERT_THAT(round->readings, SizeIs(2));
  EXPECT_NEAR(round->readings[0].range, 1.5, 1e-6);
  EXPECT_TRUE(std::isinf(round->readings[1].range));
}

TEST_F(Sonars, OfACloudMustLieOnTheirAxes) {
  const auto round = hear(cloud({{0.0F, 1.0F}, {kNan, 1.0F}}));
  EXPECT_THAT(round->readings, IsEmpty());
  EXPECT_THAT(complaints_, ElementsAre(HasSubstr("off its sonar's axis"),
                                       HasSubstr("off its sonar's axis: got nan")));
}

TEST_F(Sonars, OfAnotherTypeAreRefused) {
  BagMessage bag;
  bag.topic = "sonar";
  bag.type = "std_msgs/Header";
  EXPECT_FALSE(ear_.hear(bag));
  EXPECT_THAT(complaints_, ElementsAre(HasSubstr("expected sensor_msgs/Range")));
}

TEST_F(Sonars, BytesThatAreNoMessageAreRefused) {
  BagMessage bag;
  bag.topic = "sonar";
  bag.type = "sensor_msgs/Range";
  bag.bytes = {1, 2, 3};
  EXPECT_FALSE(ear_.hear(bag));
  EXPECT_EQ(ear_.heard().dropped, 1);
}

}  // namespace
}  // namespace adaptive_localization
