// SPDX-License-Identifier: BSD-3-Clause
// What another sense than the laser tells reaches every core, Recovery and confidence.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <memory>
#include <utility>
#include <vector>

#include "adaptive_localization/localizer/localizer.hpp"
#include "support/pose_matchers.hpp"
#include "support/temp_folder.hpp"
#include "support/toy_parameters.hpp"
#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

/// Half a turn about the middle of symmetricWorld().
Pose2 twinOf(const Pose2& pose) {
  return {6.0 - pose.x, 3.0 - pose.y, wrapAngle(pose.theta + kPi)};
}

class EveryCore : public testing::TestWithParam<std::string> {
 protected:
  /// Drives some steps to and fro, with a compass that is off by so much.
  Localization drive(Localizer& localizer, Pose2& truth, int steps, double compass_error) {
    Localization answer;
    for (int i = 0; i < steps; ++i) {
      const Pose2 motion{i % 24 < 12 ? 0.1 : -0.1, 0.0, 0.0};
      truth = truth * motion;
      odometry_ = odometry_ * motion;
      Observations seen = ToyLaser{91, -kPi / 2, kPi / 2, 12.0}.observe(map_, truth);
      seen.heading = Heading{truth.theta + compass_error, 0.1};
      answer = localizer.update(odometry_, seen);
    }
    return answer;
  }

  std::shared_ptr<const OccupancyGrid> map_ = symmetricWorld();
  Localizer localizer_{parametersWith({{"filter", GetParam()},
                                       {"recovery", true},
                                       {"refine", true},
                                       {"heading_offset_std", 0.0}}),
                       map_};
  Pose2 odometry_;
};

TEST_P(EveryCore, KnowsByACompassWhichEndOfASymmetricRoomItIsIn) {
  for (const bool is_turned : {false, true}) {
    Pose2 truth{2.0, 0.8, 0.0};
    if (is_turned) truth = twinOf(truth);
    localizer_.reset(Anywhere{});
    odometry_ = {};
    const Localization answer = drive(localizer_, truth, 36, 0.05);
    EXPECT_EQ(answer.status, Status::kTracking);
    EXPECT_THAT(answer.T_map_base, PoseNear(truth, 0.1, 0.1));
  }
}

TEST_P(EveryCore, TrustsItsScansMoreThanADisturbedCompass) {
  Pose2 truth{1.7, 0.8, 0.0};
  localizer_.reset(Gaussian2{truth, Eigen::Vector3d(0.01, 0.01, 0.01).asDiagonal()});
  const Localization before = drive(localizer_, truth, 8, 0.0);
  const Localization doubtful = drive(localizer_, truth, 4, 1.5);
  EXPECT_THAT(doubtful.T_map_base, PoseNear(truth, 0.1, 0.1));
  EXPECT_LT(doubtful.confidence, 0.7 * before.confidence);
  const Localization answer = drive(localizer_, truth, 60, 1.5);
  EXPECT_TRUE(localizer_.compass().isDisturbed());
  EXPECT_THAT(answer.T_map_base, PoseNear(truth, 0.1, 0.1));
  EXPECT_EQ(answer.status, Status::kTracking);
  EXPECT_GT(answer.confidence, 0.9 * before.confidence);
}

TEST_P(EveryCore, KeepsItsPlaceWhereACompassPointsToTheTwin) {
  Pose2 truth{2.0, 0.8, 0.0};
  localizer_.reset(Gaussian2{truth, Eigen::Vector3d(0.01, 0.01, 0.01).asDiagonal()});
  drive(localizer_, truth, 20, 0.0);
  const Localization answer = drive(localizer_, truth, 60, kPi);
  EXPECT_THAT(answer.T_map_base, PoseNear(truth, 0.1, 0.1));
}

TEST_P(EveryCore, LearnsHowACompassPointsAndIsFoundByItAfterAKidnap) {
  const auto parameters =
      parametersWith({{"filter", GetParam()}, {"recovery", true}, {"refine", true}});
  Localizer localizer(parameters, map_);
  Pose2 truth{2.0, 0.8, 0.0};
  localizer.reset(Gaussian2{truth, Eigen::Vector3d(0.01, 0.01, 0.01).asDiagonal()});
  drive(localizer, truth, 48, 2.0);
  EXPECT_NEAR(localizer.compass().offset(), -2.0, 0.1);
  truth = Pose2{3.4, 0.9, kPi / 2};
  const Localization answer = drive(localizer, truth, 48, 2.0);
  EXPECT_EQ(answer.status, Status::kTracking);
  EXPECT_THAT(answer.T_map_base, PoseNear(truth, 0.1, 0.1));
}

/// Three posts, of which two look the same, and a robot that sights them and has no laser.
class EveryCoreWithoutALaser : public EveryCore {
 protected:
  EveryCoreWithoutALaser() {
    std::ofstream(file_) << "landmarks:\n  - {id: 0, at: [5.4, 0.6]}\n  - {id: 0, at: [0.6, 2.4]}\n"
                            "  - {id: 1, at: [5.4, 2.4]}\n";
    localizer_ = std::make_unique<Localizer>(parametersWith({{"filter", GetParam()},
                                                             {"recovery", true},
                                                             {"refine", true},
                                                             {"landmark_map", file_}}),
                                             map_);
  }

  /// One post after the other, or all of them at once.
  Localization sight(Pose2& truth, int steps, bool is_one_at_a_time = false) {
    constexpr int kEach = 10;  // sightings
    Localization answer;
    for (int i = 0; i < steps; ++i) {
      const Pose2 motion{0.05, 0.0, 0.1};
      truth = truth * motion;
      odometry_ = odometry_ * motion;
      Observations seen;
      seen.stamp = 0.1 * ++scans_;
      seen.landmarks.emplace();
      for (std::size_t k = 0; k < posts_.size(); ++k) {
        if (is_one_at_a_time && scans_ / kEach % posts_.size() != k) continue;
        const auto& [id, place] = posts_[k];
        const Eigen::Vector2d point = inverse(truth) * place;
        seen.landmarks->push_back({id, point.norm(), std::atan2(point.y(), point.x()), 0.1, 0.05});
      }
      answer = localizer_->update(odometry_, seen);
    }
    return answer;
  }

  const std::vector<std::pair<int, Eigen::Vector2d>> posts_{
      {0, {5.4, 0.6}}, {0, {0.6, 2.4}}, {1, {5.4, 2.4}}};
  TempFolder folder_;
  std::string file_ = folder_.file("posts.yaml");
  std::unique_ptr<Localizer> localizer_;
  int scans_{0};
};

TEST_P(EveryCoreWithoutALaser, IsFoundByLandmarks) {
  Pose2 truth{3.0, 1.2, 0.5};
  localizer_->reset(Anywhere{});
  const Localization answer = sight(truth, 40);
  EXPECT_EQ(answer.status, Status::kTracking);
  EXPECT_THAT(answer.T_map_base, PoseNear(truth, 0.15, 0.1));
  EXPECT_GT(answer.confidence, 0.5);
}

TEST_P(EveryCoreWithoutALaser, IsFoundAgainAfterAKidnap) {
  Pose2 truth{3.0, 1.2, 0.5};
  localizer_->reset(Gaussian2{truth, Eigen::Vector3d(0.01, 0.01, 0.01).asDiagonal()});
  Localization answer = sight(truth, 20);
  EXPECT_EQ(answer.status, Status::kTracking);
  EXPECT_THAT(answer.T_map_base, PoseNear(truth, 0.15, 0.1));
  truth = {3.4, 1.8, -2.0};
  answer = sight(truth, 60);
  EXPECT_EQ(answer.status, Status::kTracking);
  EXPECT_THAT(answer.T_map_base, PoseNear(truth, 0.15, 0.1));
}

/// One sighting names no place, but the one that was told explains it.
TEST_P(EveryCoreWithoutALaser, TracksFromATruePoseThoughItSightsOnePostAtATime) {
  Pose2 truth{3.0, 1.2, 0.5};
  localizer_->reset(Gaussian2{truth, Eigen::Vector3d(0.01, 0.01, 0.01).asDiagonal()});
  int tracking = 0;
  constexpr int kSightings = 60;
  for (int i = 0; i < kSightings; ++i) {
    const Localization answer = sight(truth, 1, true);
    tracking += answer.status == Status::kTracking ? 1 : 0;
    EXPECT_NE(answer.status, Status::kLost) << i;
    EXPECT_THAT(answer.T_map_base, PoseNear(truth, 0.3, 0.15)) << i;
  }
  EXPECT_GT(tracking, kSightings / 2);
}

INSTANTIATE_TEST_SUITE_P(Cores, EveryCoreWithoutALaser,
                         testing::ValuesIn(builtins().filters.names()));
INSTANTIATE_TEST_SUITE_P(Cores, EveryCore, testing::ValuesIn(builtins().filters.names()));

}  // namespace
}  // namespace adaptive_localization
