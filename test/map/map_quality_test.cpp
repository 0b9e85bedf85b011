// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/map/map_quality.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

constexpr int kRows = 40, kColumns = 240, kMiddle = 20;

/// A wall across a hall, cells of 5 cm, as deep as a function of the column says.
template <class Depth>
MapQuality qualityOfWall(const Depth& depth) {
  Art art(kRows, std::string(kColumns, '.'));
  for (int column = 0; column < kColumns; ++column) {
    const int cells = depth(column);
    for (int i = 0; i < cells; ++i) {
      art[static_cast<std::size_t>(kMiddle - cells / 2 + i)][static_cast<std::size_t>(column)] =
          '#';
    }
  }
  return MapQuality(*toyWorld(art, 0.05));
}

MapQuality qualityOfEvenWall(int cells) {
  return qualityOfWall([cells](int) { return cells; });
}

MapQuality qualityOfNoWall() {
  return MapQuality(*toyWorld({"...", "..."}, 0.05));
}

TEST(MapQuality, WallDepthIsThatOfTheWalls) {
  for (const int cells : {2, 4, 6, 9}) {
    EXPECT_NEAR(qualityOfEvenWall(cells).wallDepth(), 0.05 * cells, 0.05) << cells;
  }
  EXPECT_EQ(qualityOfNoWall().wallDepth(), 0.0);
}

TEST(MapQuality, OnlyWallsThatNoLaserSawFromBothSidesAreThick) {
  EXPECT_FALSE(qualityOfNoWall().hasThickWalls());
  EXPECT_FALSE(qualityOfEvenWall(1).hasThickWalls());
  EXPECT_FALSE(qualityOfEvenWall(2).hasThickWalls());
  EXPECT_TRUE(qualityOfEvenWall(5).hasThickWalls());
}

int waves(int column) {
  return column / 16 % 2 == 0 ? 13 : 5;
}

TEST(MapQuality, WallsAreRoughWhereTheirDepthVaries) {
  EXPECT_EQ(qualityOfEvenWall(2).roughness(), 0.0);
  const double rough = qualityOfWall(waves).roughness();  // 0.15 or 0.35 m below a face
  EXPECT_GT(rough, 0.05);
  EXPECT_LT(rough, 0.1);
}

TEST(MapQuality, WallsOfTwoKindsAreNotRough) {
  const auto kinds = [](int column) { return column < kColumns / 2 ? 5 : 13; };
  EXPECT_LT(qualityOfWall(kinds).roughness(), 0.03);
}

TEST(MapQuality, HitsDeviateByThreeTimesWhatTheDepthVaries) {
  EXPECT_DOUBLE_EQ(qualityOfNoWall().hitDeviation(), 0.04);
  for (const int cells : {2, 5, 9}) {
    EXPECT_DOUBLE_EQ(qualityOfEvenWall(cells).hitDeviation(), 0.04) << cells;
  }
  const auto ripples = [](int column) { return column / 16 % 2 == 0 ? 9 : 5; };
  const MapQuality rough = qualityOfWall(ripples);
  EXPECT_DOUBLE_EQ(rough.hitDeviation(), 3.0 * rough.roughness());
  EXPECT_GT(rough.hitDeviation(), 0.06);
  EXPECT_DOUBLE_EQ(qualityOfWall(waves).hitDeviation(), 0.2);  // at the most
}

TEST(MapQuality, HitsDeviateHalfAsMuchFromMiddles) {
  EXPECT_DOUBLE_EQ(qualityOfNoWall().middleDeviation(), 0.04);
  EXPECT_DOUBLE_EQ(qualityOfEvenWall(9).middleDeviation(), 0.04);
  const MapQuality rough = qualityOfWall(waves);
  EXPECT_DOUBLE_EQ(rough.middleDeviation(), 1.5 * rough.roughness());
  EXPECT_GT(rough.middleDeviation(), 0.075);
}

TEST(MapQuality, CellsThatAreLikelyOccupiedAreWalls) {
  const auto sure = toyWorld({"......", "######", "......"}, 0.05, {}, 6);
  std::vector<std::int8_t> cells = sure->cells();
  for (std::int8_t& cell : cells) {
    if (cell == OccupancyGrid::kOccupied) cell = 70;
  }
  const MapQuality likely(OccupancyGrid(sure->lattice(), std::move(cells)));
  EXPECT_DOUBLE_EQ(likely.wallDepth(), MapQuality(*sure).wallDepth());
}

TEST(MapQuality, RangesAreOffWhereWallsAreThick) {
  const auto thin = toyWorld({"......", "######", "......"}, 0.05);
  const auto thick = toyWorld({"......", "######", "......"}, 0.05, {}, 6);
  const auto rock = toyWorld({"......", "######", "......"}, 0.05, {}, 60);
  EXPECT_DOUBLE_EQ(MapQuality(*thin).rangeError(), 0.05);
  EXPECT_NEAR(MapQuality(*thick).rangeError(), 0.15, 0.02);  // 0.3 m deep
  EXPECT_DOUBLE_EQ(MapQuality(*rock).rangeError(), 0.2);
  EXPECT_DOUBLE_EQ(qualityOfNoWall().rangeError(), 0.05);
}

}  // namespace
}  // namespace adaptive_localization
