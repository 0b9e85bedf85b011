// SPDX-License-Identifier: BSD-3-Clause
#include "core/audience.hpp"

#include <gtest/gtest.h>

namespace adaptive_localization {

TEST(Audience, IsToldOfEachOption) {
  EXPECT_EQ(audienceOf("filter"), Audience::kUsers);
  EXPECT_EQ(audienceOf("odom_alpha1"), Audience::kAmcl);
  EXPECT_EQ(audienceOf("search_margin"), Audience::kExperts);
  EXPECT_EQ(audienceOf("option_of_a_plugin"), Audience::kExperts);
}

}  // namespace adaptive_localization
