// SPDX-License-Identifier: BSD-3-Clause
#include "core/background.hpp"

#include <gmock/gmock.h>

#include <atomic>
#include <memory>
#include <stdexcept>
#include <thread>
#include <vector>

namespace adaptive_localization {
namespace {

using testing::HasSubstr;

template <class T>
Outcome<T> wait(Background<T>& background) {
  while (true) {
    if (auto outcome = background.poll()) return std::move(*outcome);
    std::this_thread::yield();
  }
}

TEST(Outcome, HoldsAValueOrWhyThereIsNone) {
  EXPECT_EQ(outcomeOf([] { return 3; }).value, 3);
  const auto failed = outcomeOf([]() -> int { throw std::invalid_argument("no such map"); });
  EXPECT_FALSE(failed.value);
  EXPECT_EQ(failed.error, "no such map");
  const auto strange = outcomeOf([]() -> int { throw 42; });
  EXPECT_FALSE(strange.value);
  EXPECT_THAT(strange.error, HasSubstr("no std::exception"));
#ifndef __SANITIZE_ADDRESS__  // its operator new ends the program
  const auto large = outcomeOf([] { return std::make_unique<char[]>(SIZE_MAX / 4); });
  EXPECT_FALSE(large.value);
  EXPECT_THAT(large.error, HasSubstr("memory"));
#endif
}

TEST(Background, GivesTheValueOnce) {
  Background<int> background;
  EXPECT_FALSE(background.isRunning());
  EXPECT_FALSE(background.poll());
  background.start([](const StopToken&) { return 7; });
  EXPECT_EQ(wait(background).value, 7);
  EXPECT_FALSE(background.isRunning());
  EXPECT_FALSE(background.poll());
  background.start([](const StopToken&) { return 8; });
  EXPECT_EQ(wait(background).value, 8);
}

TEST(Background, ReturnsAFailureAsAValue) {
  Background<int> background;
  background.start([](const StopToken&) -> int { throw std::runtime_error("it rains"); });
  EXPECT_EQ(wait(background).error, "it rains");
  background.start([](const StopToken&) -> int { throw "anything"; });
  EXPECT_THAT(wait(background).error, HasSubstr("no std::exception"));
}

TEST(Background, StopsWorkThatAsks) {
  Background<int> background;
  background.start([](const StopToken& stop) -> int {
    while (true) stop.check();
  });
  EXPECT_FALSE(background.poll());
  background.stop();
  EXPECT_THAT(wait(background).error, HasSubstr("stopped"));
}

TEST(Background, EndsItsWorkBeforeItEnds) {
  std::atomic<bool> ended{false};
  {
    struct AtEnd {
      std::atomic<bool>& ended;
      ~AtEnd() { ended = true; }
    };
    Background<int> background;
    background.start([&](const StopToken& stop) -> int {
      const AtEnd at_end{ended};
      while (true) stop.check();
    });
  }
  EXPECT_TRUE(ended);
}

TEST(StopToken, OfNobodyNeverStops) {
  EXPECT_NO_THROW(StopToken().check());
}

}  // namespace
}  // namespace adaptive_localization
