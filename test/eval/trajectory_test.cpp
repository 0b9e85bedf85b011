// SPDX-License-Identifier: BSD-3-Clause
#include "eval/trajectory.hpp"

#include <gmock/gmock.h>

#include <sstream>

#include "support/temp_folder.hpp"

namespace adaptive_localization {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

Trajectory read(const std::string& text, std::vector<std::string>& warnings) {
  std::istringstream input(text);
  return readTum(input, "t.tum", warnings);
}

TEST(Trajectory, InterpolatesBetweenPoses) {
  const Trajectory trajectory({{10.0, {0.0, 0.0, 0.0}}, {12.0, {2.0, 4.0, 1.0}}});
  const auto pose = trajectory.at(10.5);
  ASSERT_TRUE(pose);
  EXPECT_DOUBLE_EQ(pose->x, 0.5);
  EXPECT_DOUBLE_EQ(pose->y, 1.0);
  EXPECT_DOUBLE_EQ(pose->theta, 0.25);
}

TEST(Trajectory, TurnsTheShortWayRound) {
  const Trajectory trajectory({{0.0, {0.0, 0.0, kPi - 0.1}}, {1.0, {0.0, 0.0, -kPi + 0.3}}});
  EXPECT_NEAR(trajectory.at(0.25)->theta, kPi, 1e-12);
  EXPECT_NEAR(trajectory.at(0.5)->theta, -kPi + 0.1, 1e-12);
}

TEST(Trajectory, KnowsNothingOutside) {
  const Trajectory trajectory({{10.0, {}}, {12.0, {}}});
  EXPECT_FALSE(trajectory.at(9.99));
  EXPECT_FALSE(trajectory.at(12.01));
  EXPECT_TRUE(trajectory.at(9.9995));
  EXPECT_TRUE(trajectory.at(12.0005));
  EXPECT_FALSE(Trajectory().at(0.0));
}

TEST(Trajectory, KnowsNothingInALongGapButAtItsEnds) {
  const Trajectory trajectory({{10.0, {1.0, 0.0, 0.0}}, {12.0, {2.0, 0.0, 0.0}}});
  EXPECT_FALSE(trajectory.at(11.0, 1.0));
  EXPECT_DOUBLE_EQ(trajectory.at(10.0, 1.0)->x, 1.0);
  EXPECT_DOUBLE_EQ(trajectory.at(10.0005, 1.0)->x, 1.0);
  EXPECT_DOUBLE_EQ(trajectory.at(11.9995, 1.0)->x, 2.0);
}

TEST(Trajectory, SortsAndKeepsTheLastOfASameStamp) {
  const Trajectory trajectory({{2.0, {5.0, 0.0, 0.0}}, {1.0, {}}, {2.0, {7.0, 0.0, 0.0}}});
  ASSERT_EQ(trajectory.poses().size(), 2U);
  EXPECT_DOUBLE_EQ(trajectory.at(2.0)->x, 7.0);
}

TEST(Tum, ReadsWhatItWrites) {
  const std::vector<StampedPose> poses{{1600000000.123456, {1.25, -2.5, 3.0}},
                                       {1600000001.0, {0.0, 0.0, -kPi / 2}}};
  std::ostringstream text;
  writeTum(poses, text);
  std::vector<std::string> warnings;
  const Trajectory again = read(text.str(), warnings);
  EXPECT_THAT(warnings, testing::IsEmpty());
  ASSERT_EQ(again.poses().size(), 2U);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    EXPECT_NEAR(again.poses()[i].stamp, poses[i].stamp, 1e-6);
    EXPECT_NEAR(distance(again.poses()[i].pose, poses[i].pose), 0.0, 1e-6);
    EXPECT_NEAR(again.poses()[i].pose.theta, poses[i].pose.theta, 1e-8);
  }
}

TEST(Tum, NamesBrokenLinesByNumber) {
  std::vector<std::string> warnings;
  const Trajectory trajectory = read(
      "# comment\n"
      "1 0 0 0 0 0 0 1\n"
      "2 0 0 0 0 0 0\n"
      "\n"
      "three 0 0 0 0 0 0 1\n"
      "4 0 0 0 0 0 0 1 5\n"
      "5 0 0 0 0 0 0 7\n"
      "6 nan 0 0 0 0 0 1\n"
      "7 1 0 0 0 0 0 1\r\n",
      warnings);
  EXPECT_EQ(trajectory.poses().size(), 2U);
  EXPECT_THAT(warnings,
              ElementsAre(HasSubstr("'t.tum' line 3: got '2 0 0 0 0 0 0'"), HasSubstr("line 5"),
                          HasSubstr("line 6"), HasSubstr("line 7"), HasSubstr("line 8")));
}

TEST(Tum, NeedsAPose) {
  std::vector<std::string> warnings;
  EXPECT_THAT([&] { read("# nothing\n", warnings); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("'t.tum': no pose found")));
  EXPECT_THAT([&] { loadTum("/does/not/exist.tum", warnings); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("'/does/not/exist.tum'")));
}

TEST(Tum, SaysWhichFileCannotBeWritten) {
  EXPECT_THAT([] { saveTum({}, "/does/not/exist.tum"); },
              ThrowsMessage<std::runtime_error>(HasSubstr("'/does/not/exist.tum'")));
}

}  // namespace
}  // namespace adaptive_localization
