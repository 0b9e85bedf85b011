// SPDX-License-Identifier: BSD-3-Clause
#include "../../src/localizer/kept_place.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

const Pose2 kPlace{1.5, 2.0, 0.0};
const Art kBare{"################",  //
                "#..............#",  //
                "#..............#",  //
                "#..............#",  //
                "#..............#",  //
                "#..............#",  //
                "#..............#",  //
                "################"};
const Art kWithBox{"################",  //
                   "#..............#",  //
                   "#.......##.....#",  //
                   "#.......##.....#",  //
                   "#.......##.....#",  //
                   "#.......##.....#",  //
                   "#..............#",  //
                   "################"};
const Art kShorter{"################",  //
                   "#.........######",  //
                   "#.........######",  //
                   "#.........######",  //
                   "#.........######",  //
                   "#.........######",  //
                   "#.........######",  //
                   "################"};

std::shared_ptr<const OccupancyGrid> world(const Art& art) {
  return hollow(*toyWorld(art, 0.05, {}, 10));
}

/// Against the place, on one map, by a scan of another world.
double against(const Art& on_map, const Art& in_world, bool is_word = false,
               const ToyLaser& laser = {181, -kPi / 2, kPi / 2, 12.0}) {
  const auto map = world(on_map);
  const auto field = std::make_shared<const DistanceField>(*map);
  const Scan scan = laser.observe(world(in_world), kPlace).scan;
  const PlaceRefiner refiner(map, field, scan, scan.max_range, RangeError::kTruncation);
  return mostAgainst(refiner, kPlace, is_word, 0.05);
}

TEST(KeptPlace, LosesLittleByWhatWasBroughtThere) {
  EXPECT_DOUBLE_EQ(against(kBare, kWithBox), 0.2);
}

TEST(KeptPlace, LosesLittleByWhatWasBroughtEvenIfAFewBeamsGoOn) {
  const Art with_post{"################",  //
                      "#..............#",  //
                      "#..............#",  //
                      "#..............#",  //
                      "#.......########",  //
                      "#..............#",  //
                      "#..............#",  //
                      "################"};
  const Art with_wide_box{"################",  //
                          "#.....##.......#",  //
                          "#.....##.......#",  //
                          "#.....##.......#",  //
                          "#..............#",  //
                          "#..............#",  //
                          "#..............#",  //
                          "################"};
  EXPECT_DOUBLE_EQ(against(with_post, with_wide_box), 0.2);
}

TEST(KeptPlace, LosesLittleIfWhatWasBroughtHidesNearlyHalfAndIsLostIfItHidesMore) {
  const Art with_two_boxes{"################",  //
                           "#.....##.......#",  //
                           "#.....##.......#",  //
                           "#.....##.......#",  //
                           "#..............#",  //
                           "#...#..........#",  //
                           "#...#..........#",  //
                           "################"};
  const Art with_walls_around{"################",  //
                              "#....#.........#",  //
                              "#....#.........#",  //
                              "#....#.........#",  //
                              "#....#.........#",  //
                              "#....#.........#",  //
                              "#....#.........#",  //
                              "################"};
  EXPECT_DOUBLE_EQ(against(kBare, with_two_boxes), 0.2);
  EXPECT_TRUE(std::isinf(against(kBare, with_walls_around)));
  const ToyLaser camera{81, -0.5, 0.5, 12.0};  // one thing may fill its view
  EXPECT_DOUBLE_EQ(against(kBare, with_walls_around, false, camera), 0.2);
  const ToyLaser wide{181, -0.8, 0.8, 12.0};
  EXPECT_TRUE(std::isinf(against(kBare, with_walls_around, false, wide)));
}

/// Shelves were taken away and a desk was brought: beams go on, and others end early.
TEST(KeptPlace, IsNotRefutedByOneViewOfACamera) {
  const Art with_shelves{"################",  //
                         "#..............#",  //
                         "#.......#......#",  //
                         "#.......#......#",  //
                         "#..............#",  //
                         "#..............#",  //
                         "#..............#",  //
                         "################"};
  const Art with_desk{"################",  //
                      "#..............#",  //
                      "#..............#",  //
                      "#..............#",  //
                      "#....##........#",  //
                      "#....##........#",  //
                      "#....##........#",  //
                      "################"};
  const ToyLaser camera{81, -0.5, 0.5, 12.0}, wide{181, -0.8, 0.8, 12.0};
  EXPECT_DOUBLE_EQ(against(with_shelves, with_desk, false, camera), 3.0);
  EXPECT_DOUBLE_EQ(against(with_shelves, with_desk, true, camera), 3.0);
  EXPECT_TRUE(std::isinf(against(with_shelves, with_desk, false, wide)));
}

TEST(KeptPlace, LosesLittleByWhatWasTakenAway) {
  EXPECT_DOUBLE_EQ(against(kWithBox, kBare), 0.2);
  EXPECT_DOUBLE_EQ(against(kWithBox, kBare, true), 0.2);
}

/// A tenth of the hits may be stray, and one more; on a poor map they count as on walls though they
/// are as far off as is usual there.
TEST(KeptPlace, LosesLittleByWhatWasTakenAwayThoughOneOfFewHitsIsStray) {
  const auto map = world(kWithBox);
  const auto field = std::make_shared<const DistanceField>(*map);
  const auto mostBy = [&](int stray, float off, double usual) {
    Scan scan = ToyLaser{19, -kPi / 2, kPi / 2, 12.0}.observe(world(kBare), kPlace).scan;
    for (int i = 0; i < stray; ++i) scan.x[8 + i] -= 0.6F;
    scan.y.tail(4) -= off;  // of the wall on the left
    const PlaceRefiner refiner(map, field, scan, scan.max_range, RangeError::kTruncation);
    return mostAgainst(refiner, kPlace, false, usual);
  };
  EXPECT_DOUBLE_EQ(mostBy(0, 0.0F, 0.05), 0.2);
  EXPECT_DOUBLE_EQ(mostBy(2, 0.0F, 0.05), 0.2);
  EXPECT_DOUBLE_EQ(mostBy(3, 0.0F, 0.05), 1.5);
  EXPECT_DOUBLE_EQ(mostBy(0, 0.15F, 0.1), 0.2);
  EXPECT_DOUBLE_EQ(mostBy(0, 0.15F, 0.05), 1.5);
}

TEST(KeptPlace, LosesLittleByWhatWasTakenAwayThoughSomebodyStandsBesideIt) {
  const Art with_somebody{"################",  //
                          "#..............#",  //
                          "#..............#",  //
                          "#..............#",  //
                          "#..............#",  //
                          "#..............#",  //
                          "#......##......#",  //
                          "################"};
  EXPECT_DOUBLE_EQ(against(kWithBox, with_somebody), 0.2);
}

TEST(KeptPlace, IsNotLostByALargeThingThatWasTakenAwayThoughSomebodyStandsBesideIt) {
  const Art with_large_box{"################",  //
                           "#......#.......#",  //
                           "#......#.......#",  //
                           "#......#.......#",  //
                           "#......#.......#",  //
                           "#......#.......#",  //
                           "#......#.......#",  //
                           "################"};
  const Art with_somebody{"################",  //
                          "#..............#",  //
                          "#..............#",  //
                          "#..............#",  //
                          "#.....#........#",  //
                          "#..............#",  //
                          "#..............#",  //
                          "################"};
  EXPECT_DOUBLE_EQ(against(with_large_box, with_somebody), 0.2);
}

TEST(KeptPlace, LosesMoreWhereBeamsGoOnToWhereNothingIs) {
  EXPECT_DOUBLE_EQ(against(kShorter, kBare), 1.5);
  EXPECT_DOUBLE_EQ(against(kShorter, kBare, true), 2.0);
}

TEST(KeptPlace, IsLostWhereLittleFits) {
  const Art tiny{"######", "#....#", "#....#", "#....#", "#....#", "#....#", "#....#", "######"};
  EXPECT_TRUE(std::isinf(against(tiny, kBare)));
}

}  // namespace
}  // namespace adaptive_localization
