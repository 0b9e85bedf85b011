// SPDX-License-Identifier: BSD-3-Clause
#include "ros/free_memory.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cmath>
#include <fstream>
#include <string>
#include <vector>

namespace adaptive_localization {
namespace {

TEST(FreeMemory, IsWhatMachineAndLimitLeave) {
  const double before = freeMemory();
  EXPECT_GT(before, 1e6);
  EXPECT_TRUE(std::isfinite(before));  // on Linux
  rlimit old{};
  ASSERT_EQ(getrlimit(RLIMIT_AS, &old), 0);
  rlimit limited = old;
  limited.rlim_cur = 1000000000;
  ASSERT_EQ(setrlimit(RLIMIT_AS, &limited), 0);
  const double left = freeMemory();
  ASSERT_EQ(setrlimit(RLIMIT_AS, &old), 0);
  EXPECT_LT(left, 1e9);
  EXPECT_LE(left, before + 1e8);
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // they have their own malloc
constexpr std::size_t kMap = 24 << 20, kPart = 16 << 20;             // bytes

/// Of this process, without files.
double residentBytes() {
  std::ifstream status("/proc/self/status");
  for (std::string key, rest; status >> key && std::getline(status, rest);) {
    if (key == "RssAnon:") return 1024.0 * std::stod(rest);
  }
  return -1.0;
}

TEST(FreeMemory, IsAsBeforeWhenALargeBlockIsFreed) {
  returnFreedBlocks();
  std::vector<char>(kMap, 'm');  // glibc alone would keep all smaller ones from now on
  const double before = residentBytes();
  std::vector<char> part(kPart, 'p');
  const std::vector<char> behind_it(1000, 's');
  EXPECT_GT(residentBytes(), before + 0.9 * kPart);
  std::vector<char>().swap(part);
  EXPECT_LT(residentBytes(), before + 0.1 * kPart);
}
#endif

}  // namespace
}  // namespace adaptive_localization
