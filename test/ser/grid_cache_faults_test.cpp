// SPDX-License-Identifier: BSD-3-Clause
// Files of the cache that are whole and wrong, cut short while in use, half written, written twice.
#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <thread>

#include "../../src/ser/grid_cache.hpp"
#include "ser_toys.hpp"
#include "support/program.hpp"

namespace adaptive_localization {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kKey = 7;

/// The arrays of a file, to be changed and put back with a right checksum.
struct Contents {
  std::uint64_t key{0};
  std::vector<std::string> arrays;

  explicit Contents(const std::string& file) {
    const std::string bytes = readWhole(file);
    std::memcpy(&key, bytes.data() + 16, sizeof(key));
    std::size_t at = 128;
    for (std::size_t i = 0; i < 8; ++i) {
      std::uint64_t size = 0;
      std::memcpy(&size, bytes.data() + 24 + 8 * i, sizeof(size));
      if (size > 0) arrays.push_back(bytes.substr(at, size));
      at += (size + 63) / 64 * 64;
    }
  }

  void write(const std::string& file) const {
    std::vector<ArrayFile::Bytes> bytes;
    for (const auto& array : arrays) bytes.push_back({array.data(), array.size()});
    ArrayFile::write(file, key, bytes);
  }
};

/// A small, a large, a nearly right or any other value in place of a number; or of an array, a
/// part, more than all or another one.
void change(Contents& contents, Rng& rng) {
  std::string& array = contents.arrays[rng.below(contents.arrays.size())];
  const double kind = rng.uniform();
  if (kind < 0.8) {
    const std::size_t at = rng.below(std::max<std::size_t>(1, array.size() / 4)) * 4;
    std::uint32_t word = 0;
    std::memcpy(&word, array.data() + at, std::min<std::size_t>(4, array.size()));
    const std::uint32_t words[] = {
        0,          1,        0x7FFFFFFF, 0x80000000,
        0xFFFFFFFF, word + 1, word - 1,   static_cast<std::uint32_t>(rng.below(1U << 20))};
    word = words[rng.below(8)];
    std::memcpy(array.data() + at, &word, std::min<std::size_t>(4, array.size()));
  } else if (kind < 0.9) {
    array.resize(std::max<std::size_t>(1, rng.below(array.size()) / 4 * 4));
  } else if (kind < 0.95) {
    array.append(4 * (1 + rng.below(100)), static_cast<char>(rng.below(256)));
  } else {
    array = contents.arrays[rng.below(contents.arrays.size())];
  }
}

class GridCacheFaults : public testing::Test {
 protected:
  std::shared_ptr<const RangeTable> make(double max_range = 10.0) {
    GridCache cache(folder_, *map_);
    auto table = cache.ranges(max_range, 1);
    warnings_ = cache.warnings();
    return table;
  }

  std::string onlyFile() const { return fs::directory_iterator(folder_)->path(); }

  /// Everything in a grid of these ranges, and all that is found with it.
  void use(const std::shared_ptr<const RangeTable>& table) const {
    const auto shared =
        std::make_shared<const EnergyGrid>(table, halfCircle(), EnergyGridOptions{});
    const EnergyGrid& grid = *shared;
    const std::size_t cells = map_->countFree();
    ASSERT_EQ(grid.ranges().size(), cells);
    ASSERT_EQ(grid.size(), cells * static_cast<std::size_t>(grid.orientations()));
    for (std::size_t i = 0; i < grid.size(); ++i) {
      const Pose2 pose = grid.pose(i);
      ASSERT_TRUE(map_->isFree(map_->lattice().cellAt({pose.x, pose.y})));
      ASSERT_TRUE(grid.energy(i) >= 0.0 && grid.energy(i) <= 1.0);
    }
    for (const double energy : {0.0, 0.5, 1.0}) {
      const auto region = grid.similarTo({energy, 0.1});
      ASSERT_LE(region.begin, region.end);
      ASSERT_LE(region.end, grid.size());
    }
    Rng rng(1);
    const DirectionalScan scan = randomScan(rng, 91);
    for (const auto& pose : searchOn(shared, map_)->findPoses(scan)) ASSERT_LT(pose.cell, cells);
  }

  void writePart(const std::string& process, std::chrono::hours age) const {
    const std::string part = folder_ + "/ranges_1.ser_grid." + process + ".0.part";
    std::ofstream(part) << "half";
    fs::last_write_time(part, fs::file_time_type::clock::now() - age);
  }

  TempFolder temp_;
  std::string folder_ = temp_.file("cache");
  MapPtr map_ = smallRoom({1.0, 2.0, 0.5});
  std::vector<std::string> warnings_;
};

TEST_F(GridCacheFaults, MakesAnewWhatIsWholeButWrong) {
  make();
  Rng rng(1);
  int refused = 0;
  const std::string file = onlyFile();
  const Contents right(file);
  for (int n = 0; n < 3000; ++n) {
    Contents wrong = right;
    change(wrong, rng);
    wrong.write(file);
    const auto table = make();
    ASSERT_LE(warnings_.size(), 1U);
    if (!warnings_.empty()) {
      ++refused;
      ASSERT_THAT(warnings_[0],
                  testing::AllOf(testing::StartsWith(file), testing::EndsWith("; made anew"),
                                 testing::ContainsRegex("does not hold|is longer")));
      make();
      ASSERT_THAT(warnings_, testing::IsEmpty());
    }
    use(table);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(refused, 1000);
}

TEST_F(GridCacheFaults, DoesNotReadWhatIsLongerThanItCanBe) {
  make();
  const std::string file = onlyFile();
  fs::resize_file(file, std::uintmax_t{1} << 40);  // takes no room on the disk
  make();
  ASSERT_EQ(warnings_.size(), 1U);
  EXPECT_THAT(warnings_[0], testing::HasSubstr("longer"));
}

TEST_F(GridCacheFaults, MayBeCutShortWhileInUse) {
  make();
  const auto table = make();
  for (const auto& entry : fs::directory_iterator(folder_)) fs::resize_file(entry.path(), 0);
  use(table);
}

TEST_F(GridCacheFaults, RemovesWhatCrashedProgramsLeft) {
  fs::create_directories(folder_);
  const pid_t gone = fork();
  if (gone == 0) _exit(0);
  waitpid(gone, nullptr, 0);
  const std::string dead = std::to_string(gone);
  const std::string alive = std::to_string(getpid());
  for (int metres = 1; metres <= 8; ++metres) {
    writePart(dead, std::chrono::hours(0));
    writePart(alive, std::chrono::hours(0));
    writePart("1", std::chrono::hours(2));  // begun long ago, whoever is that process now
    make(metres);
  }
  std::map<std::string, int> files;
  for (const auto& entry : fs::directory_iterator(folder_)) {
    const std::string name = entry.path().filename();
    ++files[name.substr(name.find(".ser_grid"))];
  }
  EXPECT_EQ(files,
            (std::map<std::string, int>{{".ser_grid", 8}, {".ser_grid." + alive + ".0.part", 1}}));
}

TEST_F(GridCacheFaults, IsWrittenByManyAtOnce) {
  const std::string file = temp_.file("a.ser_grid");
  const std::vector<char> numbers(100000, 'x');
  const auto write = [&] {
    for (int n = 0; n < 100; ++n) ArrayFile::write(file, kKey, {{numbers.data(), numbers.size()}});
  };
  std::vector<pid_t> processes;
  for (int i = 0; i < 3; ++i) {
    processes.push_back(fork());
    if (processes.back() != 0) continue;
    try {
      write();
      _exit(0);
    } catch (const std::exception&) {
      _exit(1);
    }
  }
  std::vector<std::thread> threads;
  for (int i = 0; i < 3; ++i) threads.emplace_back([&] { EXPECT_NO_THROW(write()); });
  for (auto& thread : threads) thread.join();
  for (const pid_t process : processes) {
    int status = -1;
    waitpid(process, &status, 0);
    EXPECT_EQ(status, 0);
  }
  EXPECT_EQ(Contents(file).arrays, std::vector<std::string>{std::string(100000, 'x')});
}

}  // namespace
}  // namespace adaptive_localization
