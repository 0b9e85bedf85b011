// SPDX-License-Identifier: BSD-3-Clause
// The laws of what sonars tell of a map, for each of the models.
#include "map/evidence_grid.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "map/evidence_models.hpp"

namespace adaptive_localization {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double kNone = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kView = 0.4;
constexpr double kCell = 0.05;

EvidenceOptions withAllReadings() {
  EvidenceOptions options;
  options.evidence_reach = 100.0;
  return options;
}

/// 9 m by 6 m; the origin is the middle of a cell.
Lattice field() {
  return Lattice(181, 121, kCell, {-60.5 * kCell, -60.5 * kCell, 0.0});
}

SonarReading heard(double range, double bearing = 0.0) {
  return {0, {0.0, 0.0, bearing}, range, 4.0, kView};
}

class EvidenceModel : public testing::TestWithParam<std::string> {
 protected:
  std::unique_ptr<EvidenceGrid> make(const EvidenceOptions& options = withAllReadings()) const {
    return makeEvidenceGrid(GetParam(), field(), options);
  }

  /// A cell's probability after one reading, less 1/2; the cell's middle is just there.
  double told(double range, double distance, double bearing = 0.0) const {
    const auto grid = make();
    const double across = distance - kCell * std::round(distance / kCell);
    grid->add({-across, 0.0, 0.0}, heard(range, -bearing));
    return at(*grid, distance - across, 0.0);
  }

  static double at(const EvidenceGrid& grid, double x, double y) {
    return grid.probability(grid.lattice().cellAt({x, y})) - 0.5;
  }
};

INSTANTIATE_TEST_SUITE_P(All, EvidenceModel, testing::ValuesIn(evidenceModels()),
                         [](const auto& test) {
                           std::string name = test.param;
                           name.erase(std::remove(name.begin(), name.end(), '-'), name.end());
                           return name;
                         });

TEST_P(EvidenceModel, KnowsNothingAtFirst) {
  const auto grid = make();
  EXPECT_EQ(at(*grid, 1.0, 0.0), 0.0);
  EXPECT_EQ(at(*grid, -100.0, 0.0), 0.0);
  const OccupancyGrid map = grid->toOccupancyGrid();
  EXPECT_EQ(map.cells(), std::vector<std::int8_t>(map.lattice().size(), OccupancyGrid::kUnknown));
}

TEST_P(EvidenceModel, IsFreeBeforeTheArcAndOccupiedOnIt) {
  for (const double range : {1.0, 2.0, 3.0}) {
    for (double distance = 0.1; distance < 0.9 * range; distance += 0.07) {
      EXPECT_LT(told(range, distance), 0.0) << distance << " of " << range;
    }
    EXPECT_GT(told(range, range), 0.0) << range;
    for (double behind = 0.0; behind < 0.25; behind += 0.01) {
      EXPECT_GE(told(range, range + behind), 0.0) << behind << " behind " << range;
    }
    EXPECT_EQ(told(range, range + 0.25), 0.0) << "nothing is told of what is behind " << range;
  }
}

TEST_P(EvidenceModel, TellsMostOnTheAxisAndNothingOutsideTheCone) {
  for (const double distance : {1.0, 2.0}) {
    const double sign = distance < 2.0 ? -1.0 : 1.0;
    double last = sign * told(2.0, distance);
    for (const double bearing : {0.06, 0.12, 0.18}) {
      const double there = sign * told(2.0, distance, bearing);
      EXPECT_GT(there, 0.0);
      EXPECT_LT(there, last) << bearing;
      EXPECT_NEAR(there, sign * told(2.0, distance, -bearing), 1e-3);
      last = there;
    }
    EXPECT_EQ(told(2.0, distance, 0.21), 0.0);
    EXPECT_EQ(told(2.0, distance, kPi), 0.0);
  }
}

TEST_P(EvidenceModel, TellsLessFartherAway) {
  EXPECT_GT(told(1.0, 1.0), told(2.0, 2.0));
  EXPECT_GT(told(2.0, 2.0), told(3.0, 3.0));
  EXPECT_LT(told(3.0, 0.5), told(3.0, 1.5));
  EXPECT_LT(told(3.0, 1.5), told(3.0, 2.5));
}

TEST_P(EvidenceModel, TakesNoEchoForAFreeConeButWeakly) {
  for (const double distance : {0.5, 1.5, 2.5}) {
    EXPECT_LT(told(kNone, distance), 0.0);
    EXPECT_GT(told(kNone, distance), 0.1 * told(3.0, distance)) << distance;
    EXPECT_EQ(told(kNone, distance), told(4.0, distance)) << "none is heard from max_range on";
  }
  EXPECT_EQ(told(kNone, 4.1), 0.0);
  EvidenceOptions options;
  options.evidence_no_echo = 0.0;
  const auto grid = make(options);
  grid->add({}, heard(kNone));
  EXPECT_EQ(at(*grid, 0.5, 0.0), 0.0);
}

TEST_P(EvidenceModel, LeavesOutLongReadingsAndNonsense) {
  EvidenceOptions options;
  options.evidence_reach = 1.5;
  const auto grid = make(options);
  grid->add({}, heard(1.6));
  for (const double range : {-1.0, kNan}) grid->add({}, heard(range));
  grid->add({kNan, 0.0, 0.0}, heard(1.0));
  for (const double max_range : {0.0, -1.0, kNan, kNone}) {
    grid->add({}, {0, {}, 1.0, max_range, kView});
  }
  for (const double view : {0.0, -1.0, kNan, 4.0}) grid->add({}, {0, {}, 1.0, 4.0, view});
  EXPECT_EQ(at(*grid, 0.5, 0.0), 0.0);
  EXPECT_EQ(at(*grid, 1.0, 0.0), 0.0);
  grid->add({}, heard(1.4));
  EXPECT_LT(at(*grid, 0.5, 0.0), 0.0);
}

/// Wherever the sonar is and whichever way it points, a cone over the map's edge or outside too.
TEST_P(EvidenceModel, IsTheSameFromEverySide) {
  const auto grid = make();
  const auto turned = make();
  grid->add({}, heard(1.0));
  turned->add({1.0, 1.0, kPi / 2.0}, heard(1.0));
  for (int i = 1; i < 26; ++i) {  // at the sonar itself there is no bearing
    for (int j = -10; j <= 10; ++j) {
      const double along = i * kCell, across = j * kCell;
      EXPECT_NEAR(at(*grid, along, across), at(*turned, 1.0 - across, 1.0 + along), 1e-9);
    }
  }
  grid->add({100.0, 0.0, 0.0}, heard(1.0));
  grid->add({-3.0, -3.0, -2.0}, heard(3.9));
  EXPECT_EQ(at(*grid, -2.9, -2.9), 0.0);
}

TEST_P(EvidenceModel, FindsAWallThatIsPassed) {
  const auto grid = make();
  for (double x = -1.0; x < 2.0; x += 0.02) grid->add({x, 0.0, 0.0}, heard(1.0, kPi / 2.0));
  const OccupancyGrid map = grid->toOccupancyGrid();
  const auto cell = [&](double x, double y) { return map.lattice().cellAt({x, y}); };
  EXPECT_TRUE(map.isOccupied(cell(0.5, 1.0)));
  EXPECT_TRUE(map.isFree(cell(0.5, 0.5)));
  EXPECT_FALSE(map.isOccupied(cell(0.5, 1.5)) || map.isFree(cell(0.5, 1.5)));
}

TEST_P(EvidenceModel, StaysAProbability) {
  const auto grid = make();
  for (int i = 0; i < 3000; ++i) {
    grid->add({}, heard(i % 3 == 0 ? 2.0 : 1.0, 0.01 * (i % 50)));
  }
  for (std::size_t i = 0; i < grid->lattice().size(); ++i) {
    const double probability = grid->probability(grid->lattice().cell(i));
    ASSERT_TRUE(probability >= 0.0 && probability <= 1.0) << probability;
  }
}

/// How likely a cell of a wall is still, less 1/2, after it was passed and then seen through.
double afterMirroredReadings(const std::string& model) {
  const auto grid = makeEvidenceGrid(model, field(), withAllReadings());
  for (double x = -1.0; x < 1.0; x += 0.02) grid->add({x, 0.0, 0.0}, heard(1.0, kPi / 2.0));
  for (int i = 0; i < 40; ++i) grid->add({0.0, 0.0, 0.0}, heard(2.5, kPi / 2.0));
  return grid->probability(grid->lattice().cellAt({0.0, 1.0})) - 0.5;
}

TEST(EvidenceModels, KonoligesForgivesReadingsThatAreTooLong) {
  EXPECT_GT(afterMirroredReadings("konolige"), 0.15);
  EXPECT_LT(afterMirroredReadings("elfes"), -0.15);
  EXPECT_LT(afterMirroredReadings("moravec-elfes"), -0.15);
}

TEST(EvidenceModels, KonoligesTakesReadingsFromOnePlaceForOne) {
  const auto after = [](int count) {
    const auto grid = makeEvidenceGrid("konolige", field(), withAllReadings());
    for (int i = 0; i < count; ++i) grid->add({}, heard(2.5));
    const double p = grid->probability(grid->lattice().cellAt({1.0, 0.0}));
    return std::log(p / (1.0 - p));
  };
  EXPECT_LT(after(1), 0.0);
  EXPECT_NEAR(after(2) / after(1), 1.1, 1e-9);
  EXPECT_NEAR(after(6) / after(1), 1.5, 1e-9);
  EXPECT_NEAR(after(1000), -4.0, 1e-9);  // so that it can be overruled
  const auto grid = makeEvidenceGrid("konolige", field(), withAllReadings());
  grid->add({}, heard(2.5));
  grid->add({2.0, 0.0, kPi}, heard(2.5));
  const double p = grid->probability(grid->lattice().cellAt({1.0, 0.0}));
  EXPECT_NEAR(std::log(p / (1.0 - p)) / after(1), 2.0, 1e-9);  // from the other side
}

TEST(EvidenceModels, ElfesAddsUpInAnyOrder) {
  const std::vector<SonarReading> readings{heard(1.0), heard(1.1, 0.1), heard(2.0), heard(kNone),
                                           heard(0.9, -0.2)};
  const auto forward = makeEvidenceGrid("elfes", field(), withAllReadings());
  const auto backward = makeEvidenceGrid("elfes", field(), withAllReadings());
  for (const auto& reading : readings) forward->add({}, reading);
  for (auto it = readings.rbegin(); it != readings.rend(); ++it) backward->add({}, *it);
  for (std::size_t i = 0; i < field().size(); ++i) {
    const Cell cell = field().cell(i);
    EXPECT_NEAR(forward->probability(cell), backward->probability(cell), 1e-12);
  }
}

/// One echo comes of one thing: what an arc is given in all is less than one.
TEST(EvidenceModels, MoravecAndElfesShareAnEchoOutOverItsArc) {
  for (const double range : {1.0, 2.0}) {
    const auto grid = makeEvidenceGrid("moravec-elfes", field(), withAllReadings());
    grid->add({}, heard(range));
    double sum = 0.0;
    for (std::size_t i = 0; i < field().size(); ++i) {
      sum += std::max(0.0, 2.0 * grid->probability(field().cell(i)) - 1.0);
    }
    EXPECT_NEAR(sum, 1.0, 1e-9);
  }
}

TEST(EvidenceModels, RefusesAnotherName) {
  EXPECT_THAT([] { makeEvidenceGrid("bayes", field()); },
              ThrowsMessage<std::invalid_argument>(
                  HasSubstr("got 'bayes', expected one of moravec-elfes, elfes, konolige")));
}

}  // namespace
}  // namespace adaptive_localization
