// SPDX-License-Identifier: BSD-3-Clause
#include "../../src/ser/grid_cache.hpp"

#include <gmock/gmock.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "ser/places.hpp"
#include "ser_toys.hpp"
#include "support/temp_folder.hpp"

namespace adaptive_localization {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Files in a folder whose names start so, sorted.
std::vector<std::string> filesIn(const std::string& folder, const std::string& start = "") {
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().filename().string().rfind(start, 0) == 0) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string contentsOf(const std::string& file) {
  std::ostringstream contents;
  contents << std::ifstream(file, std::ios::binary).rdbuf();
  return contents.str();
}

class GridCacheTest : public testing::Test {
 protected:
  struct Made {
    std::shared_ptr<const EnergyGrid> grid;
    std::vector<std::string> warnings;
    bool was_read;
  };
  Made make(const EnergyGridOptions& options = {}, int spacing = 1,
            const ScanGeometry& geometry = halfCircle()) const {
    GridCache cache(folder_, *map_);
    auto grid = cache.grid(cache.ranges(10.0, spacing), geometry, options);
    return {std::move(grid), cache.warnings(), cache.hadAll()};
  }

  void expectSame(const EnergyGrid& a, const EnergyGrid& b) const {
    ASSERT_EQ(a.size(), b.size());
    ASSERT_EQ(a.bytes(), b.bytes());
    EXPECT_EQ(a.ranges().spacing(), b.ranges().spacing());
    EXPECT_EQ(a.ranges().maxRange(), b.ranges().maxRange());
    for (std::size_t i = 0; i < a.size(); i += 11) {
      const Pose2 p = a.pose(i), q = b.pose(i);
      ASSERT_TRUE(p.x == q.x && p.y == q.y && p.theta == q.theta);
      ASSERT_EQ(a.energy(i), b.energy(i));
    }
    for (std::size_t i = 0; i < a.ranges().size(); ++i) {
      ASSERT_EQ(std::memcmp(a.ranges().ranges(i), b.ranges().ranges(i), kRangeStride), 0);
    }
    Rng rng(1);
    const DirectionalScan scan = randomScan(rng, 91);
    const auto found = searchOn(std::make_shared<const EnergyGrid>(a), map_)->findPoses(scan);
    const auto again = searchOn(std::make_shared<const EnergyGrid>(b), map_)->findPoses(scan);
    ASSERT_EQ(found.size(), again.size());
    for (std::size_t i = 0; i < found.size(); ++i) ASSERT_EQ(found[i].cell, again[i].cell);
  }

  /// What is said when a file of the cache has these contents; the file is put right.
  void expectComplaint(const std::string& file, const std::string& contents,
                       const std::string& complaint) const {
    const std::string right = contentsOf(file);
    std::ofstream(file, std::ios::binary) << contents;
    const Made made = make();
    EXPECT_THAT(made.warnings,
                ElementsAre(AllOf(HasSubstr(file), HasSubstr(complaint), HasSubstr("made anew"))));
    expectSame(*made.grid, *gridOf(map_));
    EXPECT_EQ(contentsOf(file), right) << "rewritten";
    EXPECT_THAT(make().warnings, IsEmpty());
  }

  TempFolder temp_;
  std::string folder_ = temp_.file("deep/cache");
  MapPtr map_ = smallRoom({1.0, 2.0, 0.5});
};

TEST_F(GridCacheTest, GivesWhatItWasGiven) {
  for (const int spacing : {1, 2}) {
    const Made first = make({}, spacing), second = make({}, spacing);
    EXPECT_THAT(first.warnings, IsEmpty());
    EXPECT_THAT(second.warnings, IsEmpty());
    EXPECT_FALSE(first.was_read);
    EXPECT_TRUE(second.was_read);
    EXPECT_EQ(second.grid->ranges().spacing(), spacing);
    expectSame(*first.grid, *second.grid);
  }
  EXPECT_EQ(filesIn(folder_).size(), 4U) << "and nothing unfinished";
}

TEST_F(GridCacheTest, KeepsWhatItGaveWhenTheFilesGo) {
  make();
  const Made read = make();
  fs::remove_all(folder_);
  expectSame(*read.grid, *gridOf(map_));
}

TEST_F(GridCacheTest, TellsApartAllThatMattersAndNothingElse) {
  make();
  const MapPtr original = map_;
  const auto isMade = [&](const EnergyGridOptions& options = {}, int spacing = 1) {
    return !make(options, spacing).was_read;
  };
  EnergyGridOptions other;
  other.ser_delta = 0.1;
  EXPECT_FALSE(isMade(other)) << "only for questions";
  other.energy_beams = 20;
  EXPECT_TRUE(isMade(other));
  other.energy_orientations = 10;
  EXPECT_TRUE(isMade(other));
  EXPECT_TRUE(isMade({}, 2));
  map_ = smallRoom();
  EXPECT_TRUE(isMade()) << "origin";
  map_ = toyWorld({"...", "..."}, 0.2, {1.0, 2.0, 0.5});
  EXPECT_TRUE(isMade());
  std::vector<std::int8_t> cells = original->cells();
  cells[100] = cells[100] == 0 ? 100 : 0;
  map_ = std::make_shared<const OccupancyGrid>(original->lattice(), cells);
  EXPECT_TRUE(isMade()) << "one cell";
  map_ = original;
  ScanGeometry wide = halfCircle();
  wide.count = 120;
  EXPECT_FALSE(make({}, 1, wide).was_read);
  ScanGeometry turned = halfCircle();
  turned.first = 7;
  turned.position.x() = 0.3;
  make();  // it may have had to go
  const Made same = make({}, 1, turned);
  EXPECT_TRUE(same.was_read) << "energies are those of the laser, wherever it sits";
  EXPECT_TRUE(same.grid->geometry() == turned);
  EXPECT_EQ(GridCache(folder_, *map_).ranges(5.0, 1)->maxRange(), 5.0);
}

TEST_F(GridCacheTest, MakesDamagedFilesAnew) {
  make();
  Rng rng(1);
  for (const std::string kind : {"ranges_", "energies_"}) {
    const std::string file = filesIn(folder_, kind).front();
    const std::string right = contentsOf(file);
    const auto changed = [&](std::size_t at, const std::string& to) {
      return std::string(right).replace(at, to.size(), to);
    };
    expectComplaint(file, "", "cut short");
    expectComplaint(file, right.substr(0, 50), "cut short");
    expectComplaint(file, right.substr(0, right.size() / 2), "cut short");
    expectComplaint(file, std::string(5000, 'x'), "not an energy grid");
    expectComplaint(file, changed(8, std::string("\1\2\3\4", 4)), "another kind of machine");
    expectComplaint(file, changed(12, std::string("\7\0\0\0", 4)), "version 7, expected 1");
    expectComplaint(file, changed(16, "otherkey"), "made from something else");
    expectComplaint(file, changed(24, std::string(64, '\xff')), "cut short");
    expectComplaint(file, changed(24, std::string(64, '\0')), "checksum");
    for (int n = 0; n < 20; ++n) {  // any bit of the largest array
      const std::size_t at = right.size() / 4 + rng.below(right.size() / 4);
      const auto flipped = static_cast<char>(right[at] ^ (1 << rng.below(8)));
      expectComplaint(file, changed(at, std::string(1, flipped)), "checksum");
    }
  }
}

TEST_F(GridCacheTest, SaysOnceThatTheFolderIsOfNoUse) {
  const std::vector<std::string> folders{temp_.write("file", "") + "/below", "/proc/self"};
  for (const std::string& folder : folders) {
    EnergyGridOptions options;
    options.cache_dir = folder;
    Places places(map_, std::make_shared<const DistanceField>(*map_), options, {});
    const Scan scan = toScan(kHalfCircle.read(map_, {1.5, 1.0, 0.0}));
    EXPECT_TRUE(places.energyGrid(scan));
    EXPECT_THAT(places.takeWarnings(), ElementsAre(AllOf(HasSubstr("cache_dir " + folder),
                                                         HasSubstr("cannot be written to"))));
  }
}

TEST_F(GridCacheTest, KeepsTheFilesUsedLastAndOthersFiles) {
  make();
  std::ofstream(folder_ + "/precious.txt") << "mine";
  const std::string precious = folder_ + "/precious.txt";
  const auto first = filesIn(folder_, "energies_");
  const auto old = fs::file_time_type::clock::now() - std::chrono::hours(1);
  for (int beams = 1; beams <= 20; ++beams) {
    EnergyGridOptions options;
    options.energy_beams = beams;
    make(options);
    for (const auto& file : filesIn(folder_, "energies_")) fs::last_write_time(file, old);
    EXPECT_TRUE(make().was_read) << "in use all the time";
  }
  EXPECT_EQ(filesIn(folder_).size(), 9U);
  EXPECT_TRUE(fs::exists(precious));
  EXPECT_TRUE(fs::exists(first.front()));
}

TEST_F(GridCacheTest, KeepsNothingWithoutAFolder) {
  folder_.clear();
  EXPECT_FALSE(make().was_read);
  EXPECT_FALSE(make().was_read);
  EXPECT_THAT(make().warnings, IsEmpty());
}

}  // namespace
}  // namespace adaptive_localization
