// SPDX-License-Identifier: BSD-3-Clause
#include "bag/sighting_ear.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <stdexcept>

#include "support/sighted_points.hpp"

namespace adaptive_localization {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::ThrowsMessage;

class SightingsHeard : public testing::Test {
 protected:
  SightingsHeard() { topics_.landmark_topic = "/landmarks"; }

  static sensor_msgs::PointCloud message(double stamp, const std::vector<float>& ids) {
    std::vector<SightedPoint> points;
    for (const float id : ids) points.push_back({id, {2.0F, 0.0F}});
    return toMessage(stamp, "camera", points);
  }

  std::optional<Picture> read(const sensor_msgs::PointCloud& message) {
    return ear_.read(message, Eigen::Isometry3d::Identity());
  }

  LandmarkTopics topics_;
  std::vector<std::string> complaints_;
  SightingEar ear_{topics_, LandmarkMap({{0, {1.0, 2.0}}, {5, {3.0, 4.0}}}),
                   [this](const std::string& why) { complaints_.push_back(why); }};
};

TEST_F(SightingsHeard, AreThoseOfKnownLandmarks) {
  const auto picture = read(message(1.0, {5.0F, 6.0F, -1.0F, 7.0F}));
  ASSERT_TRUE(picture);
  EXPECT_DOUBLE_EQ(picture->stamp, 1.0);
  EXPECT_THAT(picture->sightings,
              ElementsAre(testing::Field(&Sighting::id, 5), testing::Field(&Sighting::id, -1)));
  EXPECT_THAT(complaints_, ElementsAre("id of a landmark: got 6, which is not in the map",
                                       "id of a landmark: got 7, which is not in the map"));
  EXPECT_EQ(ear_.heard().dropped, 1) << "one message";
}

TEST_F(SightingsHeard, AreAcceptedInOrder) {
  EXPECT_TRUE(ear_.accept(message(1.0, {})));
  EXPECT_TRUE(ear_.accept(message(0.5, {}))) << "none was read yet";
  ASSERT_TRUE(read(message(1.0, {})));
  EXPECT_FALSE(ear_.accept(message(1.0, {})));
  EXPECT_TRUE(ear_.accept(message(1.1, {})));
  ear_.forget();
  EXPECT_TRUE(ear_.accept(message(0.5, {})));
  EXPECT_THAT(complaints_, ElementsAre(HasSubstr("does not come after the last one")));
  EXPECT_EQ(ear_.heard().received, 5);
  EXPECT_EQ(ear_.heard().dropped, 1);
}

TEST_F(SightingsHeard, AreOfSeveralCameras) {
  const auto from = [&](const std::string& frame, double stamp) {
    sensor_msgs::PointCloud seen = message(stamp, {5.0F});
    seen.header.frame_id = frame;
    return seen;
  };
  ASSERT_TRUE(read(from("left", 2.0)));
  EXPECT_TRUE(ear_.accept(from("right", 2.0))) << "at the same time";
  ASSERT_TRUE(read(from("right", 1.9)));
  EXPECT_FALSE(ear_.accept(from("left", 2.0)));
  EXPECT_DOUBLE_EQ(ear_.last().toSec(), 2.0) << "the newest";
}

TEST_F(SightingsHeard, AreNotAcceptedWithoutFrameOrFromTheEndOfTime) {
  sensor_msgs::PointCloud nowhere = message(1.0, {});
  nowhere.header.frame_id = "";
  EXPECT_FALSE(ear_.accept(nowhere));
  EXPECT_FALSE(ear_.accept(message(4294967295.0, {})));
  EXPECT_THAT(complaints_,
              ElementsAre("its frame_id is empty", HasSubstr("stamp is out of range")));
}

TEST_F(SightingsHeard, AMessageThatMakesNoSenseIsNotRead) {
  sensor_msgs::PointCloud torn = message(2.0, {5.0F});
  torn.channels[1].values.clear();
  EXPECT_FALSE(read(torn));
  EXPECT_TRUE(ear_.last().isZero());
  EXPECT_THAT(complaints_, ElementsAre(HasSubstr("channel 'range_std'")));
  EXPECT_EQ(ear_.heard().dropped, 1);
}

TEST_F(SightingsHeard, NeedATopicAndAMap) {
  EXPECT_TRUE(ear_.listensTo("landmarks"));
  EXPECT_FALSE(ear_.listensTo("/landmarks2"));
  EXPECT_THAT([&] { SightingEar(topics_, {}, [](const std::string&) {}); },
              ThrowsMessage<std::invalid_argument>(
                  HasSubstr("got '/landmarks' without a landmark_map, expected both")));
  topics_.landmark_topic.clear();
  const SightingEar deaf(topics_, {}, [](const std::string&) {});
  EXPECT_FALSE(deaf.listensTo(""));
}

TEST_F(SightingsHeard, AreToldFromWhereTheRobotIs) {
  const Picture picture{1.0, {{5, 2.0, kPi / 2, 0.1, 0.05}}};
  std::optional<std::vector<Sighting>> landmarks;
  tell(picture, Pose2{-2.0, 0.0, 0.0}, 1.4, landmarks);
  ASSERT_TRUE(landmarks);
  ASSERT_THAT(*landmarks, SizeIs(1));
  EXPECT_NEAR(landmarks->front().range, std::hypot(2.0, 2.0), 1e-9);
  EXPECT_NEAR(landmarks->front().bearing, 0.75 * kPi, 1e-9);
  tell(picture, {}, 1.45, landmarks);
  EXPECT_THAT(*landmarks, SizeIs(2)) << "beside those that are there";
}

TEST_F(SightingsHeard, AreNotToldLate) {
  std::optional<std::vector<Sighting>> landmarks;
  tell({1.0, {{5, 2.0, 0.0, 0.1, 0.05}}}, {}, 1.6, landmarks);
  EXPECT_FALSE(landmarks);
  tell({1.0, {}}, {}, 1.1, landmarks);
  ASSERT_TRUE(landmarks) << "none in sight";
  EXPECT_THAT(*landmarks, IsEmpty());
}

}  // namespace
}  // namespace adaptive_localization
