// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/map/lattice.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "support/pose_matchers.hpp"

namespace adaptive_localization {
namespace {

TEST(Lattice, HasTheCornerOfCellZeroAtItsOrigin) {
  const Lattice lattice(10, 10, 0.5, {2.0, -1.0, 0.0});
  EXPECT_TRUE(lattice.centre({0, 0}).isApprox(Eigen::Vector2d(2.25, -0.75)));
  const Cell at_corner = lattice.cellAt({2.001, -0.999});
  EXPECT_EQ(at_corner.x, 0);
  EXPECT_EQ(at_corner.y, 0);
  const Cell before = lattice.cellAt({1.999, -1.001});
  EXPECT_EQ(before.x, -1);
  EXPECT_EQ(before.y, -1);
}

TEST(Lattice, RefusesWhatNoMapHasAndNamesTheValue) {
  const auto complaint = [](double resolution, const Pose2& origin) -> std::string {
    try {
      Lattice(10, 10, resolution, origin);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "none";
  };
  EXPECT_EQ(complaint(1e-3, {}), "none");
  EXPECT_EQ(complaint(0.05, {6.4e6, -6.4e6, 1.0}), "none");
  EXPECT_EQ(complaint(1e-30, {}), "map resolution: got 1e-30, expected 0.001 to 100000 m per cell");
  for (const double resolution : {-0.05, 0.0, 1e-6, 1e9, std::nan("")}) {
    EXPECT_EQ(complaint(resolution, {}).rfind("map resolution: got ", 0), 0U) << resolution;
  }
  for (const double far : {1e300, -1e9, std::nan("")}) {
    EXPECT_EQ(complaint(0.05, {0.0, far, 0.0}).rfind("map origin: got (0, ", 0), 0U) << far;
  }
}

TEST(Lattice, TurnsWithItsOrigin) {
  const Lattice lattice(4, 4, 1.0, {10.0, 0.0, kPi / 2});
  EXPECT_TRUE(lattice.centre({2, 0}).isApprox(Eigen::Vector2d(9.5, 2.5)));
}

TEST(Lattice, FindsEachCellFromPointsInsideOfIt) {
  Rng rng(1);
  for (int i = 0; i < 2000; ++i) {
    const double resolution = rng.uniform(0.01, 2.0);
    const Lattice lattice(300, 200, resolution, randomPose(rng, 100.0));
    const Cell cell{static_cast<int>(rng.below(300)), static_cast<int>(rng.below(200))};
    const Pose2 centre{lattice.centre(cell).x(), lattice.centre(cell).y(), 0.0};
    const double reach = 0.49 * resolution;  // inside however the lattice is turned
    const double course = rng.uniform(-kPi, kPi);
    const Cell found =
        lattice.cellAt({centre.x + reach * std::cos(course), centre.y + reach * std::sin(course)});
    ASSERT_EQ(found.x, cell.x);
    ASSERT_EQ(found.y, cell.y);
  }
}

TEST(Lattice, NumbersCellsRowByRow) {
  const Lattice lattice(3, 2, 1.0, {});
  EXPECT_EQ(lattice.index({2, 0}), 2u);
  EXPECT_EQ(lattice.index({0, 1}), 3u);
  for (std::size_t i = 0; i < lattice.size(); ++i) EXPECT_EQ(lattice.index(lattice.cell(i)), i);
}

TEST(Lattice, GivesPosesInItsOwnFrame) {
  Rng rng(2);
  for (int i = 0; i < 200; ++i) {
    const Lattice lattice(3, 2, 1.0, randomPose(rng, 10.0));
    const Pose2 pose = randomPose(rng, 10.0);
    ASSERT_THAT(lattice.origin() * lattice.toLattice(pose), PoseNear(pose, 1e-9, 1e-9));
  }
}

TEST(Lattice, PutsFarAndSenselessPointsOutside) {
  const Lattice lattice(10, 10, 0.05, {0.0, 0.0, 0.3});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  for (const double far : {1e12, -1e300, inf, -inf, nan}) {
    EXPECT_FALSE(lattice.contains(lattice.cellAt({far, 0.1}))) << far;
    EXPECT_FALSE(lattice.contains(lattice.cellAt({0.1, far}))) << far;
  }
}

TEST(Lattice, RefusesSizesThatAreNone) {
  EXPECT_THROW(Lattice(0, 5, 0.05, {}), std::invalid_argument);
  EXPECT_THROW(Lattice(5, -1, 0.05, {}), std::invalid_argument);
  for (const auto& [width, height] : {std::pair(68000000, 1), std::pair(1, 68000000),
                                      std::pair(50000, 50000), std::pair(2147483647, 2147483647)}) {
    EXPECT_THROW(Lattice(width, height, 0.05, {}), std::invalid_argument) << width;
  }
  EXPECT_NO_THROW(Lattice(33000000, 1, 0.05, {}));
  EXPECT_NO_THROW(Lattice(46000, 46000, 0.05, {}));
  EXPECT_THROW(Lattice(5, 5, 0.0, {}), std::invalid_argument);
  EXPECT_THROW(Lattice(5, 5, std::nan(""), {}), std::invalid_argument);
  EXPECT_THROW(Lattice(5, 5, 0.05, {std::nan(""), 0.0, 0.0}), std::invalid_argument);
}

}  // namespace
}  // namespace adaptive_localization
