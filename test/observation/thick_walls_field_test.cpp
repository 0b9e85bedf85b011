// SPDX-License-Identifier: BSD-3-Clause
// A robot in a room whose map has thick walls: its laser sees the faces of painted walls, and what
// is in the middles of walls that were made of scans laid over each other inexactly.
#include <gtest/gtest.h>

#include "observation/likelihood_field.hpp"
#include "support/thick_room.hpp"
#include "support/toy_scores.hpp"

namespace adaptive_localization {
namespace {

constexpr int kDeep = 7;                       // cells
constexpr Pose2 kAside[] = {{0.07, 0.0, 0.0},  // m: less than the walls are deep
                            {-0.07, 0.0, 0.0},
                            {0.0, 0.07, 0.0},
                            {0.0, -0.07, 0.0}};

ToyModelOptions fieldOptions(double sigma_hit = 0.0) {
  ToyModelOptions options = modelOptions("likelihood_field");
  options.laser_sigma_hit = sigma_hit;
  return options;
}

Pose2 poseAfter(int scans) {
  return Pose2{1.5, 1.5, 0.3} * Pose2{0.0, 0.0, 0.4 * scans} * Pose2{0.2, 0.0, 0.0};
}

/// By how much the true pose beats the best of those aside, after so many scans of the world.
double leadOfTruth(const ToyModelOptions& options, const Map& map, const Map& world, int scans) {
  const auto model = makeModel(options, map);
  Eigen::ArrayXd scores;
  for (int i = 0; i < scans; ++i) {
    const Pose2 truth = poseAfter(i);
    Particles particles(5);
    particles.setPose(0, truth);
    for (int k = 0; k < 4; ++k) {
      const Pose2& aside = kAside[k];
      particles.setPose(k + 1, {truth.x + aside.x, truth.y + aside.y, truth.theta});
    }
    scores = Eigen::ArrayXd::Zero(5);
    model->score(ToyLaser{181, -kPi / 2, kPi / 2, 12.0}.observe(world, truth), particles, scores);
  }
  return scores[0] - scores.tail(4).maxCoeff();
}

TEST(ThickWallsField, TellsWhereBetweenThickWallsOnceItKnowsWhatTheLaserSees) {
  const auto map = roomWithWalls(0, kDeep);
  const auto middles = roomWithWalls(kDeep / 2, kDeep / 2 + 1), faces = roomWithWalls(0, 1);
  EXPECT_LT(leadOfTruth(fieldOptions(), map, middles, 1), 0.1) << "whole walls cannot tell";
  EXPECT_GT(leadOfTruth(fieldOptions(), map, middles, 10), 3.0);
  EXPECT_GT(leadOfTruth(fieldOptions(), map, faces, 10), 1.5);
}

TEST(ThickWallsField, RockHasNoMiddles) {
  EXPECT_GT(leadOfTruth(fieldOptions(), roomWithWalls(0, 60), roomWithWalls(0, 1), 10), 1.5);
}

TEST(ThickWallsField, MeasuresWithTheDeviationThatIsGiven) {
  const auto map = roomWithWalls(0, kDeep), middles = roomWithWalls(kDeep / 2, kDeep / 2 + 1);
  const double sharp = leadOfTruth(fieldOptions(0.05), map, middles, 10);
  const double blunt = leadOfTruth(fieldOptions(0.2), map, middles, 10);
  EXPECT_GT(sharp, 3.0 * blunt);
}

TEST(ThickWallsField, ScoresByWholeWallsUntilItIsTold) {
  const auto map = roomWithWalls(0, kDeep);
  const LikelihoodField walls(fieldOptions(), LikelihoodField::Form::kTempered,
                              std::make_shared<const DistanceField>(*map));
  const auto model = makeModel(fieldOptions(), map);
  Particles particles(1);
  particles.setPose(0, poseAfter(0));
  const ToyLaser few{9, -kPi / 2, kPi / 2, 12.0};  // beams, too few to tell
  for (int i = 0; i < 30; ++i) {
    const Observations seen = few.observe(roomWithWalls(3, 4), poseAfter(0));
    Eigen::ArrayXd by_model = Eigen::ArrayXd::Zero(1), by_walls = by_model;
    EXPECT_EQ(model->score(seen, particles, by_model), walls.score(seen, particles, by_walls));
    EXPECT_EQ(by_model[0], by_walls[0]) << i;
  }
}

TEST(ThickWallsField, ScoresScansWithoutHitsAndCloudsWithoutParticles) {
  const auto model = makeModel(fieldOptions(), roomWithWalls(0, kDeep));
  Particles particles(1);
  particles.setPose(0, poseAfter(0));
  Eigen::ArrayXd score = Eigen::ArrayXd::Zero(1), none(0);
  EXPECT_EQ(model->score(hitsAt({}, 12.0), particles, score), 0.0);
  EXPECT_EQ(score[0], 0.0);
  const Observations seen = ToyLaser{}.observe(roomWithWalls(3, 4), poseAfter(0));
  EXPECT_NO_THROW(model->score(seen, Particles(0), none));
}

}  // namespace
}  // namespace adaptive_localization
