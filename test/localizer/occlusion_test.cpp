// SPDX-License-Identifier: BSD-3-Clause
#include "../../src/localizer/occlusion.hpp"

#include <gmock/gmock.h>

#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Scan scanOf(const std::vector<float>& ranges) {
  Scan scan;
  scan.range = Eigen::Map<const Eigen::ArrayXf>(ranges.data(), static_cast<int>(ranges.size()));
  scan.bearing = Eigen::ArrayXf::LinSpaced(scan.range.size(), -1.0F, 1.0F);
  scan.x = scan.range * scan.bearing.cos();
  scan.y = scan.range * scan.bearing.sin();
  return scan;
}

Scan without(const Scan& scan, Eigen::Index hit) {
  Scan left = scan;
  for (Eigen::ArrayXf* row : {&left.x, &left.y, &left.range, &left.bearing}) {
    const Eigen::Index after = row->size() - hit - 1;
    row->segment(hit, after) = row->tail(after).eval();
    row->conservativeResize(row->size() - 1);
  }
  return left;
}

TEST(Occlusion, SomeStrayHitsAmongManyBeamsAreNothing) {
  Scan scan = scanOf(std::vector<float>(3, 2.0F));
  EXPECT_FALSE(seesNothing(scan));  // all of its beams
  EXPECT_FALSE(isCovered(scan));
  scan.no_return_bearing = Eigen::ArrayXf::LinSpaced(177, -1.0F, 1.0F);
  EXPECT_TRUE(seesNothing(scan));
  EXPECT_TRUE(isCovered(scan));
  scan.no_return_bearing.conservativeResize(100);
  EXPECT_FALSE(seesNothing(scan));
  EXPECT_FALSE(seesNothing(Scan()));  // no beam tells anything
  EXPECT_TRUE(isCovered(Scan()));
}

TEST(Occlusion, AMatchOfWhatWasLeftIsOneOfTheWholeScan) {
  const Scan all = scanOf({2.0F, 1.0F, 2.0F, 2.0F});
  Match match;
  match.fits = {1, 0, 1};
  match.inlier_ratio = 2.0 / 3.0;
  const Match whole = ofWholeScan(match, without(all, 1), all);
  EXPECT_THAT(whole.fits, ElementsAre(1, 0, 0, 1));
  EXPECT_DOUBLE_EQ(whole.inlier_ratio, 0.5);
}

TEST(Occlusion, AMatchThatDoesNotTellOfEachHitStaysAsItIs) {
  const Scan all = scanOf({2.0F, 1.0F, 2.0F, 2.0F});
  Match match;
  EXPECT_THAT(ofWholeScan(match, without(all, 1), all).fits, IsEmpty());
  match.fits = {1};  // a plug-in may answer anything
  EXPECT_THAT(ofWholeScan(match, without(all, 1), all).fits, ElementsAre(1));
  match.fits = {1, 1, 0, 1};
  EXPECT_THAT(ofWholeScan(match, all, all).fits, ElementsAre(1, 1, 0, 1));
}

TEST(Occlusion, AHitBeforeAWallIsAnObstacleAndOneBehindItIsNot) {
  const auto map = asymmetricWorld();
  const DistanceField field(*map);
  const RangeError range_error(map);
  const Pose2 pose{2.0, 3.0, -0.5};
  Scan scan = ToyLaser{91, -kPi / 2, kPi / 2, 12.0}.observe(map, pose).scan;
  for (const auto& [hit, factor] : {std::pair{30, 0.5F}, {60, 1.5F}}) {
    scan.range[hit] *= factor;
    scan.x[hit] *= factor;
    scan.y[hit] *= factor;
  }
  const Scan left = withoutObstacles(scan, pose, field, range_error);
  ASSERT_EQ(left.hits(), scan.hits() - 1);
  EXPECT_EQ(left.bearing[30], scan.bearing[31]);
  EXPECT_EQ(left.range[59], scan.range[60]);
}

}  // namespace
}  // namespace adaptive_localization
