// SPDX-License-Identifier: BSD-3-Clause
// The similar energy region is a region, and the robot is in it: for any laser, and for every
// preset of the cores that draw from it, however much they thin the scan.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "../ser/ser_toys.hpp"
#include "adaptive_localization/filters/builtins.hpp"

namespace adaptive_localization {
namespace {

ToyLaser laserOf(int beams, double degrees) {
  const double half = 0.5 * degrees * kPi / 180.0;
  const bool is_ring = degrees == 360.0;  // the last beam is not the first one again
  return {beams, -half, is_ring ? half - 2.0 * half / beams : half, 20.0};
}

/// A grid's energies, by cell and heading.
class EnergiesByPlace {
 public:
  explicit EnergiesByPlace(const EnergyGrid& grid)
      : lattice_(grid.ranges().lattice()),
        heading_step_(grid.headingStep()),
        of_cell_(lattice_.size()) {
    for (std::size_t i = 0; i < grid.size(); ++i) {
      const Pose2 pose = grid.pose(i);
      const Cell cell = lattice_.cellAt({pose.x, pose.y});
      of_cell_[lattice_.index(cell)].emplace_back(pose.theta, grid.energy(i));
    }
  }

  /// Whether the region of an energy has a pose within a cell and a heading step of this one.
  bool hasNear(const Pose2& pose, const ScanEnergy& energy) const {
    const Cell cell = lattice_.cellAt({pose.x, pose.y});
    for (int n = 0; n < 9; ++n) {  // walls are all round
      for (const auto& [theta, value] :
           of_cell_[lattice_.index({cell.x + n % 3 - 1, cell.y + n / 3 - 1})]) {
        if (std::abs(wrapAngle(pose.theta - theta)) <= heading_step_ &&
            std::abs(value - energy.value) < energy.delta) {
          return true;
        }
      }
    }
    return false;
  }

 private:
  const Lattice& lattice_;
  double heading_step_;
  std::vector<std::vector<std::pair<double, double>>> of_cell_;
};

/// What was counted of the regions of many scans without noise.
struct Tally {
  int scans{0};
  int without_own{0};   // of those taken at a pose of the grid: not in its region
  int without_near{0};  // of those taken between poses
  double share_sum{0.0};
  double greatest_share{0.0};

  double meanShare() const { return share_sum / (2.0 * scans); }
  void addShare(double share) {
    share_sum += share;
    greatest_share = std::max(greatest_share, share);
  }
  void add(const Tally& other) {
    scans += other.scans;
    without_own += other.without_own;
    without_near += other.without_near;
  }
};

struct Preset {
  ScanOptions scan;
  EnergyGridOptions grid;
};

std::vector<Preset> presets() {
  std::vector<Preset> all;
  for (const char* name : {"samcl", "sa_kld"}) {
    const FilterDescription& core = builtins().filters.find(name);
    for (const auto& preset : {core.recommended, core.seed}) {
      Parameters parameters;
      for (const auto& [key, value] : preset) parameters.set(key, value);
      all.push_back({parameters.read<ScanOptions>(), parameters.read<EnergyGridOptions>()});
    }
  }
  return all;
}

class SerRegion : public testing::Test {
 protected:
  Tally tallyOf(const ToyLaser& laser, const Preset& preset) {
    constexpr int kScans = 30;
    const auto scanAt = [&](const Pose2& pose) {
      return toScan(laser.read(map_, pose), LaserMount{}, preset.scan);
    };
    const ScanGeometry geometry = geometryOf(scanAt({1.0, 1.0, 0.0}), ranges_->maxRange());
    const EnergyGrid grid(ranges_, geometry, preset.grid);
    const EnergiesByPlace energies(grid);
    Rng rng(1);
    Tally tally;
    for (; tally.scans < kScans; ++tally.scans) {
      const std::size_t i = rng.below(grid.size());
      const auto own = grid.similarTo(*grid.energyOf(scanAt(grid.pose(i))));
      tally.without_own += own.begin <= i && i < own.end ? 0 : 1;
      tally.addShare(static_cast<double>(own.size()) / static_cast<double>(grid.size()));
      const Eigen::Vector3d jitter{rng.uniform(), rng.uniform(), rng.uniform()};
      const Pose2 between = grid.pose(i, jitter.array() - 0.5);
      const ScanEnergy energy = *grid.energyOf(scanAt(between));
      tally.without_near += energies.hasNear(between, energy) ? 0 : 1;
      tally.addShare(static_cast<double>(grid.similarTo(energy).size()) /
                     static_cast<double>(grid.size()));
    }
    return tally;
  }

  MapPtr map_{maze()};
  std::shared_ptr<const RangeTable> ranges_{std::make_shared<const RangeTable>(*map_, 10.0)};
};

TEST_F(SerRegion, HoldsTheTruePlaceAndLessThanAQuarterOfAllOthers) {
  Tally few, many;  // beams
  for (const double degrees : {180.0, 240.0, 270.0, 360.0}) {
    for (const int beams : {2, 3, 5, 8, 10, 15, 20, 29, 30, 31, 45, 60, 91, 181, 361, 400}) {
      for (const Preset& preset : presets()) {
        SCOPED_TRACE(testing::Message() << beams << " beams over " << degrees << " degrees, "
                                        << preset.scan.laser_max_beams << " at the most");
        const Tally tally = tallyOf(laserOf(beams, degrees), preset);
        EXPECT_LT(tally.meanShare(), 0.25);
        // what is seen all round differs less from place to place
        EXPECT_LT(tally.greatest_share, beams >= 10 && degrees < 250.0 ? 0.25 : 1.0 / 3.0);
        (beams < 20 ? few : many).add(tally);
      }
    }
  }
  EXPECT_LT(many.without_own, 0.003 * many.scans);
  EXPECT_LT(many.without_near, 0.003 * many.scans);
  // a beam of two or three that passes an edge, or the next one, changes the energy by more
  EXPECT_LT(few.without_own, 0.02 * few.scans);
  EXPECT_LT(few.without_near, 0.07 * few.scans);
}

TEST_F(SerRegion, IsTheSameHoweverMuchAScanIsThinned) {
  const ToyLaser laser = laserOf(181, 180.0);
  const LaserScan message = laser.read(map_, {0.8, 0.8, 1.0});
  ScanOptions all;
  all.laser_max_beams = 1000;
  const Scan whole = toScan(message, LaserMount{}, all);
  const EnergyGrid grid(ranges_, geometryOf(whole, 10.0), {});
  const ScanEnergy energy = *grid.energyOf(whole);
  EXPECT_EQ(energy.delta, EnergyGridOptions{}.ser_delta);
  for (int beams = 2; beams <= 181; ++beams) {
    ScanOptions options;
    options.laser_max_beams = beams;
    const Scan thinned = toScan(message, LaserMount{}, options);
    EXPECT_TRUE(geometryOf(thinned, 10.0) == grid.geometry()) << beams;
    EXPECT_EQ(grid.energyOf(thinned)->value, energy.value) << beams;
    EXPECT_EQ(grid.energyOf(thinned)->delta, energy.delta) << beams;
  }
}

/// In how many bins of some cells a side the poses of a region are.
int binsOf(const EnergyGrid& grid, const EnergyGrid::Region& region, int cells) {
  std::set<std::pair<int, int>> bins;
  for (std::size_t i = region.begin; i < region.end; ++i) {
    const Pose2 pose = grid.pose(i);
    const Cell cell = grid.ranges().lattice().cellAt({pose.x, pose.y});
    bins.insert({cell.x / cells, cell.y / cells});
  }
  return static_cast<int>(bins.size());
}

/// A. W. Li, Itajuba 2016, has regions of 206, 911 and 1690 poses of a maze like this one in 31, 65
/// and 97 bins. He speaks of 18 headings and bins of two cells, and elsewhere of ten and three.
TEST(SerOfTheSource, IsOneOfTenHeadingsAndBinsOfThreeCells) {
  EnergyGridOptions options;
  options.energy_orientations = 10;
  const auto grid = gridOf(maze(0.15), halfCircle(), options);
  for (const auto& [poses, bins] : {std::pair{206.0, 31}, {911.0, 65}, {1690.0, 97}}) {
    int alike = 0;
    for (std::size_t i = 0; i < grid->size(); i += 3) {
      const auto region = grid->similarTo({grid->energy(i), options.ser_delta});
      if (std::abs(static_cast<double>(region.size()) - poses) > 0.15 * poses) continue;
      alike += std::abs(binsOf(*grid, region, 3) - bins) <= 2 ? 1 : 0;
      EXPECT_GT(binsOf(*grid, region, 2), bins + 10);
    }
    EXPECT_GT(alike, 0) << poses;
  }
}

}  // namespace
}  // namespace adaptive_localization
