// SPDX-License-Identifier: BSD-3-Clause
// The global search gives what looking at every pose gives, whatever the map and scan.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "../ser/ser_toys.hpp"

namespace adaptive_localization {
namespace {

class SearchLaw : public testing::Test {
 protected:
  static GlobalSearchOptions unlimited() {
    GlobalSearchOptions options;
    options.search_max_error = 1000.0;  // the best of garbage, too
    return options;
  }
  void use(const MapPtr& map, const GlobalSearchOptions& options = unlimited()) {
    grid_ = gridOf(map);
    options_ = options;
    search_ = searchOn(grid_, map, options);
  }

  /// A pose's own scan with noise and a share of beams that read anything or nothing.
  DirectionalScan noisyScan(double wrong) {
    const RangeTable& table = grid_->ranges();
    const std::size_t cell = rng_.below(table.size());
    DirectionalScan scan = scanOf(table, cell, static_cast<int>(rng_.below(kDirections)), 91);
    scan.valid = 0;
    for (std::size_t k = 0; k < 91; ++k) {
      auto& range = scan.range[k];
      const auto noisy = static_cast<int>(std::lround(range + rng_.normal(0.0, 1.5)));
      range = static_cast<std::int16_t>(std::clamp(noisy, 0, kNoReturn));
      if (rng_.uniform() < wrong) {
        range = static_cast<std::int16_t>(static_cast<int>(rng_.below(257)) - 1);
      }
      scan.valid += range >= 0 ? 1 : 0;
    }
    return scan;
  }

  void expectSameAsPlain(const DirectionalScan& scan) {
    const auto fast = search_->findPoses(scan);
    const auto plain = search_->findPosesPlainly(scan);
    ASSERT_TRUE(!plain.empty() || options_.search_max_error < 1.0);
    ASSERT_EQ(fast.size(), plain.size());
    for (std::size_t i = 0; i < fast.size(); ++i) {
      ASSERT_EQ(fast[i].cell, plain[i].cell);
      ASSERT_EQ(fast[i].direction, plain[i].direction);
      ASSERT_EQ(fast[i].cost, plain[i].cost);
    }
  }

  /// The cost by its formula.
  int costOf(const DirectionalScan& scan, std::size_t cell, int direction) const {
    const RangeTable& table = grid_->ranges();
    const int truncation =
        static_cast<int>(std::lround(options_.search_truncation / table.metresPerStep()));
    int cost = 0;
    for (int k = 0; k < kDirections; ++k) {
      const int range = scan.range[static_cast<std::size_t>(k)];
      const int seen = table.ranges(cell)[(direction + k) % kDirections];
      if (range >= 0) cost += std::min(std::abs(range - seen), truncation);
    }
    return cost;
  }

  std::shared_ptr<const EnergyGrid> grid_;
  GlobalSearchOptions options_;
  std::shared_ptr<const GlobalSearch> search_;
  Rng rng_{4};
};

TEST_F(SearchLaw, PlainSearchIsTheFormula) {
  use(smallRoom());
  for (int n = 0; n < 20; ++n) {
    const DirectionalScan scan = n % 2 == 0 ? noisyScan(0.1) : randomScan(rng_, 91);
    const auto found = search_->findPosesPlainly(scan);
    int best = 1 << 30;
    std::size_t within = 0;
    const int margin =
        static_cast<int>(std::ceil(0.05 * scan.valid / grid_->ranges().metresPerStep()));
    for (const bool is_counting : {false, true}) {
      for (std::size_t cell = 0; cell < grid_->ranges().size(); ++cell) {
        for (int d = 0; d < kDirections; ++d) {
          const int cost = costOf(scan, cell, d);
          best = std::min(best, cost);
          within += is_counting && cost <= best + margin ? 1 : 0;
        }
      }
    }
    ASSERT_FALSE(found.empty());
    EXPECT_EQ(found.front().cost, best);
    EXPECT_EQ(found.size(), within);
    for (const SearchPose& pose : found) {
      ASSERT_EQ(pose.cost, costOf(scan, pose.cell, pose.direction));
    }
  }
}

TEST_F(SearchLaw, FindsWhatLookingAtEveryPoseFinds) {
  use(toyWorld({"########", "#...#..#", "#......#", "#.#....#", "########"}, 0.5));
  for (int n = 0; n < 5000; ++n) {
    ASSERT_NO_FATAL_FAILURE(expectSameAsPlain(noisyScan(rng_.uniform(0.0, 0.4)))) << n;
    ASSERT_NO_FATAL_FAILURE(expectSameAsPlain(randomScan(rng_, 91))) << n;
  }
}

TEST_F(SearchLaw, HoldsWhereNothingFitsWellEnough) {
  GlobalSearchOptions options;
  options.search_max_error = 0.1;
  use(smallRoom(), options);
  const double most = options.search_max_error / grid_->ranges().metresPerStep();
  int none = 0;
  for (int n = 0; n < 200; ++n) {
    const DirectionalScan scan = noisyScan(rng_.uniform(0.0, 0.3));
    ASSERT_NO_FATAL_FAILURE(expectSameAsPlain(scan));
    const auto found = search_->findPoses(scan);
    none += found.empty() ? 1 : 0;
    for (const SearchPose& pose : found) ASSERT_LE(pose.cost, std::ceil(most * scan.valid));
  }
  EXPECT_GT(none, 20);
  EXPECT_LT(none, 180);
}

TEST_F(SearchLaw, HoldsForAnyTruncationAndMargin) {
  for (const double truncation : {0.01, 0.1, 2.0, 100.0}) {
    for (const double margin : {0.0, 0.02, 0.5}) {
      GlobalSearchOptions options = unlimited();
      options.search_truncation = truncation;
      options.search_margin = margin;
      use(smallRoom({1.0, 1.0, 1.0}), options);
      for (int n = 0; n < 50; ++n) {
        ASSERT_NO_FATAL_FAILURE(expectSameAsPlain(noisyScan(0.1))) << truncation << " " << margin;
      }
    }
  }
}

TEST_F(SearchLaw, HoldsWhereMorePosesFitThanAreKept) {
  GlobalSearchOptions options = unlimited();
  options.search_margin = 1000.0;
  use(maze(), options);
  for (const DirectionalScan& scan : {noisyScan(0.0), randomScan(rng_, 2)}) {
    ASSERT_NO_FATAL_FAILURE(expectSameAsPlain(scan));
    EXPECT_EQ(search_->findPoses(scan).size(), 100000U);
  }
}

TEST_F(SearchLaw, HoldsOnTheMazeForAFractionOfTheWork) {
  use(maze());
  std::vector<double> visited;
  for (int n = 0; n < 200; ++n) {
    const DirectionalScan scan = noisyScan(0.05);
    search_->findPoses(scan);
    visited.push_back(search_->visitedShare());
    ASSERT_NO_FATAL_FAILURE(expectSameAsPlain(scan)) << n;
  }
  std::sort(visited.begin(), visited.end());
  EXPECT_LE(visited[visited.size() / 2], 0.05);
}

}  // namespace
}  // namespace adaptive_localization
