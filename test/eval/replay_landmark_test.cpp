// SPDX-License-Identifier: BSD-3-Clause
// The executable with a bag of a room that looks the same after half a turn: landmarks settle which
// end the robot is in.
#include <gmock/gmock.h>
#include <sensor_msgs/LaserScan.h>

#include <nlohmann/json.hpp>

#include "adaptive_localization/map/map_io.hpp"
#include "eval/bag_writer.hpp"
#include "eval/trajectory.hpp"
#include "support/program.hpp"
#include "support/sighted_points.hpp"
#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr int kScans = 60;

class ReplayLandmarks : public testing::Test {
 protected:
  ReplayLandmarks() {
    saveMap(*map_, folder_.file("room"));
    folder_.write("posts.yaml",
                  "landmarks:\n  - {id: 1, at: [5.4, 0.9]}\n"
                  "  - {id: 2, at: [5.4, 2.1]}\n");
  }

  /// To and fro in the lower half of the room or, turned, in the upper one.
  static Pose2 truthAt(int step, bool is_turned) {
    const int phase = step % 40;
    const double x = 2.0 + 0.08 * (phase < 20 ? phase : 40 - phase);
    return is_turned ? Pose2{6.0 - x, 2.2, kPi} : Pose2{x, 0.8, 0.0};
  }

  /// A laser of 181 beams all the way round, and a camera, 20 ms before it, that sights the posts
  /// which are known to it by such ids.
  void write(bool is_turned, const std::vector<int>& ids) const {
    BagWriter bag(folder_.file("drive.bag"));
    const ToyLaser laser{181, -kPi, kPi, 12.0};
    const Pose2 begin = truthAt(0, is_turned);
    for (int i = 0; i < kScans; ++i) {
      const double stamp = 100.0 + 0.2 * i;
      const Pose2 truth = truthAt(i, is_turned);
      bag.odometryTransform(stamp, between(begin, truth));
      bag.pose("/truth", stamp, truth);
      bag.write("/landmarks", stamp, pictureAt(stamp - 0.02, i, is_turned, ids));
      bag.write("/scan", stamp, scanMessage(laser.read(map_, truth), stamp));
    }
  }

  sensor_msgs::PointCloud pictureAt(double stamp, int step, bool is_turned,
                                    const std::vector<int>& ids) const {
    const Pose2 before = truthAt(std::max(step - 1, 0), is_turned);
    const Pose2 T_map_base = interpolate(before, truthAt(step, is_turned), 0.9);
    std::vector<SightedPoint> points;
    for (std::size_t k = 0; k < ids.size(); ++k) {
      const Eigen::Vector2d place = inverse(T_map_base) * posts_[k];
      points.push_back({static_cast<float>(ids[k]), place.cast<float>()});
    }
    return toMessage(stamp, "base_link", points);
  }

  static sensor_msgs::LaserScan scanMessage(const LaserScan& scan, double stamp) {
    sensor_msgs::LaserScan message;
    message.header.stamp = ros::Time(stamp);
    message.header.frame_id = "base_link";
    message.angle_min = static_cast<float>(scan.angle_min);
    message.angle_increment = static_cast<float>(scan.angle_increment);
    message.range_min = static_cast<float>(scan.range_min);
    message.range_max = static_cast<float>(scan.range_max);
    message.ranges = scan.ranges;
    return message;
  }

  /// From anywhere on the map.
  ProgramResult replay(const std::vector<std::string>& settings) const {
    std::vector<std::string> arguments{"--map",         folder_.file("room.yaml"),
                                       "--log",         folder_.file("drive.bag"),
                                       "--truth-topic", "/truth",
                                       "--start",       "global",
                                       "--json",        folder_.file("o.json"),
                                       "--set",         "seed=1"};
    arguments.insert(arguments.end(), settings.begin(), settings.end());
    return runProgram(REPLAY, arguments);
  }

  ProgramResult replayWithLandmarks(std::vector<std::string> more = {}) const {
    more.insert(more.end(),
                {"landmark_topic=landmarks", "landmark_map=" + folder_.file("posts.yaml")});
    return replay(more);
  }

  double number(const std::string& key) const {
    return nlohmann::json::parse(readWhole(folder_.file("o.json"))).at(key).get<double>();
  }

  const std::vector<Eigen::Vector2d> posts_{{5.4, 0.9}, {5.4, 2.1}};
  std::shared_ptr<const OccupancyGrid> map_ = symmetricWorld();
  TempFolder folder_;
};

TEST_F(ReplayLandmarks, TellWhichEndOfASymmetricRoomItIs) {
  for (const bool is_turned : {false, true}) {
    write(is_turned, {1, 2});
    const ProgramResult alone = replay({});
    ASSERT_EQ(alone.exit_code, 0) << alone.errors;
    EXPECT_DOUBLE_EQ(number("tracking_share"), 0.0) << "scans alone cannot know";
    const ProgramResult result = replayWithLandmarks();
    ASSERT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_THAT(result.errors, Not(HasSubstr("warning")));
    EXPECT_THAT(result.errors, Not(HasSubstr("no effect")));
    EXPECT_LT(number("final_error_m"), 0.1);
    EXPECT_LT(number("final_heading_error_deg"), 3.0);
    EXPECT_GT(number("tracking_share"), 0.8);
  }
}

TEST_F(ReplayLandmarks, TellNothingUnderIdsThatNobodyKnows) {
  write(false, {8, 9});
  const ProgramResult result = replayWithLandmarks();
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(result.errors,
              HasSubstr("replay: warning: messages of the landmarks dropped: 59 of 60; the first: "
                        "id of a landmark: got 8, which is not in the map"));
  EXPECT_DOUBLE_EQ(number("tracking_share"), 0.0);
}

TEST_F(ReplayLandmarks, NeedAMapOfThem) {
  write(false, {1, 2});
  const ProgramResult result = replay({"landmark_topic=landmarks"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.errors, HasSubstr("option 'landmark_topic': got 'landmarks' without a "
                                       "landmark_map, expected both"));
  EXPECT_THAT(result.output, IsEmpty());
}

}  // namespace
}  // namespace adaptive_localization
