// SPDX-License-Identifier: BSD-3-Clause
#include "swarm/swarm.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "adaptive_localization/core/pose2.hpp"
#include "bench/test_functions.hpp"
#include "swarm/swarm_search.hpp"

namespace adaptive_localization {
namespace {

SearchSpace square(bool is_torus) {
  SearchSpace space;
  space.low = Eigen::ArrayXd::Constant(2, -1.0);
  space.high = Eigen::ArrayXd::Constant(2, 3.0);
  space.is_torus = is_torus;
  return space;
}

}  // namespace

TEST(SearchSpace, ATorusTakesTheShortWayAndComesBackOnTheOtherSide) {
  const SearchSpace torus = square(true);
  EXPECT_DOUBLE_EQ(torus.way(0, -0.5, 2.5), -1.0);
  EXPECT_DOUBLE_EQ(torus.way(0, 2.5, -0.5), 1.0);
  EXPECT_DOUBLE_EQ(torus.way(0, 0.0, 1.0), 1.0);
  EXPECT_DOUBLE_EQ(torus.inside(0, 3.5), -0.5);
  EXPECT_DOUBLE_EQ(torus.inside(0, -1.5), 2.5);
  EXPECT_DOUBLE_EQ(torus.inside(0, 3.5 + 40.0), -0.5);
}

TEST(SearchSpace, AnythingElseEndsAtItsEnds) {
  const SearchSpace space = square(false);
  EXPECT_DOUBLE_EQ(space.way(0, -0.5, 2.5), 3.0);
  EXPECT_DOUBLE_EQ(space.inside(0, 3.5), 3.0);
  EXPECT_DOUBLE_EQ(space.inside(0, -7.0), -1.0);
}

TEST(SearchSpace, HeadingsWrapWhateverTheOthersDo) {
  SearchSpace space;
  space.low = Eigen::Array3d(0.0, 0.0, -kPi);
  space.high = Eigen::Array3d(10.0, 5.0, kPi);
  space.has_heading = true;
  EXPECT_NEAR(space.way(2, 3.0, -3.0), 2.0 * kPi - 6.0, 1e-12);
  EXPECT_NEAR(space.inside(2, kPi + 0.1), -kPi + 0.1, 1e-12);
  EXPECT_DOUBLE_EQ(space.way(0, 9.0, 1.0), -8.0);
  space.low[2] = 3.0;  // a narrow range of headings, beyond pi
  space.high[2] = 3.4;
  EXPECT_DOUBLE_EQ(space.inside(2, 3.3), 3.3);
  EXPECT_DOUBLE_EQ(space.inside(2, 3.5), 3.4);
}

TEST(SearchSpace, AHeadingComesBackAfterAWholeTurnHoweverWideTheSpaceIs) {
  SearchSpace space;
  space.low = Eigen::Array3d(0.0, 0.0, -2.0 * kPi);
  space.high = Eigen::Array3d(10.0, 5.0, 2.0 * kPi);
  space.has_heading = true;
  EXPECT_NEAR(space.way(2, -2.0 * kPi + 0.1, 2.0 * kPi - 0.1), -0.2, 1e-12);
  EXPECT_NEAR(space.way(2, 0.1, 2.0 * kPi - 0.1), -0.2, 1e-12);
  EXPECT_NEAR(wrapAngle(space.inside(2, 2.0 * kPi + 0.3)), 0.3, 1e-12);
}

TEST(TestFunctions, AreZeroAtTheOriginAndNowhereLess) {
  for (const TestFunction& function : testFunctions()) {
    EXPECT_NEAR(function(0.0, 0.0), 0.0, 1e-12) << function.name();
    Rng rng(1);
    const auto positions = spreadOver(function.space(), 2000, rng);
    for (Eigen::Index i = 0; i < positions.rows(); ++i) {
      ASSERT_GT(function(positions(i, 0), positions(i, 1)), 0.0) << function.name();
    }
  }
  EXPECT_NEAR(rastrigin()(1.0, 0.0), 1.0, 1e-12);
  EXPECT_NEAR(eggcrate()(0.5 * kPi, 0.0), 0.25 * kPi * kPi + 25.0, 1e-12);
  EXPECT_NEAR(ackley()(1.0, 1.0), 20.0 - 20.0 * std::exp(-0.2), 1e-12);
}

TEST(TestFunctions, TurnedOnesAreTheSameAboutAnotherPlace) {
  const TestFunction plain = rastrigin();
  const TestFunction turned = plain.turned(kPi / 6.0, {1.5, -1.0});
  EXPECT_EQ(turned.name(), "Rastrigin turned");
  EXPECT_NEAR(turned(1.5, -1.0), 0.0, 1e-12);
  const double c = std::cos(kPi / 6.0), s = std::sin(kPi / 6.0);
  EXPECT_NEAR(turned(1.5 + c * 0.7 - s * 0.2, -1.0 + s * 0.7 + c * 0.2), plain(0.7, 0.2), 1e-9);
  ASSERT_EQ(turnedTestFunctions().size(), 3u);
  for (const TestFunction& function : turnedTestFunctions()) {
    const double half_width = function.space().high[0];
    EXPECT_NEAR(function(0.3 * half_width, -0.2 * half_width), 0.0, 1e-12) << function.name();
  }
}

TEST(Swarm, StopsByToleranceIterationsEvaluationsOrPatience) {
  const TestFunction function = eggcrate();
  const BatMove move(BatOptions{}, LeaderOptions{});
  const auto run = [&](const StopRule& rule) {
    Rng rng(3);
    Swarm swarm(function.space(), spreadOver(function.space(), 50, rng), function);
    return search(swarm, move, function, rule, rng);
  };
  StopRule rule;
  rule.tolerance = 0.01;
  const SearchResult reached = run(rule);
  EXPECT_TRUE(reached.is_reached);
  EXPECT_GT(reached.iterations, 1);

  rule = {};
  rule.tolerance = -1.0;
  rule.max_iterations = 7;
  EXPECT_EQ(run(rule).iterations, 7);
  EXPECT_FALSE(run(rule).is_reached);
  rule.max_evaluations = 200.0;  // 50 at first, and three times 50
  EXPECT_EQ(run(rule).iterations, 3);
  rule.max_evaluations = 199.0;
  EXPECT_EQ(run(rule).iterations, 2);
  rule.max_evaluations = 10.0;
  EXPECT_EQ(run(rule).iterations, 0);
  rule = {};
  rule.tolerance = -1.0;
  rule.max_iterations = 100000;
  rule.patience = 5;
  EXPECT_LT(run(rule).iterations, 5000);
}

TEST(Swarm, KeepsTheBestPlaceEverEvenIfNobodyStaysThere) {
  const TestFunction function = rastrigin();
  Rng rng(4);
  Swarm swarm(function.space(), spreadOver(function.space(), 30, rng), function);
  const ParticleSwarmMove move;
  double before = swarm.best_cost;
  for (int t = 0; t < 50; ++t) {
    move.step(swarm, function, rng);
    ASSERT_LE(swarm.best_cost, before);
    ASSERT_DOUBLE_EQ(function(swarm.best[0], swarm.best[1]), swarm.best_cost);
    before = swarm.best_cost;
  }
}

}  // namespace adaptive_localization
