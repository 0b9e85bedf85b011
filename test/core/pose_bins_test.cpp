// SPDX-License-Identifier: BSD-3-Clause
#include "core/pose_bins.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <vector>

#include "core/parallel.hpp"
#include "support/pose_matchers.hpp"

namespace adaptive_localization {
namespace {

TEST(PoseBins, CountAsAnOrderedMapDoes) {
  Rng rng(1);
  PoseBins bins(0.5, kPi / 18.0);
  EXPECT_EQ(bins.headings(), 36);
  std::map<std::tuple<int, int, int>, int> expected;
  for (int i = 0; i < 20000; ++i) {
    const Pose2 pose = randomPose(rng, 4.0);
    const double turned = pose.theta < 0.0 ? pose.theta + 2.0 * kPi : pose.theta;
    const std::tuple<int, int, int> bin{static_cast<int>(std::floor(pose.x / 0.5)),
                                        static_cast<int>(std::floor(pose.y / 0.5)),
                                        static_cast<int>(turned / (2.0 * kPi) * 36.0)};
    const auto entry = expected.emplace(bin, static_cast<int>(expected.size())).first;
    ASSERT_EQ(bins.add(pose), entry->second);
    ASSERT_EQ(bins.count(), static_cast<int>(expected.size()));
  }
  EXPECT_GT(bins.count(), 5000);
  for (int number = 0; number < bins.count(); ++number) {
    ASSERT_EQ(bins.find(bins.bin(number)), number);
  }
}

TEST(PoseBins, NumberBinsInTheOrderOfTheirFirstPose) {
  PoseBins bins(1.0, 1.0);
  EXPECT_EQ(bins.add({0.5, 0.5, 0.1}), 0);
  EXPECT_EQ(bins.add({-0.5, 0.5, 0.1}), 1);
  EXPECT_EQ(bins.add({0.9, 0.1, 0.1}), 0);
  EXPECT_EQ(bins.count(), 2);
}

TEST(PoseBins, OfManyParticlesAreNumberedAsOneByOne) {
  Rng rng(2);
  Particles particles(30001);
  for (Eigen::Index i = 0; i < particles.size(); ++i) particles.setPose(i, randomPose(rng, 3.0));
  PoseBins by_one(0.5, kPi / 18.0), bins(0.5, kPi / 18.0);
  setThreads(4);
  const std::vector<int> numbers = bins.addAll(particles);
  setThreads(1);
  for (Eigen::Index i = 0; i < particles.size(); ++i) {
    ASSERT_EQ(numbers[static_cast<std::size_t>(i)], by_one.add(particles.pose(i))) << i;
  }
  EXPECT_EQ(bins.count(), by_one.count());
}

TEST(PoseBins, WrapHeadings) {
  PoseBins bins(1.0, kPi / 2);
  EXPECT_EQ(bins.headings(), 4);
  const int first = bins.add({0.5, 0.5, 0.1});
  const int last = bins.add({0.5, 0.5, -0.1});
  EXPECT_EQ(bins.add({0.5, 0.5, 0.1 + 4.0 * kPi}), first);
  EXPECT_EQ(bins.find({0, 0, 4}), first);
  EXPECT_EQ(bins.find({0, 0, -1}), last);
  EXPECT_EQ(bins.find({0, 0, 1}), PoseBins::kNone);
  EXPECT_EQ(bins.add({0.5, 0.5, kPi}), bins.add({0.5, 0.5, -kPi}));
}

TEST(PoseBins, MayIgnoreHeadings) {
  PoseBins bins(1.0, 2.0 * kPi);
  EXPECT_EQ(bins.add({0.5, 0.5, -3.0}), bins.add({0.5, 0.5, 3.0}));
  EXPECT_EQ(bins.find({0, 0, 1}), 0);
}

TEST(PoseBins, TakeAnyPose) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  PoseBins bins(0.5, kPi / 18.0);
  int poses = 0;
  for (const double odd : {nan, inf, -inf, 1e300, -1e300, 1e10}) {
    for (const Pose2& pose : {Pose2{odd, 0.0, 0.0}, Pose2{0.0, odd, 0.0}, Pose2{0.0, 0.0, odd}}) {
      const PoseBin bin = bins.bin(bins.add(pose));
      EXPECT_GE(bin.theta, 0);
      EXPECT_LT(bin.theta, 36);
      EXPECT_LT(std::abs(static_cast<double>(bin.x)), 2147483647.0);  // its neighbours are numbers
      EXPECT_LT(std::abs(static_cast<double>(bin.y)), 2147483647.0);
      ++poses;
    }
  }
  EXPECT_LE(bins.count(), poses);
}

}  // namespace
}  // namespace adaptive_localization
