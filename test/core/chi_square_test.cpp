// SPDX-License-Identifier: BSD-3-Clause
#include "core/chi_square.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace adaptive_localization {
namespace {

TEST(ChiSquare, IsThePrintedTable) {
  EXPECT_NEAR(chiSquare(1, 0.999), 10.828, 5e-4);
  EXPECT_NEAR(chiSquare(2, 0.99), 9.210, 5e-4);
  EXPECT_NEAR(chiSquare(3, 0.99), 11.345, 5e-4);
  EXPECT_NEAR(chiSquare(3, 0.999), 16.266, 5e-4);
}

TEST(ChiSquare, IsTheEllipseOfTwoDegrees) {
  for (const double probability : {0.1, 0.5, 0.9, 0.99}) {
    EXPECT_NEAR(chiSquare(2, probability), -2.0 * std::log(1.0 - probability), 1e-9);
  }
}

TEST(ChiSquare, HasNoBoundForCertainty) {
  EXPECT_EQ(chiSquare(3, 0.0), 0.0);
  EXPECT_TRUE(std::isinf(chiSquare(3, 1.0)));
}

}  // namespace
}  // namespace adaptive_localization
