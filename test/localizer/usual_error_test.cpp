// SPDX-License-Identifier: BSD-3-Clause
#include "localizer/usual_error.hpp"

#include <gtest/gtest.h>

namespace adaptive_localization {

TEST(UsualError, FallsSlowlyAndRisesMoreSlowly) {
  UsualError usual;
  const double first = usual.value();
  for (int i = 0; i < 10; ++i) usual.observe(10.0);  // a covered laser
  EXPECT_LT(usual.value(), 1.25 * first);
  EXPECT_GT(usual.value(), 1.1 * first);
  for (int i = 0; i < 5; ++i) usual.observe(0.01);  // a corner that is mapped well
  EXPECT_GT(usual.value(), 0.8 * first);
  for (int i = 0; i < 60; ++i) usual.observe(0.01);
  EXPECT_LT(usual.value(), 0.02);
}

TEST(UsualError, WhereThePlaceIsNotKnownItFallsButRisesToNoMoreThanWasKnown) {
  UsualError usual(0.05);
  for (int i = 0; i < 100; ++i) usual.observeUnknown(0.2);
  EXPECT_DOUBLE_EQ(usual.value(), 0.05) << "what the map lets expect";
  for (int i = 0; i < 1000; ++i) usual.observe(0.1);
  for (int i = 0; i < 100; ++i) usual.observeUnknown(0.02);
  EXPECT_LT(usual.value(), 0.03);
  for (int i = 0; i < 1000; ++i) usual.observeUnknown(0.2);
  EXPECT_NEAR(usual.value(), 0.1, 1e-3);
}

TEST(UsualError, LimitsWhatIsNotUnusual) {
  EXPECT_DOUBLE_EQ(UsualError(0.12).limit(), 0.24);
  EXPECT_DOUBLE_EQ(UsualError(0.0).limit(), 0.1);  // a perfect map
}

/// Or a core that slid away slowly would never be doubted.
TEST(UsualError, NoScanThatHardlyFitsIsUsual) {
  UsualError usual(0.05);
  for (int i = 0; i < 10000; ++i) usual.observe(0.45);
  EXPECT_GT(usual.value(), 0.4);
  EXPECT_DOUBLE_EQ(usual.limit(), 0.3);
  UsualError thick(0.2);  // on a map of thick walls most scans fit so
  for (int i = 0; i < 10000; ++i) thick.observe(RangeError::kTruncation);
  EXPECT_DOUBLE_EQ(thick.limit(), 0.45);
}

}  // namespace adaptive_localization
