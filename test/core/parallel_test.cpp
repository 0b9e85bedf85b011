// SPDX-License-Identifier: BSD-3-Clause
#include "core/parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <set>
#include <thread>
#include <tuple>
#include <vector>

namespace adaptive_localization {
namespace {

class ParallelFor : public testing::TestWithParam<int> {
 protected:
  void SetUp() override { setThreads(GetParam()); }
  void TearDown() override { setThreads(1); }
};

TEST_P(ParallelFor, VisitsEveryIndexExactlyOnce) {
  for (const std::size_t count : std::vector<std::size_t>{0, 1, 63, 64, 65, 1000, 4096}) {
    std::vector<std::atomic<int>> visits(count);
    parallelFor(count, 64, [&](const Chunk& chunk) {
      for (std::size_t i = chunk.begin; i < chunk.end; ++i) ++visits[i];
    });
    for (std::size_t i = 0; i < count; ++i) ASSERT_EQ(visits[i], 1) << i << " of " << count;
  }
}

TEST_P(ParallelFor, CutsTheSameChunksForAnyNumberOfThreads) {
  std::mutex mutex;
  std::set<std::tuple<std::size_t, std::size_t, std::size_t>> chunks;
  parallelFor(10, 4, [&](const Chunk& chunk) {
    const std::lock_guard<std::mutex> lock(mutex);
    chunks.insert({chunk.index, chunk.begin, chunk.end});
  });
  const decltype(chunks) expected{{0, 0, 4}, {1, 4, 8}, {2, 8, 10}};
  EXPECT_EQ(chunks, expected);
}

/// As when an option changes while an energy grid is being made: this used to crash.
TEST(ParallelForInTwoThreads, OutlivesAnotherNumberOfThreads) {
  std::atomic<bool> done{false};
  std::thread changes([&] {
    for (int count = 1; !done; count = count % 4 + 1) setThreads(count);
  });
  std::atomic<std::size_t> visited{0};
  for (int loop = 0; loop < 2000; ++loop) {
    parallelFor(1000, 10, [&](const Chunk& chunk) { visited += chunk.end - chunk.begin; });
  }
  done = true;
  changes.join();
  setThreads(1);
  EXPECT_EQ(visited, 2000U * 1000U);
}

INSTANTIATE_TEST_SUITE_P(Threads, ParallelFor, testing::Values(1, 2, 4));

}  // namespace
}  // namespace adaptive_localization
