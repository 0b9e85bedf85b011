// SPDX-License-Identifier: BSD-3-Clause
// The program sonar_map with a recorded drive.
#include <gmock/gmock.h>
#include <sensor_msgs/Range.h>

#include "adaptive_localization/map/map_io.hpp"
#include "eval/bag_writer.hpp"
#include "support/program.hpp"

namespace adaptive_localization {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;
using Arguments = std::vector<std::string>;

constexpr double kWall = 1.0;        // m, y of a wall along the map's x axis
constexpr double kSonarAhead = 0.1;  // m, of base

/// 4 m along a wall to the left, at (1, 0) in the map at first, with one sonar that looks at it.
class SonarMapOfABag : public testing::Test {
 protected:
  SonarMapOfABag() { write("sonar_left"); }

  void write(const std::string& frame) const {
    BagWriter bag(bag_);
    bag.laserTransform(100.0);
    bag.transform("/tf_static", 100.0, "base_link", "sonar_left", kSonarAhead, 0.15, yaw(kPi / 2));
    for (int i = 0; i <= 200; ++i) {
      const double stamp = 100.0 + 0.1 * i, driven = 0.02 * i;
      bag.odometryTransform(stamp, {driven, 0.0, 0.0});
      bag.pose("/truth", stamp, {1.0 + driven, 0.0, 0.0});
      bag.scan("/scan", stamp);
      bag.write("/sonar", stamp, ping(stamp, frame));
    }
  }

  static sensor_msgs::Range ping(double stamp, const std::string& frame) {
    sensor_msgs::Range message;
    message.header.stamp = ros::Time(stamp);
    message.header.frame_id = frame;
    message.field_of_view = 0.4F;
    message.min_range = 0.1F;
    message.max_range = 4.0F;
    message.range = static_cast<float>(kWall - 0.15);
    return message;
  }

  ProgramResult run(const Arguments& more) const {
    Arguments arguments{"--bag", bag_};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return runProgram(SONAR_MAP, arguments);
  }

  /// From in front of the sonar to what is taken for occupied first, along the middle half of the
  /// path, which begins at such an x.
  static void expectWall(const OccupancyGrid& map, double begin) {
    constexpr double kFront = 0.4, kStep = 0.01;  // m
    for (double x = begin + 1.0; x < begin + 3.0; x += 0.05) {
      const auto cellAt = [&](double y) { return map.lattice().cellAt({x, y}); };
      double y = kFront;
      while (map.isFree(cellAt(y))) y += kStep;
      EXPECT_GT(y, kWall - 0.25) << "free to here at x = " << x;
      while (y < 2.0 * kWall && !map.isOccupied(cellAt(y))) y += kStep;
      EXPECT_NEAR(y, kWall, 0.1) << "at x = " << x;
    }
  }

  void expectError(const Arguments& arguments, const std::string& why) const {
    const ProgramResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.errors, AllOf(StartsWith("sonar_map: "), HasSubstr(why)));
    EXPECT_THAT(result.output, IsEmpty());
  }

  TempFolder folder_;
  std::string bag_ = folder_.file("drive.bag");
};

TEST_F(SonarMapOfABag, HasTheWallWhereItIs) {
  const ProgramResult result =
      run({"--truth-topic", "/truth", "--out", folder_.file("out"), "sonar_topics:=sonar"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(result.errors, Not(HasSubstr("warning")));
  EXPECT_THAT(result.output, StartsWith("201 readings\n"));
  for (const std::string model : {"moravec-elfes", "elfes", "konolige"}) {
    SCOPED_TRACE(model);
    expectWall(loadMap(folder_.file("out/" + model + "/map.yaml")), 1.0);
  }
}

TEST_F(SonarMapOfABag, IsOfTheOdometrysFrameIfAskedFor) {
  const ProgramResult result = run({"--poses", "odometry", "--out", folder_.file("out"), "--model",
                                    "elfes", "--quiet", "sonar_topics:=/sonar"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(result.output, IsEmpty());
  expectWall(loadMap(folder_.file("out/elfes/map.yaml")), 0.0);
}

TEST_F(SonarMapOfABag, NamesWhatIsWrong) {
  expectError({"--truth-topic", "/truth"},
              "'" + bag_ + "': no readings of sonars; sonar_topics:=TOPIC names their topics");
  expectError({"--truth-topic", "/truth", "sonar_topics:=sonars"},
              "no topic 'sonars' with sonars in this bag");
  expectError({"--truth-topic", "/pose", "sonar_topics:=sonar"},
              "--truth-topic: got '/pose', expected a topic with poses of this bag: /truth");
  expectError({"--poses", folder_.file("none.tum"), "sonar_topics:=sonar"}, "none.tum");
}

TEST_F(SonarMapOfABag, NamesAFrameThatTfDoesNotHave) {
  write("sonar_right");
  expectError({"--truth-topic", "/truth", "sonar_topics:=sonar"},
              "messages of the sonars dropped: 201 of 201; the first: ");
  expectError({"--truth-topic", "/truth", "sonar_topics:=sonar"}, "sonar_right");
}

}  // namespace
}  // namespace adaptive_localization
