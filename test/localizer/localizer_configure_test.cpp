// SPDX-License-Identifier: BSD-3-Clause
// Options and maps that change while the robot drives.
#include <gmock/gmock.h>

#include <functional>
#include <future>
#include <memory>
#include <stdexcept>

#include "adaptive_localization/localizer/localizer.hpp"
#include "support/pose_matchers.hpp"
#include "support/toy_drive.hpp"
#include "support/toy_parameters.hpp"

namespace adaptive_localization {
namespace {

using testing::AllOf;
using testing::HasSubstr;

Gaussian2 roughly(const Pose2& mean) {
  return {mean, Eigen::Vector3d(0.01, 0.01, 0.005).asDiagonal()};
}

/// A localizer that has tracked the robot over the first steps of a drive.
class DrivingLocalizer : public testing::Test {
 protected:
  DrivingLocalizer() {
    localizer_.reset(roughly(drive_.front().T_map_base));
    for (int i = 0; i < 10; ++i) step();
  }

  Localization step() {
    odometry_ = odometry_ * drive_.at(next_).motion;
    return answer_ = localizer_.update(odometry_, drive_.at(next_++).observations);
  }
  const Pose2& truth() const { return drive_.at(next_ - 1).T_map_base; }

  /// The next steps go on as if nothing had happened.
  void expectToGoOn() {
    for (int i = 0; i < 15; ++i) {
      step();
      ASSERT_THAT(answer_.T_map_base, PoseNear(truth(), 0.15, 0.087)) << "step " << i;
      ASSERT_EQ(answer_.status, Status::kTracking) << "step " << i;
      ASSERT_GT(answer_.confidence, 0.8) << "step " << i;
    }
  }

  std::shared_ptr<const OccupancyGrid> map_ = asymmetricWorld();
  std::vector<ToyStep> drive_ = toyDrive(map_, 6, 61);
  Localizer localizer_{parametersWith(), map_};
  std::size_t next_{0};
  Pose2 odometry_;
  Localization answer_;
};

TEST_F(DrivingLocalizer, KeepsTheBeliefWhenOptionsChange) {
  const Eigen::ArrayXd x = localizer_.hypotheses().x;
  localizer_.configure(parametersWith({{"laser_z_rand", 0.3}, {"max_particles", 300}}));
  EXPECT_TRUE((localizer_.hypotheses().x == x).all());
  expectToGoOn();
  EXPECT_EQ(localizer_.hypotheses().size(), 300);
}

TEST_F(DrivingLocalizer, KeepsTheCorrectionAndTheGate) {
  localizer_.configure(parametersWith({{"laser_sigma_hit", 0.2}}));
  const Localization still = localizer_.update(odometry_, drive_.at(next_ - 1).observations);
  EXPECT_FALSE(still.updated);
  EXPECT_THAT(still.T_map_odom, PoseNear(answer_.T_map_odom, 0.0, 0.0));
  EXPECT_EQ(still.status, Status::kTracking);
  EXPECT_DOUBLE_EQ(still.confidence, answer_.confidence);

  localizer_.configure(parametersWith({{"update_min_d", 0.5}}));
  const Pose2 ahead = odometry_ * Pose2{0.4, 0.0, 0.0};
  EXPECT_FALSE(localizer_.update(ahead, drive_.at(next_).observations).updated);
}

TEST_F(DrivingLocalizer, KeepsTheBeliefFromCoreToCore) {
  for (const std::string core : {"kld", "amcl", "mcl"}) {
    const Eigen::ArrayXd x = localizer_.hypotheses().x;
    localizer_.configure(parametersWith({{"filter", core}}));
    EXPECT_EQ(localizer_.options().filter, core);
    EXPECT_TRUE((localizer_.hypotheses().x == x).all());
    expectToGoOn();
  }
}

TEST_F(DrivingLocalizer, TouchesNothingInTheFilterForOptionsOutsideOfIt) {
  Localizer same(parametersWith(), map_);
  same.reset(roughly(drive_.front().T_map_base));
  Pose2 odometry;
  Localization expected;
  for (std::size_t i = 0; i < 20; ++i) {
    odometry = odometry * drive_[i].motion;
    expected = same.update(odometry, drive_[i].observations);
  }
  localizer_.configure(parametersWith({{"laser_max_beams", 20}, {"converged_std", 0.6}}));
  while (next_ < 20) step();
  EXPECT_THAT(answer_.T_map_base, PoseNear(expected.T_map_base, 0.0, 0.0));
  EXPECT_EQ(localizer_.scanOptions().laser_max_beams, 20);
}

TEST_F(DrivingLocalizer, RefusesWrongOptionsAndGoesOnWithTheOldOnes) {
  const Eigen::ArrayXd x = localizer_.hypotheses().x;
  const Values good{{"max_particles", 600}, {"filter", std::string("kld")}};
  for (const auto& [key, value] : Values{{"laser_sigma_hit", -1.0},
                                         {"filter", std::string("mlc")},
                                         {"min_particles", 700},
                                         {"confidence_low_inliers", 0.9},
                                         {"plugins", std::string("/nowhere.so")}}) {
    Values values = good;
    values[key] = value;
    try {
      localizer_.configure(parametersWith(values));
      FAIL() << key << " was taken";
    } catch (const std::invalid_argument& error) {
      EXPECT_THAT(error.what(),
                  AllOf(HasSubstr(key == "plugins" ? "plug-in" : key), HasSubstr(toText(value))));
    }
    EXPECT_EQ(localizer_.options().filter, "mcl");
  }
  EXPECT_TRUE((localizer_.hypotheses().x == x).all());
  expectToGoOn();
  EXPECT_EQ(localizer_.hypotheses().size(), 1000);
}

TEST_F(DrivingLocalizer, TakesOverACloudAsPrior) {
  Particles cloud(3);
  for (Eigen::Index i = 0; i < 3; ++i) cloud.setPose(i, truth());
  localizer_.reset(cloud);
  EXPECT_THAT(step().T_map_base, PoseNear(truth(), 0.15, 0.087));
  EXPECT_EQ(localizer_.hypotheses().size(), 1000);  // as many as the core wants
  EXPECT_THROW(localizer_.reset(Particles{}), std::invalid_argument);
  cloud.x[1] = std::nan("");
  EXPECT_THROW(localizer_.reset(cloud), std::invalid_argument);
}

TEST_F(DrivingLocalizer, KeepsTheParticlesThatStandOnFreeGroundOfANewMap) {
  const Particles before = localizer_.hypotheses();
  const double split = before.x.mean();
  std::vector<std::int8_t> cells = map_->cells();
  for (std::size_t i = 0; i < cells.size(); ++i) {  // a wall behind the robot's middle
    const Eigen::Vector2d at = map_->lattice().centre(map_->lattice().cell(i));
    if (at.x() < split && at.x() > split - 1.0) cells[i] = OccupancyGrid::kOccupied;
  }
  const auto cut = std::make_shared<const OccupancyGrid>(map_->lattice(), cells);
  localizer_.setMap(cut);
  const Particles after = localizer_.hypotheses();
  EXPECT_GT(after.size(), 100);
  EXPECT_LT(after.size(), before.size());
  for (Eigen::Index i = 0; i < after.size(); ++i) {
    ASSERT_TRUE(cut->isFree(cut->lattice().cellAt({after.x[i], after.y[i]})));
    ASSERT_TRUE((before.x == after.x[i]).any());
  }
  const Localization next = localizer_.update(odometry_, drive_.at(next_ - 1).observations);
  EXPECT_TRUE(next.updated);  // the robot has not moved
  EXPECT_THAT(next.T_map_base, PoseNear(truth(), 0.2, 0.087));
}

TEST_F(DrivingLocalizer, GoesOnAroundItsPoseWhereNoParticleStandsOnFreeGround) {
  std::vector<std::int8_t> cells = map_->cells();
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Eigen::Vector2d at = map_->lattice().centre(map_->lattice().cell(i));
    if (std::hypot(at.x() - truth().x, at.y() - truth().y) < 1.0 && cells[i] == 0) {
      cells[i] = OccupancyGrid::kUnknown;
    }
  }
  localizer_.setMap(std::make_shared<const OccupancyGrid>(map_->lattice(), cells));
  expectToGoOn();
}

TEST_F(DrivingLocalizer, TakesADistanceFieldMadeElsewhere) {
  localizer_.setMap({map_, std::make_shared<const DistanceField>(*map_)});
  expectToGoOn();
}

TEST_F(DrivingLocalizer, TakesAMapThatWasPreparedWhileItDrove) {
  Localizer other(parametersWith(), map_);
  other.reset(roughly(drive_.front().T_map_base));
  Pose2 odometry;
  for (std::size_t i = 0; i < 20; ++i) {
    odometry = odometry * drive_.at(i).motion;
    other.update(odometry, drive_.at(i).observations);
  }
  auto prepared = std::async(std::launch::async, localizer_.preparer(), Ground(map_));
  while (next_ < 20) step();
  localizer_.setMap(*prepared.get());
  other.setMap(map_);
  EXPECT_TRUE((localizer_.hypotheses().x == other.hypotheses().x).all());
  expectToGoOn();
}

TEST_F(DrivingLocalizer, PreparesNoMapThatCannotBeUsed) {
  EXPECT_THROW(localizer_.preparer()(Ground(toyWorld({"##"}, 0.1))), std::invalid_argument);
  expectToGoOn();
}

TEST(LocalizerConfigure, WhatItPreparesOutlivesIt) {
  std::function<std::shared_ptr<PreparedMap>(Ground)> prepare;
  {
    const Localizer gone(parametersWith({{"filter", std::string("mcl")}}), asymmetricWorld());
    prepare = gone.preparer();
  }
  Localizer localizer(parametersWith(), asymmetricWorld());
  localizer.setMap(*prepare(Ground(asymmetricWorld())));
  EXPECT_EQ(localizer.options().filter, "mcl");
}

TEST(LocalizerConfigure, WorksBeforeThereIsABelief) {
  const auto map = asymmetricWorld();
  Localizer localizer(parametersWith(), map);
  localizer.configure(parametersWith({{"filter", std::string("kld")}}));
  localizer.setMap(asymmetricWorld());
  EXPECT_EQ(localizer.hypotheses().size(), 0);
  EXPECT_EQ(localizer.update({}, Observations{}).status, Status::kUninitialised);
}

TEST(LocalizerConfigure, GoesOnGlobalizingWithItsParticlesInANewMap) {
  const auto map = asymmetricWorld();
  Localizer localizer(parametersWith({{"max_particles", 5000}}), map);
  localizer.reset(Anywhere{});
  localizer.setMap(asymmetricWorld());
  EXPECT_EQ(localizer.hypotheses().size(), 5000);
  const auto elsewhere = toyWorld({"..", ".."}, 0.5, {100.0, 100.0, 0.0});
  localizer.setMap(elsewhere);
  const Particles& moved = localizer.hypotheses();
  for (Eigen::Index i = 0; i < moved.size(); ++i) {
    ASSERT_TRUE(elsewhere->isFree(elsewhere->lattice().cellAt({moved.x[i], moved.y[i]})));
  }
}

TEST(LocalizerConfigure, SkipsEmptyNamesOfPlugins) {
  EXPECT_NO_THROW(Localizer(parametersWith({{"plugins", std::string("::")}}), asymmetricWorld()));
}

TEST(LocalizerConfigure, ListsTheNamesOfFiltersAsChoices) {
  const Localizer localizer(parametersWith(), asymmetricWorld());
  for (const auto& row : localizer.allOptions()) {
    const bool is_filter = row.key == "filter";
    EXPECT_EQ(row.choices == builtins().filters.names(), is_filter) << row.key;
  }
  EXPECT_GE(localizer.allOptions().size(), localizer.effectiveOptions().size());
}

}  // namespace
}  // namespace adaptive_localization
