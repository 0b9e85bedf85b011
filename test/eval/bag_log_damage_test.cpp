// SPDX-License-Identifier: BSD-3-Clause
// Whatever bytes of a bag are wrong, reading it ends: with a log, or saying what is wrong.
#include <dirent.h>

#include "adaptive_localization/core/rng.hpp"
#include "eval/bag_log_fixture.hpp"
#include "support/program.hpp"

namespace adaptive_localization {
namespace {

class DamagedBag : public BagLog {
 protected:
  void writeBag(rosbag::compression::CompressionType compression) const {
    BagWriter bag(request_.file, compression);
    bag.laserTransform(100.0);
    for (int i = 0; i <= 30; ++i) {
      bag.odometryTransform(100.0 + 0.1 * i, {0.1 * i, 0.0, 0.0});
      bag.odometry("/odom", 100.0 + 0.1 * i, {0.1 * i, 0.0, 0.0});
      bag.pose("/truth", 100.0 + 0.1 * i, {0.1 * i, 0.0, 0.0});
      if (i < 30) bag.scan("/scan", 100.05 + 0.1 * i);
    }
  }

  /// Reads a bag of these bytes. True: there was something to read.
  bool isRead(const std::string& bytes) {
    request_.file = folder_.write("damaged.bag", bytes);
    try {
      return !readLog(request_).scans.empty();
    } catch (const std::invalid_argument& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr(request_.file));
      return false;
    }
  }
};

/// One to four bytes that are anything, or a small, or a large number in place of four.
std::string damaged(std::string bytes, Rng& rng) {
  for (std::size_t n = 1 + rng.below(4); n > 0; --n) {
    const std::size_t at = rng.below(bytes.size() - 4);
    const double kind = rng.uniform();
    if (kind < 0.7) {
      bytes[at] = static_cast<char>(rng.below(256));
    } else {
      bytes.replace(at, 4, kind < 0.8 ? std::string(4, '\0') : std::string("\xff\xff\xff\x7f"));
    }
  }
  return bytes;
}

TEST_F(DamagedBag, IsReadOrRefused) {
  Rng rng(5);
  const std::string file = request_.file;
  for (const auto compression :
       {rosbag::compression::Uncompressed, rosbag::compression::BZ2, rosbag::compression::LZ4}) {
    request_.file = file;
    writeBag(compression);
    const std::string whole = readWhole(file);
    ASSERT_TRUE(isRead(whole));
    int read = 0;
    for (int n = 0; n < 200; ++n) read += isRead(damaged(whole, rng));
    EXPECT_GT(read, 5);
    EXPECT_LT(read, 195);
  }
}

TEST_F(DamagedBag, LeavesNoProcessAndNoFileOpen) {
  writeBag(rosbag::compression::Uncompressed);
  const std::string whole = readWhole(request_.file);
  const auto openFiles = [] {
    int count = 0;
    DIR* folder = opendir("/proc/self/fd");
    while (readdir(folder)) ++count;
    closedir(folder);
    return count;
  };
  const int before = openFiles();
  Rng rng(1);
  for (int n = 0; n < 20; ++n) isRead(damaged(whole, rng));
  EXPECT_EQ(openFiles(), before);
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1);
  EXPECT_EQ(errno, ECHILD);
}

}  // namespace
}  // namespace adaptive_localization
