// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "adaptive_localization/eval/statistics.hpp"

namespace adaptive_localization {

TEST(SignTest, CountsTheWaysToWinAtLeastSoOften) {
  EXPECT_NEAR(signTest(5, 0), 1.0 / 32.0, 1e-12);
  EXPECT_NEAR(signTest(4, 1), 6.0 / 32.0, 1e-12);
  EXPECT_NEAR(signTest(0, 5), 1.0, 1e-12);
  EXPECT_NEAR(signTest(18, 2), 211.0 / 1048576.0, 1e-12);  // 1 + 20 + 190 of 2^20
  EXPECT_EQ(signTest(0, 0), 1.0);
}

TEST(SignTest, LeavesOutPairsThatAreEqual) {
  EXPECT_NEAR(signTestOfLess({1, 2, 3, 500, 500}, {2, 3, 4, 500, 500}), 1.0 / 8.0, 1e-12);
  EXPECT_NEAR(signTestOfLess({1, 9}, {2, 3}), 3.0 / 4.0, 1e-12);
}

TEST(SignedRankTest, HasWilcoxonsNumbers) {
  // Differences 1 to 10, of which 1 and 3 against: W = 51 of 55, E = 27.5, variance 96.25.
  const std::vector<int> partners(10, 100);
  const std::vector<int> values{101, 98, 103, 96, 95, 94, 93, 92, 91, 90};
  EXPECT_NEAR(signedRankTestOfLess(values, partners), 0.00952, 1e-4);  // z = 2.344
  EXPECT_NEAR(signedRankTestOfLess(partners, values), 0.99279, 1e-4);  // z = -2.446
}

TEST(SignedRankTest, GivesTiesTheirMeanRankAndLeavesOutEquals) {
  // Ranks 2, 2, 2, 4 and a pair that is equal: W = 8, E = 5, variance 7.5 - 24 / 48.
  EXPECT_NEAR(signedRankTestOfLess({9, 9, 11, 5, 10}, {10, 10, 10, 10, 10}), 0.1723, 1e-3);
  EXPECT_EQ(signedRankTestOfLess({1, 2}, {1, 2}), 1.0);
}

}  // namespace adaptive_localization
