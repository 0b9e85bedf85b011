// SPDX-License-Identifier: BSD-3-Clause
#include "ser/place_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "adaptive_localization/core/rng.hpp"

namespace adaptive_localization {
namespace {

TEST(PlaceMap, KnowsThePlacesThatComparingWithAllFinds) {
  Rng rng(1);
  PlaceMap map;
  std::vector<Pose2> all;
  int known = 0;
  for (int i = 0; i < 3000; ++i) {
    const Pose2 pose{rng.uniform(-8.0, 8.0), rng.uniform(-8.0, 8.0), rng.uniform(-kPi, kPi)};
    const bool is_known = std::any_of(
        all.begin(), all.end(), [&](const Pose2& other) { return areSamePlace(pose, other); });
    ASSERT_EQ(map.hasSame(pose), is_known) << i;
    known += is_known ? 1 : 0;
    if (is_known) continue;
    map.add(pose);
    all.push_back(pose);
  }
  EXPECT_GT(known, 500);
  EXPECT_GT(all.size(), 500U);
}

}  // namespace
}  // namespace adaptive_localization
