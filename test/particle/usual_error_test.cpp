// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/particle/usual_error.hpp"

#include <gtest/gtest.h>

namespace adaptive_localization {

TEST(UsualError, FallsAtOnceAndRisesSlowly) {
  UsualError usual;
  const double first = usual.value();
  for (int i = 0; i < 10; ++i) usual.observe(10.0);  // a covered laser
  EXPECT_LT(usual.value(), 1.25 * first);
  EXPECT_GT(usual.value(), 1.1 * first);
  for (int i = 0; i < 10; ++i) usual.observe(0.01);
  EXPECT_LT(usual.value(), 0.02);
}

TEST(UsualError, LimitsWhatIsNotUnusual) {
  UsualError usual;
  EXPECT_DOUBLE_EQ(usual.limit(2.0, 0.16), 2.0 * usual.value());
  EXPECT_DOUBLE_EQ(usual.limit(0.0, 0.16), 0.16);   // never mind what is usual
  EXPECT_DOUBLE_EQ(usual.limit(10.0, 0.16), 0.16);  // nor above the most
  for (int i = 0; i < 50; ++i) usual.observe(0.0);
  EXPECT_DOUBLE_EQ(usual.limit(2.0, 0.16), 0.05);  // a perfect map
}

}  // namespace adaptive_localization
