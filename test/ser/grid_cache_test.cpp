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
    std::shared_ptr<const RangeTable> table;
    std::vector<std::string> warnings;
    bool was_read;
  };
  Made make(double max_range = 10.0, int spacing = 1) const {
    GridCache cache(folder_, *map_);
    auto table = cache.ranges(max_range, spacing);
    return {std::move(table), cache.warnings(), cache.hadAll()};
  }

  std::vector<SearchPose> found(const std::shared_ptr<const RangeTable>& table) const {
    Rng rng(1);
    const auto grid = std::make_shared<const EnergyGrid>(table, halfCircle(table->maxRange()),
                                                         EnergyGridOptions{});
    return searchOn(grid, map_)->findPoses(randomScan(rng, 91));
  }

  void expectSame(const std::shared_ptr<const RangeTable>& a,
                  const std::shared_ptr<const RangeTable>& b) const {
    ASSERT_EQ(a->size(), b->size());
    ASSERT_EQ(a->bytes(), b->bytes());
    EXPECT_EQ(a->spacing(), b->spacing());
    EXPECT_EQ(a->maxRange(), b->maxRange());
    for (std::size_t i = 0; i < a->size(); ++i) {
      ASSERT_EQ(a->centre(i), b->centre(i));
      ASSERT_EQ(std::memcmp(a->ranges(i), b->ranges(i), kRangeStride), 0);
    }
    const auto by_a = found(a), by_b = found(b);
    ASSERT_EQ(by_a.size(), by_b.size());
    for (std::size_t i = 0; i < by_a.size(); ++i) ASSERT_EQ(by_a[i].cell, by_b[i].cell);
  }

  /// What is said when a file of the cache has these contents; the file is put right.
  void expectComplaint(const std::string& file, const std::string& contents,
                       const std::string& complaint) const {
    const std::string right = contentsOf(file);
    std::ofstream(file, std::ios::binary) << contents;
    const Made made = make();
    EXPECT_THAT(made.warnings,
                ElementsAre(AllOf(HasSubstr(file), HasSubstr(complaint), HasSubstr("made anew"))));
    expectSame(made.table, gridOf(map_)->sharedRanges());
    EXPECT_EQ(contentsOf(file), right) << "rewritten";
    EXPECT_THAT(make().warnings, IsEmpty());
  }

  TempFolder temp_;
  std::string folder_ = temp_.file("deep/cache");
  MapPtr map_ = smallRoom({1.0, 2.0, 0.5});
};

TEST_F(GridCacheTest, GivesWhatItWasGiven) {
  for (const int spacing : {1, 2}) {
    const Made first = make(10.0, spacing), second = make(10.0, spacing);
    EXPECT_THAT(first.warnings, IsEmpty());
    EXPECT_THAT(second.warnings, IsEmpty());
    EXPECT_FALSE(first.was_read);
    EXPECT_TRUE(second.was_read);
    EXPECT_EQ(second.table->spacing(), spacing);
    expectSame(first.table, second.table);
  }
  EXPECT_EQ(filesIn(folder_).size(), 2U) << "and nothing unfinished";
}

TEST_F(GridCacheTest, KeepsWhatItGaveWhenTheFilesGo) {
  make();
  const Made read = make();
  fs::remove_all(folder_);
  expectSame(read.table, gridOf(map_)->sharedRanges());
}

TEST_F(GridCacheTest, TellsApartAllThatMattersAndNothingElse) {
  make();
  const MapPtr original = map_;
  const auto isMade = [&](double max_range = 10.0, int spacing = 1) {
    return !make(max_range, spacing).was_read;
  };
  EXPECT_FALSE(isMade());
  EXPECT_TRUE(isMade(5.0));
  EXPECT_TRUE(isMade(10.0, 2));
  map_ = smallRoom();
  EXPECT_TRUE(isMade()) << "origin";
  map_ = toyWorld({"...", "..."}, 0.2, {1.0, 2.0, 0.5});
  EXPECT_TRUE(isMade());
  std::vector<std::int8_t> cells = original->cells();
  cells[100] = cells[100] == 0 ? 100 : 0;
  map_ = std::make_shared<const OccupancyGrid>(original->lattice(), cells);
  EXPECT_TRUE(isMade()) << "one cell";
  map_ = original;
  EXPECT_FALSE(isMade());
  EXPECT_EQ(make(5.0).table->maxRange(), 5.0);
}

/// Of several lasers, or with other options of energies.
TEST_F(GridCacheTest, IsSharedByAllGeometries) {
  EnergyGridOptions options;
  options.cache_dir = folder_;
  for (const int beams : {30, 20}) {
    options.energy_beams = beams;
    Places places(map_, std::make_shared<const DistanceField>(*map_), options, {});
    for (const int count : {91, 61}) {
      const ToyLaser laser{count, -kPi / 2, kPi / 2 - (91 - count) * kDirectionStep, 20.0};
      EXPECT_TRUE(places.energyGrid(toScan(laser.read(map_, {1.5, 1.0, 0.0}))));
    }
  }
  EXPECT_EQ(filesIn(folder_).size(), 1U);
}

TEST_F(GridCacheTest, MakesDamagedFilesAnew) {
  make();
  Rng rng(1);
  const std::string file = filesIn(folder_).front();
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
  const auto first = filesIn(folder_, "ranges_");
  const auto old = fs::file_time_type::clock::now() - std::chrono::hours(1);
  for (int metres = 11; metres <= 30; ++metres) {
    make(metres);
    for (const auto& file : filesIn(folder_, "ranges_")) fs::last_write_time(file, old);
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
