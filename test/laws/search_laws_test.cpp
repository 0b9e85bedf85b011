// SPDX-License-Identifier: BSD-3-Clause
// The global search gives what looking at every pose gives, whatever the map and scan.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <tuple>
#include <vector>

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
    const auto plain = lookAtEveryPose(scan);
    ASSERT_TRUE(!plain.empty() || options_.search_max_error < 1.0);
    ASSERT_EQ(fast.size(), plain.size());
    for (std::size_t i = 0; i < fast.size(); ++i) {
      ASSERT_EQ(fast[i].cell, plain[i].cell);
      ASSERT_EQ(fast[i].direction, plain[i].direction);
      ASSERT_EQ(fast[i].cost, plain[i].cost);
    }
  }

  int inSteps(double range) const {
    return static_cast<int>(std::ceil(range / grid_->ranges().metresPerStep()));
  }

  /// The costs of the headings at a cell by their formula; in 16 bits, which vectors hold most of.
  std::array<std::uint16_t, kDirections> costsAt(std::uint32_t cell,
                                                 const DirectionalScan& scan) const {
    const double steps = options_.search_truncation / grid_->ranges().metresPerStep();
    const auto truncation = static_cast<std::int16_t>(std::clamp(std::round(steps), 1.0, 255.0));
    std::array<std::int16_t, 2 * kDirections> seen;  // twice around
    for (int k = 0; k < 2 * kDirections; ++k) {
      seen[static_cast<std::size_t>(k)] = grid_->ranges().ranges(cell)[k % kDirections];
    }
    std::array<std::uint16_t, kDirections> costs{};
    for (std::size_t k = 0; k < costs.size(); ++k) {
      const std::int16_t range = scan.range[k];
      if (range < 0) continue;
      for (std::size_t d = 0; d < costs.size(); ++d) {
        const auto off = static_cast<std::int16_t>(range - seen[d + k]);
        const auto error = std::max(off, static_cast<std::int16_t>(-off));
        costs[d] = static_cast<std::uint16_t>(costs[d] + std::min(error, truncation));
      }
    }
    return costs;
  }

  /// What findPoses() says that it gives.
  std::vector<SearchPose> lookAtEveryPose(const DirectionalScan& scan) const {
    std::vector<SearchPose> poses;
    int most = inSteps(options_.search_max_error * scan.valid);
    for (std::uint32_t cell = 0; cell < grid_->ranges().size(); ++cell) {
      const auto costs = costsAt(cell, scan);
      for (int direction = 0; direction < kDirections; ++direction) {
        const int cost = costs[static_cast<std::size_t>(direction)];
        if (cost <= most) poses.push_back({cell, direction, cost});
        most = std::min(most, cost + inSteps(options_.search_margin * scan.valid));
      }
    }
    std::sort(poses.begin(), poses.end(), [](const SearchPose& a, const SearchPose& b) {
      return std::tie(a.cost, a.cell, a.direction) < std::tie(b.cost, b.cell, b.direction);
    });
    const auto is_worse = [most](const SearchPose& pose) { return pose.cost > most; };
    poses.erase(std::find_if(poses.begin(), poses.end(), is_worse), poses.end());
    poses.resize(std::min<std::size_t>(poses.size(), 100000));
    return poses;
  }

  std::shared_ptr<const EnergyGrid> grid_;
  GlobalSearchOptions options_;
  std::shared_ptr<const GlobalSearch> search_;
  Rng rng_{4};
};

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
