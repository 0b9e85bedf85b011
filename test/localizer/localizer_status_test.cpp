// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "adaptive_localization/localizer/localizer.hpp"
#include "ser/places.hpp"
#include "support/pose_matchers.hpp"
#include "support/toy_drive.hpp"
#include "support/toy_parameters.hpp"

namespace adaptive_localization {
namespace {

TEST(LocalizerStatus, IsUninitialisedUntilReset) {
  Localizer localizer(parametersWith(), asymmetricWorld());
  const auto seen = ToyLaser{}.observe(asymmetricWorld(), {1.0, 1.0, 0.0});
  const Localization answer = localizer.update({}, seen);
  EXPECT_EQ(answer.status, Status::kUninitialised);
  EXPECT_FALSE(answer.updated);
  EXPECT_EQ(localizer.hypotheses().size(), 0);
}

TEST(LocalizerStatus, TellsTheStoryOfAGlobalLocalizationAndAKidnapping) {
  const auto map = asymmetricWorld();
  Localizer localizer(parametersWith({{"max_particles", 10000}, {"laser_sigma_hit", 0.2}}), map);
  localizer.reset(Anywhere{});
  const auto drive = toyDrive(map, 5, 61);
  Pose2 odometry;
  Localization answer = localizer.update(odometry, drive[0].observations);
  EXPECT_EQ(answer.status, Status::kGlobalizing);
  EXPECT_LT(answer.confidence, 0.5);
  for (std::size_t i = 1; i < 45; ++i) {
    odometry = odometry * drive[i].motion;
    answer = localizer.update(odometry, drive[i].observations);
  }
  EXPECT_EQ(answer.status, Status::kTracking);
  EXPECT_GT(answer.confidence, 0.8);
  EXPECT_THAT(answer.T_map_base, PoseNear(drive[44].T_map_base, 0.15, 0.1));

  // carried away to where obstacles stand as nowhere on the map
  std::vector<Eigen::Vector2d> star;
  for (int i = 0; i < 60; ++i) {
    const double range = i % 2 ? 0.8 : 3.0;
    star.emplace_back(range * std::cos(0.1 * i), range * std::sin(0.1 * i));
  }
  const Observations contradiction = hitsAt(star, 12.0);
  for (int i = 0; i < 20; ++i) {
    odometry = odometry * Pose2{0.2, 0.0, 0.0};
    answer = localizer.update(odometry, contradiction);
  }
  EXPECT_EQ(answer.status, Status::kLost);
  EXPECT_LT(answer.confidence, 0.2);
}

TEST(LocalizerStatus, DoesNotBelieveAWrongInitialPose) {
  const auto map = asymmetricWorld();
  const auto drive = toyDrive(map, 5, 61);
  for (const char* filter : {"kld", "sa_kld", "ekf_icp"}) {
    Localizer localizer(parametersWith({{"filter", std::string(filter)}}), map);
    localizer.reset(Gaussian2{{6.5, 1.5, 1.0}, Eigen::Vector3d(0.25, 0.25, 0.07).asDiagonal()});
    Pose2 odometry;
    for (std::size_t i = 0; i < 10; ++i) {
      if (i > 0) odometry = odometry * drive[i].motion;
      const Localization answer = localizer.update(odometry, drive[i].observations);
      const bool is_right = distance(answer.T_map_base, drive[i].T_map_base) < 0.5;
      ASSERT_TRUE(is_right || answer.status != Status::kTracking) << filter << ", scan " << i;
    }
  }
}

/// While the energy grid is being made nobody knows of other places.
TEST(LocalizerStatus, DoesNotSayTrackingBeforeAScanWasAskedAboutAnInitialPose) {
  const auto map = asymmetricWorld();
  const auto field = std::make_shared<const DistanceField>(*map);
  const Pose2 place{1.0, 1.0, 0.3};
  const auto seen = ToyLaser{}.observe(map, place);
  for (const char* filter : {"mcl", "kld", "sa_kld", "ekf_icp"}) {
    const auto places = std::make_shared<Places>(
        map, field, EnergyGridOptions{}, GlobalSearchOptions{}, Places::Build::kInBackground);
    Localizer localizer(parametersWith({{"filter", std::string(filter)}}),
                        Ground(map, field, places));
    localizer.reset(Gaussian2{place, Eigen::Vector3d(0.01, 0.01, 0.01).asDiagonal()});
    bool was_ready = false;
    Localization answer;
    for (; !was_ready; was_ready = places->isReadyFor(seen.scan)) {
      answer = localizer.update({}, seen);
      const bool could_tell = places->isReadyFor(seen.scan);
      ASSERT_TRUE(could_tell || answer.status == Status::kGlobalizing) << filter;
    }
    // The robot stands still, and yet it is asked as soon as there is an answer; once.
    answer = localizer.update({}, seen);
    EXPECT_EQ(answer.status, Status::kTracking) << filter;
    EXPECT_FALSE(answer.updated) << filter;
  }
}

/// An initial pose is to be checked again and again on the way. Where there is no grid yet for
/// another laser, that can wait.
TEST(LocalizerStatus, IsTrackingWhileTheGridOfAnotherLaserIsBeingMade) {
  const auto map = toyWorld({"####################",  //
                             "#........#.........#",  //
                             "#........#...####..#",  //
                             "#...##......########",  //
                             "#..................#",  //
                             "####################"},
                            0.02, {}, 40);
  const auto field = std::make_shared<const DistanceField>(*map);
  const auto places = std::make_shared<Places>(map, field, EnergyGridOptions{},
                                               GlobalSearchOptions{}, Places::Build::kInBackground);
  Localizer localizer(parametersWith({{"filter", std::string("ekf_icp")}}),
                      Ground(map, field, places));
  const Pose2 start{2.0, 1.2, 0.5 * kPi};
  localizer.reset(Gaussian2{start, Eigen::Vector3d(0.01, 0.01, 0.01).asDiagonal()});
  Pose2 odometry;
  const auto update = [&](const ToyLaser& laser) {
    odometry = odometry * Pose2{0.0, 0.0, 0.2};
    return localizer.update(odometry, laser.observe(map, start * odometry));
  };
  const ToyLaser first{91, -2.0, 2.0, 12.0}, second{121, -2.5, 2.5, 5.0};
  const auto isReady = [&](const ToyLaser& laser) {
    return places->energyGrid(laser.observe(map, start).scan) != nullptr;
  };
  while (!isReady(first)) update(first);
  int asked = 0;  // the pose is checked; how soon scans tell it from others, the heading decides
  while (update(first).status != Status::kTracking) ASSERT_LT(++asked, 40);
  int waited = 0;
  for (; !isReady(second); ++waited) ASSERT_EQ(update(second).status, Status::kTracking) << waited;
  EXPECT_GT(waited, 5) << "updates, of a radian in all";
  for (int i = 0; i < 20; ++i) ASSERT_EQ(update(second).status, Status::kTracking) << i;
}

/// After each scan of the laser that sees, one of another that is covered, as by what the robot
/// carries.
TEST(LocalizerStatus, IsTrackingWhileOneOfTwoLasersIsCovered) {
  const auto map = asymmetricWorld();
  const auto drive = toyDrive(map, 5, 61);
  std::vector<Eigen::Vector2d> cover;
  for (int i = 0; i < 60; ++i)
    cover.emplace_back(-0.3 * std::cos(0.02 * i), 0.3 * std::sin(0.02 * i));
  for (const char* filter : {"kld", "sa_kld", "ekf_icp"}) {
    Localizer localizer(parametersWith({{"filter", std::string(filter)}}), map);
    localizer.reset(Gaussian2{drive[0].T_map_base, 0.01 * Eigen::Matrix3d::Identity()});
    Pose2 odometry;
    for (std::size_t i = 0; i < 40; ++i) {
      odometry = odometry * drive[i].motion;
      EXPECT_EQ(localizer.update(odometry, drive[i].observations).status, Status::kTracking)
          << filter << ", scan " << i;
      localizer.update(odometry, hitsAt(cover, 12.0));
    }
    for (int i = 0; i < 10; ++i) {  // nor is what it sees counted over and over while it stands
      EXPECT_FALSE(localizer.update(odometry, drive[39].observations).updated) << filter;
      EXPECT_FALSE(localizer.update(odometry, hitsAt(cover, 12.0)).updated) << filter;
    }
  }
}

/// Where the robot is when it is told, no scan can tell more.
TEST(LocalizerStatus, KeepsAnInitialPoseThatOneOfTwoTwinsFits) {
  const auto map = symmetricWorld();
  Localizer localizer(parametersWith({{"filter", std::string("ekf_icp")}}), map);
  const Pose2 place{1.0, 1.0, 0.3};
  localizer.reset(Gaussian2{place, Eigen::Vector3d(0.01, 0.01, 0.01).asDiagonal()});
  const auto seen = ToyLaser{}.observe(map, place);
  Localization answer;
  for (int i = 0; i < 5; ++i) answer = localizer.update({}, seen);
  EXPECT_EQ(answer.status, Status::kTracking);
  EXPECT_THAT(answer.T_map_base, PoseNear(place, 0.05, 0.05));
  ASSERT_EQ(answer.modes.size(), 2U);
  EXPECT_GT(answer.modes.front().mass, 0.99);
}

TEST(LocalizerStatus, IsAmbiguousWhereTwoPlacesLookAlike) {
  const auto map = symmetricWorld();
  // chance decides how heavy a place gets, so one of a twentieth counts
  const Values values{{"max_particles", 10000}, {"laser_sigma_hit", 0.2}, {"ambiguous_mass", 0.05}};
  Localizer localizer(parametersWith(values), map);
  localizer.reset(Anywhere{});
  const ToyLaser laser{61, -2.0, 2.0, 12.0};
  Pose2 odometry;
  const Pose2 start{2.3, 1.0, 0.0};
  Localization answer;
  int ambiguous = 0;
  for (int i = 0; i < 12; ++i) {
    answer = localizer.update(odometry, laser.observe(map, start * odometry));
    ambiguous += answer.status == Status::kAmbiguous ? 1 : 0;
    EXPECT_NE(answer.status, Status::kTracking) << i;
    odometry = odometry * Pose2{i % 2 ? -0.21 : 0.21, 0.0, 0.0};
  }
  EXPECT_GE(ambiguous, 6);
  EXPECT_LT(answer.confidence, 0.9);
}

TEST(LocalizerStatus, HasAWordForEach) {
  EXPECT_EQ(toText(Status::kUninitialised), "uninitialised");
  EXPECT_EQ(toText(Status::kGlobalizing), "globalizing");
  EXPECT_EQ(toText(Status::kTracking), "tracking");
  EXPECT_EQ(toText(Status::kAmbiguous), "ambiguous");
  EXPECT_EQ(toText(Status::kLost), "lost");
}

}  // namespace
}  // namespace adaptive_localization
