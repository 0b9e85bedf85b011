// SPDX-License-Identifier: BSD-3-Clause
#include "observation/sonar_model.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <vector>

#include "adaptive_localization/core/rng.hpp"
#include "core/parallel.hpp"
#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kNone = std::numeric_limits<double>::infinity();
constexpr double kView = 0.524;
const Pose2 kTruth{2.5, 2.0, 0.0};

/// A room of 6 m by 4 m with walls in the outermost cells, whose middles are 0.025 m from the edge.
std::shared_ptr<const OccupancyGrid> room() {
  constexpr int kWidth = 120, kHeight = 80;
  std::vector<std::int8_t> cells(kWidth * kHeight, 0);
  for (int row = 0; row < kHeight; ++row) {
    for (int column = 0; column < kWidth; ++column) {
      const bool is_wall = row == 0 || column == 0 || row == kHeight - 1 || column == kWidth - 1;
      if (is_wall) cells[static_cast<std::size_t>(row * kWidth + column)] = 100;
    }
  }
  return std::make_shared<const OccupancyGrid>(Lattice(kWidth, kHeight, 0.05, {}), cells);
}

SonarReading heard(int sonar, double bearing, double range) {
  return {sonar, {0.0, 0.0, bearing}, range, 5.0, kView};
}

/// What is heard from kTruth on four sides: walls at 3.475, 1.975, 2.475 and 1.975 m.
Observations fourSides() {
  Observations observations;
  observations.sonar = {heard(0, 0.0, 3.475), heard(1, kPi / 2, 1.975), heard(2, kPi, 2.475),
                        heard(3, -kPi / 2, 1.975)};
  return observations;
}

Observations only(const SonarReading& reading) {
  Observations observations;
  observations.sonar = {reading};
  return observations;
}

class ASonarModel : public testing::Test {
 protected:
  SonarModel model() const {
    return {options_, room_, std::make_shared<const DistanceField>(*room_)};
  }

  double scoreAt(const Pose2& pose, const Observations& observations) const {
    Particles particles(1);
    particles.setPose(0, pose);
    Eigen::ArrayXd log_likelihood = Eigen::ArrayXd::Zero(1);
    model().score(observations, particles, log_likelihood);
    return log_likelihood[0];
  }

  SonarOptions options_;
  std::shared_ptr<const OccupancyGrid> room_ = room();
};

TEST_F(ASonarModel, IsLikeliestWhereTheEchoesComeFrom) {
  const double best = scoreAt(kTruth, fourSides());
  for (const Pose2& off : {Pose2{0.2, 0.0, 0.0}, Pose2{-0.2, 0.0, 0.0}, Pose2{0.0, 0.2, 0.0}}) {
    EXPECT_LT(scoreAt(kTruth * off, fourSides()), best - 1.0);
  }
}

TEST_F(ASonarModel, HearsTheNearestWallWithinItsConeHoweverTheAxisPoints) {
  const double square = scoreAt(kTruth, only(heard(0, 0.0, 3.475)));
  EXPECT_NEAR(square, std::log(0.25 + 0.75 * 0.9), 0.02);
  EXPECT_NEAR(scoreAt(kTruth * Pose2{0.0, 0.0, 0.2}, only(heard(0, 0.0, 3.475))), square, 0.05);
}

TEST_F(ASonarModel, HearsAWallThatItDoesNotFaceLessWell) {
  const Pose2 oblique{2.5, 0.8, 0.55};  // the wall's foot is 17 degrees beyond the cone's side
  const double edge = 3.475 / std::cos(0.55 - kView / 2.0);
  const double of_oblique = scoreAt(oblique, only(heard(0, 0.0, edge)));
  EXPECT_LT(of_oblique, scoreAt(kTruth, only(heard(0, 0.0, 3.475))) - 0.3);
  EXPECT_GT(of_oblique, std::log(options_.sonar_false_share) + 0.3);
}

TEST_F(ASonarModel, TakesNoEchoForASignThatNoWallIsFacedInReach) {
  const Observations silence = only(heard(0, 0.0, kNone));
  const double facing = scoreAt(kTruth, silence);
  const double oblique = scoreAt(kTruth * Pose2{0.0, 0.0, 0.6}, silence);
  SonarReading short_one = heard(0, 0.0, kNone);
  short_one.max_range = 2.0;
  EXPECT_NEAR(facing, std::log(0.25 + 0.75 * 0.1), 1e-9);
  EXPECT_NEAR(oblique, std::log(0.25 + 0.75 * 0.7), 1e-9);
  EXPECT_NEAR(scoreAt(kTruth, only(short_one)), 0.0, 1e-9);
}

TEST_F(ASonarModel, LosesNoMoreByAFalseReadingThanTheirShareSays) {
  const double least = std::log(options_.sonar_false_share);
  for (const double range : {0.3, 1.0, 4.5}) {
    EXPECT_GE(scoreAt(kTruth, only(heard(0, 0.0, range))), least - 1e-9);
  }
}

TEST_F(ASonarModel, TempersReadingsToTheNumberOfIndependentOnes) {
  Observations many;
  for (int i = 0; i < 16; ++i) many.sonar.push_back(heard(i, 0.0, 3.475));
  options_.effective_sonars = 8.0;
  const double one = scoreAt(kTruth, only(heard(0, 0.0, 3.475)));
  EXPECT_NEAR(scoreAt(kTruth, many), 8.0 * one, 1e-9);
}

TEST_F(ASonarModel, LinearizesWhatTheRangesDo) {
  const Pose2 near{2.52, 1.97, 0.02};
  const auto seen = model().linearized(fourSides(), near);
  ASSERT_THAT(seen, SizeIs(4));
  EXPECT_NEAR(seen[0].innovation[0], 0.02, 0.026);  // a cell's half and a ray's slant
  EXPECT_NEAR(seen[0].H(0, 0), -1.0, 0.02);
  EXPECT_NEAR(seen[1].H(0, 1), -1.0, 0.02);
  EXPECT_NEAR(seen[3].H(0, 1), 1.0, 0.02);
}

TEST_F(ASonarModel, LinearizesAboutASonarThatSitsOffTheMiddle) {
  SonarReading aside = heard(0, 0.0, 3.275);
  aside.T_base_sonar = {0.2, 0.3, 0.0};
  const auto seen = model().linearized(only(aside), kTruth);
  ASSERT_THAT(seen, SizeIs(1));
  EXPECT_NEAR(seen[0].H(0, 2), 0.3, 0.03);  // turning left brings it back from the wall
}

TEST_F(ASonarModel, LinearizesNothingThatDoesNotFit) {
  EXPECT_THAT(model().linearized(only(heard(0, 0.0, 2.0)), kTruth), IsEmpty());
  EXPECT_THAT(model().linearized(only(heard(0, 0.0, kNone)), kTruth), IsEmpty());
}

TEST_F(ASonarModel, LocalizesByFourEchoesAndTellsHowTheyFit) {
  EXPECT_TRUE(model().canLocalize(fourSides()));
  EXPECT_FALSE(model().namesPlaces(fourSides()));
  EXPECT_LT(model().misfit(fourSides(), kTruth).value(), 0.03);
  EXPECT_GT(model().misfit(fourSides(), kTruth * Pose2{0.6, 0.6, 0.0}).value(), 0.1);
  Observations three = fourSides();
  three.sonar[0].range = kNone;
  EXPECT_FALSE(model().canLocalize(three));
  EXPECT_FALSE(model().misfit(three, kTruth).has_value());
}

TEST_F(ASonarModel, DoesNotMindAFewEchoesOfSomethingElse) {
  Observations some = fourSides();
  some.sonar[2].range = 0.4;
  EXPECT_LT(model().misfit(some, kTruth).value(), 0.03);
}

TEST_F(ASonarModel, SaysNothingWithoutReadingsOrOfNonsense) {
  EXPECT_EQ(scoreAt(kTruth, {}), 0.0);
  SonarReading nonsense = heard(0, 0.0, kNan);
  EXPECT_EQ(scoreAt(kTruth, only(nonsense)), 0.0);
  nonsense = heard(0, kNan, 1.0);
  EXPECT_EQ(scoreAt(kTruth, only(nonsense)), 0.0);
  nonsense = heard(0, 0.0, 1.0);
  nonsense.max_range = kNone;
  EXPECT_EQ(scoreAt(kTruth, only(nonsense)), 0.0);
  EXPECT_THAT(model().linearized(only(nonsense), kTruth), IsEmpty());
}

TEST_F(ASonarModel, GivesTheSameBitsForAnyNumberOfThreads) {
  Particles particles(1000);
  Rng rng(4);
  for (Eigen::Index i = 0; i < particles.size(); ++i) {
    particles.setPose(i, {rng.uniform(0.5, 5.5), rng.uniform(0.5, 3.5), rng.uniform(-kPi, kPi)});
  }
  Eigen::ArrayXd one = Eigen::ArrayXd::Zero(1000), many = one;
  setThreads(1);
  model().score(fourSides(), particles, one);
  setThreads(4);
  model().score(fourSides(), particles, many);
  EXPECT_TRUE((one == many).all());
}

}  // namespace
}  // namespace adaptive_localization
