// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <memory>
#include <string>

#include "bench/test_functions.hpp"
#include "swarm/leaders.hpp"
#include "swarm/swarm_search.hpp"

namespace adaptive_localization {
namespace {

using testing::ElementsAre;

/// As good everywhere: a move that is tried is made.
class Flat : public Objective {
 public:
  void evaluate(const Eigen::ArrayXXd&, Eigen::Ref<Eigen::ArrayXd> costs) const override {
    costs.setOnes();
  }
};

double meanDistanceToBest(const Swarm& swarm) {
  return ((swarm.position.col(0) - swarm.best[0]).square() +
          (swarm.position.col(1) - swarm.best[1]).square())
      .sqrt()
      .mean();
}

BatOptions withoutWalks(bool repulsive) {
  BatOptions options = printedBats();
  options.bat_walk_share = 0.0;
  options.bat_greedy = true;
  options.bat_repulsive = repulsive;
  return options;
}

SearchSpace plain(double half_width) {
  SearchSpace space;
  space.low = Eigen::ArrayXd::Constant(2, -half_width);
  space.high = Eigen::ArrayXd::Constant(2, half_width);
  return space;
}

std::map<std::string, std::shared_ptr<const SwarmMove>> allMoves() {
  BatOptions repulsive = printedBats();
  repulsive.bat_repulsive = true;
  return {{"pso", std::make_shared<ParticleSwarmMove>()},
          {"ba", std::make_shared<BatMove>(printedBats())},
          {"ba as printed", std::make_shared<BatMove>(repulsive)},
          {"lbba", std::make_shared<BatMove>(printedBats(), printedLeaders())},
          {"lbba+", std::make_shared<BatMove>(BatOptions{}, LeaderOptions{})}};
}

double shareFound(const SwarmMove& move, const TestFunction& function, Eigen::Index bats) {
  StopRule rule;
  rule.tolerance = 0.01;
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Rng rng(seed);
    Swarm swarm(function.space(), spreadOver(function.space(), bats, rng), function);
    found += search(swarm, move, function, rule, rng).is_reached ? 1 : 0;
  }
  return found / 20.0;
}

}  // namespace

TEST(BatMove, BatsFlyTowardsTheBestOneWithoutWalks) {
  Rng rng(5);
  const Flat flat;
  Swarm swarm(plain(10.0), spreadOver(plain(1.0), 100, rng), flat);
  const double before = meanDistanceToBest(swarm);
  BatMove(withoutWalks(false)).step(swarm, flat, rng);
  EXPECT_LT(meanDistanceToBest(swarm), 0.7 * before);
}

TEST(BatMove, AsPrintedTheyFlee) {
  Rng rng(5);
  const Flat flat;
  Swarm swarm(plain(10.0), spreadOver(plain(1.0), 100, rng), flat);
  const double before = meanDistanceToBest(swarm);
  BatMove(withoutWalks(true)).step(swarm, flat, rng);
  EXPECT_GT(meanDistanceToBest(swarm), 1.3 * before);
}

TEST(BatMove, AsPrintedAllWalkAtFirstAndFewLater) {
  Rng rng(6);
  const Flat flat;
  BatOptions options = printedBats();
  options.bat_walk_size = 0.0;  // a walk ends at the best place
  options.bat_greedy = true;
  Swarm swarm(plain(1.0), spreadOver(plain(1.0), 200, rng), flat);
  BatMove(options).step(swarm, flat, rng);
  EXPECT_DOUBLE_EQ(meanDistanceToBest(swarm), 0.0);
  EXPECT_DOUBLE_EQ(swarm.rate.maxCoeff(), 0.0);
  for (int t = 0; t < 10; ++t) BatMove(options).step(swarm, flat, rng);
  EXPECT_NEAR(swarm.rate.minCoeff(), options.bat_pulse_rate, 1e-3);
  EXPECT_NEAR(swarm.loudness.maxCoeff(), std::pow(0.9, 11), 1e-12);
}

TEST(BatMove, LeadersKeepTheirBatsApart) {
  const Flat flat;
  Rng rng(7);
  Eigen::ArrayXXd positions(40, 2);
  for (Eigen::Index i = 0; i < 40; ++i) {
    positions(i, 0) = (i % 2 == 0 ? -5.0 : 5.0) + rng.uniform(-1.0, 1.0);
    positions(i, 1) = rng.uniform(-1.0, 1.0);
  }
  Swarm swarm(plain(10.0), positions, flat);
  const LeaderOptions two{20, 2, "nearest_leader"};  // of equal cost: bats 0 and 1
  BatOptions options = withoutWalks(false);
  options.bat_inertia = 0.0;
  for (int t = 0; t < 10; ++t) BatMove(options, two).step(swarm, flat, rng);
  EXPECT_EQ((swarm.position.col(0) < -3.0).count(), 20);
  EXPECT_EQ((swarm.position.col(0) > 3.0).count(), 20);
}

TEST(Leaders, AreOnePerThreeHundredBats) {
  EXPECT_EQ(numberOfLeaders(1000, 300, 1), 3);
  EXPECT_EQ(numberOfLeaders(2000, 300, 1), 6);
  EXPECT_EQ(numberOfLeaders(400, 300, 1), 1);
  EXPECT_EQ(numberOfLeaders(20, 300, 1), 1);
  EXPECT_EQ(numberOfLeaders(400, 50, 3), 8);
  EXPECT_EQ(numberOfLeaders(20, 50, 3), 3);
  EXPECT_EQ(numberOfLeaders(2, 50, 3), 2);
}

TEST(Leaders, AreTheBestBatsInOrder) {
  const TestFunction function = rastrigin();
  Eigen::ArrayXXd positions(5, 2);
  positions << 3.0, 0.0, 1.0, 0.0, 0.0, 0.0, -1.0, 0.0, 2.0, 0.0;
  const Swarm swarm(function.space(), positions, function);
  EXPECT_THAT(bestBats(swarm, 3), ElementsAre(2, 1, 3));
}

TEST(Leaders, DivideTheBatsAsVoronoiCellsDo) {
  const TestFunction function = rastrigin();
  Rng rng(8);
  const SearchSpace space = function.space();
  const Swarm swarm(space, spreadOver(space, 500, rng), function);
  const auto leaders = bestBats(swarm, 7);
  const auto nearest = nearestLeaders(swarm, leaders);
  const auto apart = [&](Eigen::Index a, Eigen::Index b) {
    return std::hypot(space.way(0, swarm.position(a, 0), swarm.position(b, 0)),
                      space.way(1, swarm.position(a, 1), swarm.position(b, 1)));
  };
  for (Eigen::Index i = 0; i < swarm.size(); ++i) {
    const double own = apart(i, leaders[nearest[static_cast<std::size_t>(i)]]);
    for (const Eigen::Index leader : leaders) ASSERT_LE(own, apart(i, leader) + 1e-12);
  }
  for (std::size_t j = 0; j < leaders.size(); ++j) {
    EXPECT_EQ(nearest[static_cast<std::size_t>(leaders[j])], j);
  }
}

TEST(SwarmMoves, GiveTheSameForTheSameSeedAndAnotherForAnother) {
  const TestFunction function = ackley();
  for (const auto& [name, move] : allMoves()) {
    const auto run = [&, &move = move](std::uint64_t seed) {
      Rng rng(seed);
      Swarm swarm(function.space(), spreadOver(function.space(), 60, rng), function);
      for (int t = 0; t < 30; ++t) move->step(swarm, function, rng);
      return swarm.position.sum() + swarm.best_cost;
    };
    EXPECT_EQ(run(1), run(1)) << name;
    EXPECT_NE(run(1), run(2)) << name;
  }
}

TEST(SwarmMoves, StayInTheSpaceAndKeepCostsTrue) {
  const TestFunction function = rastrigin();
  for (const auto& [name, move] : allMoves()) {
    for (const bool is_torus : {true, false}) {
      SearchSpace space = function.space();
      space.is_torus = is_torus;
      Rng rng(9);
      Swarm swarm(space, spreadOver(space, 40, rng), function);
      for (int t = 0; t < 200; ++t) move->step(swarm, function, rng);
      ASSERT_TRUE(swarm.position.allFinite() && swarm.velocity.allFinite()) << name;
      EXPECT_LE(swarm.position.maxCoeff(), 5.12) << name;
      EXPECT_GE(swarm.position.minCoeff(), -5.12) << name;
      for (Eigen::Index i = 0; i < swarm.size(); ++i) {
        ASSERT_DOUBLE_EQ(swarm.cost[i], function(swarm.position(i, 0), swarm.position(i, 1)));
      }
    }
  }
}

TEST(SwarmMoves, TheImprovedFormFindsWhatThePrintedOneMisses) {
  const auto moves = allMoves();
  EXPECT_GE(shareFound(*moves.at("lbba+"), rastrigin(), 20), 0.95);
  EXPECT_LE(shareFound(*moves.at("lbba"), rastrigin(), 20), 0.6);
  EXPECT_GE(shareFound(*moves.at("pso"), rastrigin(), 50), 0.95);
  EXPECT_GE(shareFound(*moves.at("lbba+"), ackley(), 20), 0.95);
  EXPECT_GE(shareFound(*moves.at("lbba+"), eggcrate(), 20), 0.95);
}

}  // namespace adaptive_localization
