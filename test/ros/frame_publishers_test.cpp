// SPDX-License-Identifier: BSD-3-Clause
#include "ros/frame_publishers.hpp"

#include <gtest/gtest.h>

namespace adaptive_localization {
namespace {

class FramePublishersTest : public testing::Test {
 protected:
  static ros::SteadyTime at(double seconds) { return ros::SteadyTime(100.0 + seconds); }

  void hear(double seconds, const std::string& publisher, const std::string& frame = "odom") {
    publishers_.hear(frame, publisher, at(seconds));
  }

  std::string rivals(double seconds) const { return publishers_.rivals(at(seconds)); }

  FramePublishers publishers_;
};

TEST_F(FramePublishersTest, OnePublisherOfManyFramesHasNoRival) {
  for (int i = 0; i < 100; ++i) {
    hear(0.1 * i, "/robot", "base_link");
    hear(0.1 * i, "/amcl", "odom");
  }
  EXPECT_EQ(rivals(10.0), "");
}

TEST_F(FramePublishersTest, TwoThatTakeTurnsAreNamed) {
  hear(0.0, "/robot");
  hear(0.1, "/amcl");
  EXPECT_EQ(rivals(0.1), "");
  hear(0.2, "/robot");
  EXPECT_EQ(rivals(0.2), "'odom' is published by /amcl and by /robot");
  hear(0.3, "/amcl");
  EXPECT_EQ(rivals(0.3), "'odom' is published by /amcl and by /robot");
}

TEST_F(FramePublishersTest, ASlowOneBesideAFastOneIsNamed) {
  for (int i = 0; i < 100; ++i) {
    hear(0.05 * i, "/fast");
    if (i % 40 == 0) hear(0.05 * i, "/slow");
  }
  EXPECT_EQ(rivals(5.0), "'odom' is published by /fast and by /slow");
}

TEST_F(FramePublishersTest, OneThatTakesOverIsNoRival) {
  for (int i = 0; i < 20; ++i) hear(0.1 * i, "/play_1");
  for (int i = 20; i < 60; ++i) hear(0.1 * i, "/play_2");
  for (int i = 60; i < 90; ++i) hear(0.1 * i, "/play_1");
  EXPECT_EQ(rivals(9.0), "");
}

TEST_F(FramePublishersTest, AFixedOneBesideOneThatMovesIsNamed) {
  publishers_.hearFixed("odom", "/leftover");
  publishers_.hearFixed("laser", "/robot");
  EXPECT_EQ(rivals(0.0), "") << "alone";
  hear(1.0, "/localization");
  EXPECT_EQ(rivals(1.0), "'odom' is published by /localization and, as fixed, by /leftover");
  EXPECT_EQ(rivals(9.0), "") << "the other one has ended";
}

TEST_F(FramePublishersTest, AllFramesInDisputeAreNamed) {
  for (int i = 0; i < 3; ++i) {
    for (const char* publisher : {"/a", "/b"}) {
      for (const char* frame : {"base_link", "odom"}) hear(0.1 * i, publisher, frame);
    }
  }
  EXPECT_EQ(rivals(0.3),
            "'base_link' is published by /a and by /b; 'odom' is published by /a and by /b");
}

TEST_F(FramePublishersTest, ADisputeThatIsOverIsForgotten) {
  for (int i = 0; i < 10; ++i) hear(0.1 * i, i % 2 == 0 ? "/a" : "/b");
  for (int i = 10; i < 60; ++i) hear(0.1 * i, "/a");
  EXPECT_NE(rivals(2.0), "");
  EXPECT_EQ(rivals(6.0), "");
}

}  // namespace
}  // namespace adaptive_localization
