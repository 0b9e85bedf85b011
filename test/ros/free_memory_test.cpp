// SPDX-License-Identifier: BSD-3-Clause
#include "ros/free_memory.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cmath>

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

}  // namespace
}  // namespace adaptive_localization
