// SPDX-License-Identifier: BSD-3-Clause
#include "particle/pose_sampler.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <stdexcept>

#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

/// Chi-square of counts that should be equal.
double chiSquare(const std::vector<int>& counts) {
  double mean = 0.0;
  for (const int count : counts) mean += count / static_cast<double>(counts.size());
  double sum = 0.0;
  for (const int count : counts) sum += (count - mean) * (count - mean) / mean;
  return sum;
}

TEST(FreeSpaceSampler, IsUniformOverFreeCellsOnly) {
  for (const Pose2& origin : {Pose2{}, Pose2{-3.0, 2.0, 1.1}}) {
    const auto map = toyWorld({"#..#?", "?....", "#####", "..#.#"}, 0.3, origin);
    const FreeSpaceSampler sampler(map);
    std::vector<int> counts(map->lattice().size());
    Rng rng(1);
    for (int i = 0; i < 20000; ++i) {
      const Pose2 pose = sampler.draw(rng);
      const Cell cell = map->lattice().cellAt({pose.x, pose.y});
      ASSERT_TRUE(map->isFree(cell));
      ++counts[map->lattice().index(cell)];
    }
    counts.erase(std::remove(counts.begin(), counts.end(), 0), counts.end());
    ASSERT_EQ(counts.size(), 9u);
    EXPECT_LT(chiSquare(counts), 26.1);  // 99.9 % for 8 degrees of freedom
  }
}

TEST(FreeSpaceSampler, IsUniformInsideOfACellAndInHeading) {
  const FreeSpaceSampler sampler(toyWorld({"##", "#."}, 2.0, {1.0, 1.0, 0.0}));
  std::vector<int> left_right(8), up_down(8), headings(8);
  Rng rng(2);
  for (int i = 0; i < 8000; ++i) {
    const Pose2 pose = sampler.draw(rng);
    ++left_right.at(static_cast<std::size_t>((pose.x - 3.0) / 2.0 * 8.0));
    ++up_down.at(static_cast<std::size_t>((pose.y - 1.0) / 2.0 * 8.0));
    ++headings.at(static_cast<std::size_t>((pose.theta + kPi) / (2.0 * kPi) * 8.0));
  }
  for (const auto& counts : {left_right, up_down, headings}) {
    EXPECT_LT(chiSquare(counts), 24.3);  // 99.9 % for 7 degrees of freedom
  }
}

TEST(FreeSpaceSampler, RefusesAMapWithoutFreeCells) {
  try {
    FreeSpaceSampler(toyWorld({"#?", "##"}, 0.1));
    FAIL() << "found a free cell";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("no free cell"));
  }
}

}  // namespace
}  // namespace adaptive_localization
