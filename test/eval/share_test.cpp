// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "adaptive_localization/eval/statistics.hpp"

namespace adaptive_localization {
namespace {

void expectInterval(int count, int of, double low, double high) {
  const Share share = wilson(count, of);
  EXPECT_EQ(share.count, count);
  EXPECT_EQ(share.of, of);
  EXPECT_DOUBLE_EQ(share.value, static_cast<double>(count) / of);
  EXPECT_NEAR(share.low, low, 5e-5) << count << " of " << of;
  EXPECT_NEAR(share.high, high, 5e-5) << count << " of " << of;
}

// Newcombe, Statistics in Medicine 17 (1998), table I, method 3.
TEST(Wilson, AgreesWithPublishedIntervals) {
  expectInterval(81, 263, 0.2553, 0.3662);
  expectInterval(15, 148, 0.0624, 0.1605);
  expectInterval(0, 20, 0.0, 0.1611);
  expectInterval(1, 29, 0.0061, 0.1718);
}

TEST(Wilson, KeepsTheEndsWithinZeroAndOne) {
  EXPECT_EQ(wilson(0, 7).low, 0.0);
  EXPECT_EQ(wilson(7, 7).high, 1.0);
  EXPECT_NEAR(wilson(7, 7).low, 1.0 - wilson(0, 7).high, 1e-12);
}

TEST(Wilson, KnowsNothingWithoutTrials) {
  const Share share = wilson(0, 0);
  EXPECT_EQ(share.low, 0.0);
  EXPECT_EQ(share.high, 1.0);
}

}  // namespace
}  // namespace adaptive_localization
