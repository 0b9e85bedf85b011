// SPDX-License-Identifier: BSD-3-Clause
#include "core/suggestion.hpp"

#include <gtest/gtest.h>

namespace adaptive_localization {

const std::vector<std::string> kNames{"laser_max_beams", "laser_max_range", "seed", "start"};

TEST(Suggestion, IsTheNearestName) {
  EXPECT_EQ(suggestion("lazer_max_beams", kNames), "; did you mean 'laser_max_beams'?");
  EXPECT_EQ(suggestion("laser_maxrange", kNames), "; did you mean 'laser_max_range'?");
  EXPECT_EQ(suggestion("laser_max_beansx", kNames), "; did you mean 'laser_max_beams'?");
  EXPECT_EQ(suggestion("sede", kNames), "; did you mean 'seed'?") << "neighbours swapped";
  EXPECT_EQ(suggestion("stat", kNames), "; did you mean 'start'?");
}

TEST(Suggestion, IsMissingWhereNothingIsNear) {
  EXPECT_EQ(suggestion("threads", kNames), "");
  EXPECT_EQ(suggestion("sXeY", kNames), "") << "half of it is wrong";
  EXPECT_EQ(suggestion("x", kNames), "");
  EXPECT_EQ(suggestion("", kNames), "");
  EXPECT_EQ(suggestion("seed", {}), "");
}

}  // namespace adaptive_localization
