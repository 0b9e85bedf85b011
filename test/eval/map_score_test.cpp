// SPDX-License-Identifier: BSD-3-Clause
#include "eval/map_score.hpp"

#include <gmock/gmock.h>

#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// A grid that says what it is told to.
class ToldGrid : public EvidenceGrid {
 public:
  ToldGrid(const Lattice& lattice, std::vector<double> probabilities)
      : EvidenceGrid(lattice, {}), probabilities_(std::move(probabilities)) {}

 private:
  void addCone(const Ping&, const std::vector<ConeCell>&) override {}
  double probabilityAt(std::size_t index) const override { return probabilities_[index]; }

  std::vector<double> probabilities_;
};

ToldGrid says(const OccupancyGrid& map) {
  std::vector<double> probabilities;
  for (const int value : map.cells()) probabilities.push_back(value < 0 ? 0.5 : value / 100.0);
  return ToldGrid(map.lattice(), std::move(probabilities));
}

MapScore scoreOf(const Art& made, const Art& truth) {
  const auto map = toyWorld(truth, 0.1);
  return adaptive_localization::scoreOf(says(*toyWorld(made, 0.1)),
                                        surfacesOn(map->lattice(), *map));
}

TEST(MapScore, TheTruthIsPerfect) {
  const Art truth{"#####", "#...#", "#####"};
  const MapScore score = scoreOf(truth, truth);
  EXPECT_EQ(score.cells, 15U);
  EXPECT_EQ(score.entropy, 0.0);
  EXPECT_EQ(score.known_share, 1.0);
  EXPECT_EQ(score.correct_share, 1.0);
  EXPECT_EQ(score.f_score, 1.0);
}

TEST(MapScore, AnEmptyMapHasABitPerCell) {
  const MapScore score = scoreOf({"?????", "?????", "?????"}, {"#####", "#...#", "#####"});
  EXPECT_EQ(score.entropy, 1.0);
  EXPECT_EQ(score.known_share, 0.0);
  EXPECT_EQ(score.correct_share, 0.0);
  EXPECT_EQ(score.f_score, 0.0);
}

TEST(MapScore, ACellMoreOrLessIsAsGood) {
  const Art truth{"#......", "#......", "#......"};
  EXPECT_EQ(scoreOf({".#.....", ".#.....", ".#....."}, truth).f_score, 1.0);
  const MapScore far = scoreOf({"..#....", "..#....", "..#...."}, truth);
  EXPECT_EQ(far.f_score, 0.0);
  EXPECT_NEAR(far.correct_share, 15.0 / 21.0, 1e-12);
}

TEST(MapScore, TellsWhatIsInventedFromWhatIsMissed) {
  const Art truth{"#......", "#......", "#......", "#......"};
  const MapScore score = scoreOf({"#.....#", ".......", ".......", "......#"}, truth);
  EXPECT_NEAR(score.precision, 1.0 / 3.0, 1e-12);
  EXPECT_NEAR(score.recall, 2.0 / 4.0, 1e-12);
  EXPECT_NEAR(score.f_score, 2.0 / (3.0 + 2.0), 1e-12);
}

TEST(MapScore, WhatNobodySeesDoesNotCount) {
  const auto truth = toyWorld({"####..", "####..", "####??"}, 0.1);
  const OccupancyGrid surfaces = surfacesOn(truth->lattice(), *truth);
  EXPECT_THAT(surfaces.cells(), ElementsAre(-1, -1, -1, 100, -1, -1,  //
                                            -1, -1, -1, 100, 0, 0,    //
                                            -1, -1, -1, 100, 0, 0));
}

TEST(MapScore, TheTruthMayHaveOtherCells) {
  const auto fine = toyWorld({"#...", "#...", "#...", "#..."}, 0.05);
  EXPECT_THAT(surfacesOn(Lattice(2, 2, 0.1, {}), *fine).cells(), ElementsAre(100, 0, 100, 0));
  EXPECT_THAT([&] { adaptive_localization::scoreOf(says(*fine), *toyWorld({"#."}, 0.1)); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("another lattice")));
  EXPECT_THAT([] { scoreOf(Art{"#."}, Art{"??"}); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("no cell")));
}

}  // namespace
}  // namespace adaptive_localization
