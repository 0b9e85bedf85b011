// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/localizer.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "support/pose_matchers.hpp"
#include "support/toy_drive.hpp"

namespace adaptive_localization {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

using Values = std::map<std::string, OptionValue>;

Parameters parametersWith(const Values& more = {}) {
  Parameters parameters;
  const Values values{{"filter", std::string("mcl")}, {"max_particles", 1000},
                      {"update_min_d", 0.2},          {"update_min_a", 0.2},
                      {"laser_sigma_hit", 0.1},       {"effective_beams", 12.0}};
  for (const auto& [key, value] : values) parameters.set(key, value);
  for (const auto& [key, value] : more) parameters.set(key, value);
  return parameters;
}

std::string complaint(const Parameters& parameters,
                      const std::shared_ptr<const OccupancyGrid>& map = asymmetricWorld()) {
  try {
    Localizer(parameters, map);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no complaint";
}

Gaussian2 roughly(const Pose2& mean) {
  return {mean, Eigen::Vector3d(0.01, 0.01, 0.005).asDiagonal()};
}

OptionValue effective(const Localizer& localizer, const std::string& key) {
  const auto rows = localizer.effectiveOptions();
  const auto row =
      std::find_if(rows.begin(), rows.end(), [&](const auto& r) { return r.key == key; });
  return row == rows.end() ? OptionValue{std::string("none")} : row->value;
}

class TrackingLocalizer : public testing::Test {
 protected:
  TrackingLocalizer() : localizer_(parametersWith(), map_) { localizer_.reset(roughly(start_)); }

  /// The answer for a robot that is where odometry says, up to the frame.
  Localization at(const Pose2& T_odom_base) {
    return localizer_.update(T_odom_base, laser_.observe(map_, start_ * T_odom_base));
  }

  std::shared_ptr<const OccupancyGrid> map_ = asymmetricWorld();
  ToyLaser laser_{61, -2.0, 2.0, 12.0};
  Pose2 start_{1.0, 1.0, 0.0};
  Localizer localizer_;
};

TEST_F(TrackingLocalizer, UpdatesAtOnceAndThenByDistance) {
  EXPECT_TRUE(at({}).updated);
  EXPECT_FALSE(at({0.1, 0.0, 0.0}).updated);
  EXPECT_FALSE(at({0.19, 0.0, 0.0}).updated);
  EXPECT_TRUE(at({0.21, 0.0, 0.0}).updated);
  EXPECT_FALSE(at({0.40, 0.0, 0.0}).updated);  // counted from the last update
  EXPECT_TRUE(at({0.42, 0.0, 0.0}).updated);
}

TEST_F(TrackingLocalizer, UpdatesByAngleTheShortWayRound) {
  at({0.0, 0.0, kPi - 0.05});
  EXPECT_FALSE(at({0.0, 0.0, -kPi + 0.05}).updated);
  EXPECT_TRUE(at({0.0, 0.0, -kPi + 0.2}).updated);
}

TEST_F(TrackingLocalizer, UpdatesOnRequestOnce) {
  at({});
  localizer_.requestUpdate();
  EXPECT_TRUE(at({}).updated);
  EXPECT_FALSE(at({}).updated);
}

TEST_F(TrackingLocalizer, KeepsTheCorrectionBetweenUpdates) {
  const Localization first = at({});
  const Localization between = at({0.1, 0.05, 0.1});
  EXPECT_THAT(between.T_map_odom, PoseNear(first.T_map_odom, 0.0, 0.0));
  EXPECT_THAT(between.T_map_base, PoseNear(first.T_map_odom * Pose2{0.1, 0.05, 0.1}, 1e-9, 1e-9));
  EXPECT_THAT(between.T_map_base, PoseNear(start_ * Pose2{0.1, 0.05, 0.1}, 0.1, 0.05));
}

TEST_F(TrackingLocalizer, CorrectsOdometryWhateverItsFrame) {
  const Pose2 T_odom_start{-30.0, 12.0, 2.0};
  const Localization answer = localizer_.update(T_odom_start, laser_.observe(map_, start_));
  EXPECT_THAT(answer.T_map_base, PoseNear(start_, 0.1, 0.05));
  EXPECT_THAT(answer.T_map_odom * T_odom_start, PoseNear(answer.T_map_base, 1e-9, 1e-9));
}

TEST_F(TrackingLocalizer, IgnoresOdometryThatIsNoNumber) {
  const Localization before = at({});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Localization bad = localizer_.update({nan, 0.0, 0.0}, laser_.observe(map_, start_));
  EXPECT_FALSE(bad.updated);
  EXPECT_THAT(bad.T_map_odom, PoseNear(before.T_map_odom, 0.0, 0.0));
  EXPECT_TRUE(at({0.3, 0.0, 0.0}).updated);
}

TEST_F(TrackingLocalizer, RefusesAnInitialPoseThatIsNoNumber) {
  Gaussian2 prior = roughly(start_);
  prior.mean.x = std::nan("");
  EXPECT_THROW(localizer_.reset(prior), std::invalid_argument);
  prior = roughly(start_);
  prior.covariance(1, 1) = std::numeric_limits<double>::infinity();
  EXPECT_THROW(localizer_.reset(prior), std::invalid_argument);
  EXPECT_EQ(at({}).status, Status::kTracking);
}

TEST_F(TrackingLocalizer, StartsAnewOnReset) {
  at({});
  localizer_.reset(roughly({3.0, 1.0, 0.0}));
  const Localization moved = localizer_.update({}, laser_.observe(map_, {3.0, 1.0, 0.0}));
  EXPECT_TRUE(moved.updated);
  EXPECT_THAT(moved.T_map_base, PoseNear(Pose2{3.0, 1.0, 0.0}, 0.1, 0.05));
}

TEST_F(TrackingLocalizer, GoesOnInANewMap) {
  at({});
  const Pose2 here = at({0.3, 0.0, 0.0}).T_map_base;
  localizer_.setMap(asymmetricWorld());
  const Localization after = at({0.3, 0.0, 0.0});
  EXPECT_TRUE(after.updated);
  EXPECT_THAT(after.T_map_base, PoseNear(here, 0.1, 0.05));
  EXPECT_EQ(after.status, Status::kTracking);
}

TEST_F(TrackingLocalizer, KeepsItsMapIfTheNewOneIsUseless) {
  at({});
  EXPECT_THROW(localizer_.setMap(toyWorld({"##"}, 0.1)), std::invalid_argument);
  const Localization after = at({0.3, 0.0, 0.0});
  EXPECT_THAT(after.T_map_base, PoseNear(start_ * Pose2{0.3, 0.0, 0.0}, 0.1, 0.05));
  EXPECT_EQ(after.status, Status::kTracking);
}

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

TEST(LocalizerOptions, AreRefusedByName) {
  EXPECT_THAT(complaint(parametersWith({{"filter", std::string("mlc")}})),
              AllOf(HasSubstr("'mlc'"), HasSubstr("amcl"), HasSubstr("mcl")));
  EXPECT_THAT(complaint(parametersWith({{"preset", std::string("best")}})),
              AllOf(HasSubstr("preset"), HasSubstr("recommended, seed")));
  EXPECT_THAT(complaint(parametersWith({{"odom_alpha1", -1.0}})), HasSubstr("'odom_alpha1'"));
  EXPECT_THAT(complaint(parametersWith({{"seed", -1}})), HasSubstr("'seed'"));
  EXPECT_THAT(complaint(parametersWith(), toyWorld({"#?#"}, 0.1)), HasSubstr("no free cell"));
  EXPECT_THAT(complaint(parametersWith({{"filter", std::string("kld")}, {"min_particles", 2000}})),
              HasSubstr("min_particles"));
}

TEST(LocalizerOptions, ThatNobodyKnowsAreListed) {
  const Localizer localizer(parametersWith({{"odom_alpha_1", 0.1}, {"recovery_alpha_slow", 0.1}}),
                            asymmetricWorld());
  EXPECT_THAT(localizer.unknownKeys(), ElementsAre("odom_alpha_1"));
}

TEST(LocalizerOptions, ComeFromThePresetUnlessGiven) {
  Parameters parameters;
  parameters.set("filter", OptionValue{std::string("mcl")});
  parameters.set("preset", OptionValue{std::string("seed")});
  parameters.set("odom_noise_theta", OptionValue{0.5});
  const Localizer localizer(parameters, asymmetricWorld());
  const auto seed = FilterRegistry().find("mcl").seed;
  for (const auto& [key, value] : seed) {
    if (key == "odom_noise_theta") continue;
    EXPECT_EQ(effective(localizer, key), value) << key;
  }
  ASSERT_EQ(seed.count("odom_noise_theta"), 1u);
  EXPECT_EQ(effective(localizer, "odom_noise_theta"), OptionValue{0.5});
  EXPECT_EQ(OptionValue{localizer.options().update_min_d}, seed.at("update_min_d"));
  EXPECT_EQ(OptionValue{localizer.scanOptions().laser_max_beams}, seed.at("laser_max_beams"));
}

}  // namespace
}  // namespace adaptive_localization
