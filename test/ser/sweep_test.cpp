// SPDX-License-Identifier: BSD-3-Clause
#include "ser/sweep.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "ser_toys.hpp"

namespace adaptive_localization {
namespace {

constexpr float kScale = 3.0F;

/// What a sweep is to tell of one cell, by following its own digital line.
int traced(const SweepMap& map, const SweepDirection& direction, int t, int v) {
  const DigitalLine own(direction.slope, nearestBundle(t, direction.slope), map.lines());
  const double length = std::sqrt(1.0 + direction.slope * direction.slope);
  const auto line = [&](int at) {
    return map.obstacles(direction.sense > 0 ? at : map.lines() - 1 - at);
  };
  float seen = std::numeric_limits<float>::infinity();
  int steps = 0;
  for (; t < map.lines() - 1 && v >= 0 && v < map.length(); ++t, ++steps) {
    const LineStep step = own.stepAfter(t);
    const std::uint8_t* side = step.side_is_on_this_line ? line(t) + step.shift : line(t + 1);
    if (step.shift != 0 && side[v] != 0) {
      seen = step.to_side;
    } else if (line(t + 1)[v + step.shift] != 0) {
      seen = step.to_next;
    }
    if (std::isfinite(seen)) break;
    v += step.shift;
  }
  while (steps-- > 0) seen += static_cast<float>(length);
  const float offset = static_cast<float>(0.5 * length) * kScale + 0.5F;
  return static_cast<int>(std::min(seen * kScale + offset, 255.0F));
}

/// Rooms on a map of which most is unknown.
MapPtr rooms(Rng& rng, int width, int height) {
  std::vector<std::int8_t> cells(static_cast<std::size_t>(width * height), OccupancyGrid::kUnknown);
  for (int room = 0; room < 5; ++room) {
    const int x = static_cast<int>(rng.below(static_cast<std::uint64_t>(width)));
    const int y = static_cast<int>(rng.below(static_cast<std::uint64_t>(height)));
    for (int dy = 0; dy < 12 && y + dy < height; ++dy) {
      for (int dx = 0; dx < 20 && x + dx < width; ++dx) {
        cells[static_cast<std::size_t>((y + dy) * width + x + dx)] =
            rng.below(12) == 0 ? OccupancyGrid::kOccupied : OccupancyGrid::kFree;
      }
    }
  }
  return std::make_shared<const OccupancyGrid>(Lattice(width, height, 0.1, {}), std::move(cells));
}

bool isAsked(const SweepMap& map, int u, int v) {
  return (map.askedBits(u)[v / 64] >> (v % 64) & 1) != 0;
}

/// Number of cells asked for; swept in strips of some lines.
int compare(const SweepMap& map, const SweepDirection& direction, int strip) {
  Sweep sweep(map, direction, kScale);
  std::vector<std::uint8_t> ranges(static_cast<std::size_t>(strip * map.length()));
  int compared = 0;
  for (int done = 0; done < map.lines(); done += strip) {
    const int count = std::min(strip, map.lines() - done);
    const int first = direction.sense > 0 ? map.lines() - done - count : done;
    sweep.advance(first, first + count, ranges.data());
    const std::uint8_t* line = ranges.data();
    for (int u = first; u < first + count; ++u) {
      if (!map.isAskedFor(u)) continue;
      const int t = direction.sense > 0 ? u : map.lines() - 1 - u;
      for (int v = 0; v < map.length(); ++v) {
        if (!isAsked(map, u, v)) continue;
        EXPECT_EQ(int{line[v]}, traced(map, direction, t, v)) << u << ' ' << v;
        ++compared;
      }
      line += map.length();
    }
  }
  return compared;
}

TEST(Sweep, TellsOfEachCellWhatItsOwnLineMeets) {
  Rng rng(1);
  int compared = 0;
  for (const int side : {1, 33, 64, 140, 256, 257, 288, 300, 319, 320, 321, 400}) {
    for (int n = 0; n < 12; ++n) {
      const int other = 1 + static_cast<int>(rng.below(140));
      const bool is_wide = rng.below(2) == 0;
      const MapPtr map = rooms(rng, is_wide ? side : other, is_wide ? other : side);
      const bool lines_are_columns = rng.below(2) == 0;
      const int spacing = 1 + static_cast<int>(rng.below(3));
      const SweepMap lines(*map, map->known(), lines_are_columns, spacing);
      const double slopes[] = {0.0, 1.0, -1.0, rng.uniform(-1.0, 1.0)};
      const SweepDirection direction{rng.below(2) == 0 ? 1 : -1, slopes[rng.below(4)]};
      compared += compare(lines, direction, 1 + static_cast<int>(rng.below(50)));
      if (HasFailure()) FAIL() << side << " by " << other << ", spacing " << spacing;
    }
  }
  EXPECT_GT(compared, 10000);
}

TEST(Sweep, LooksAtLittleOfAMapOfWhichLittleIsKnown) {
  constexpr int kSide = 640;
  std::vector<std::int8_t> cells(kSide * kSide, OccupancyGrid::kUnknown);
  const auto put = [&](int x, int y, std::int8_t value) {
    cells[static_cast<std::size_t>(y * kSide + x)] = value;
  };
  for (const int corner : {0, kSide - 20}) {  // two closed rooms at the ends of a diagonal
    for (int i = 0; i < 20 * 20; ++i) {
      const int x = i % 20, y = i / 20;
      const bool is_wall = x == 0 || y == 0 || x == 19 || y == 19;
      put(corner + x, corner + y, is_wall ? OccupancyGrid::kOccupied : OccupancyGrid::kFree);
    }
  }
  const OccupancyGrid map(Lattice(kSide, kSide, 0.1, {}), cells);
  const SweepMap lines(map, map.known(), true, 1);
  for (int bundle = 0; bundle < kBundles; ++bundle) {
    const BeamPaths paths(lines, {1, 0.3}, bundle, DigitalLine(0.3, bundle, kSide));
    int looked_at = 0, on_lines = 0;
    for (int t = 0; t < kSide; ++t) {
      bool is_any = false;
      paths.forEachRun(t, [&](int first, int end) {
        EXPECT_LT(first, end);
        EXPECT_LE(end, kSide);
        looked_at += end - first;
        is_any = true;
      });
      if (is_any) ++on_lines;
    }
    EXPECT_GE(on_lines, 2 * 12) << "lines with free cells, but for a few where others begin";
    EXPECT_LE(on_lines, 2 * 18);
    EXPECT_LE(looked_at, 40 * 64) << "of " << kSide * kSide;
  }
}

}  // namespace
}  // namespace adaptive_localization
