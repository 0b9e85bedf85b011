// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/eval/sign_test.hpp"

#include <gtest/gtest.h>

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

}  // namespace adaptive_localization
