// SPDX-License-Identifier: BSD-3-Clause
#include "eval/map_spoiler.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <utility>

namespace adaptive_localization {
namespace {

using Cells = std::vector<std::int8_t>;

/// A length in whole cells, one at the least: what is asked for is never nothing.
int inCells(double length, const OccupancyGrid& map) {
  return std::max(1, static_cast<int>(std::lround(length / map.lattice().resolution())));
}

/// The cells of the lattice by what `valueAt` says of each.
template <class ValueAt>
OccupancyGrid fill(const Lattice& lattice, const ValueAt& valueAt) {
  Cells cells(lattice.size());
  for (std::size_t i = 0; i < cells.size(); ++i) cells[i] = valueAt(lattice.cell(i));
  return {lattice, std::move(cells)};
}

OccupancyGrid coarsen(const OccupancyGrid& map, double size, Rng&) {
  const Lattice& fine = map.lattice();
  const int step = inCells(size, map);
  const Lattice coarse((fine.width() + step - 1) / step, (fine.height() + step - 1) / step,
                       step * fine.resolution(), fine.origin());
  return fill(coarse, [&](const Cell& cell) {
    bool is_free = false;
    for (int y = step * cell.y; y < step * (cell.y + 1); ++y) {
      for (int x = step * cell.x; x < step * (cell.x + 1); ++x) {
        if (map.isOccupied({x, y})) return OccupancyGrid::kOccupied;
        is_free = is_free || map.isFree({x, y});
      }
    }
    return is_free ? OccupancyGrid::kFree : OccupancyGrid::kUnknown;
  });
}

OccupancyGrid thicken(const OccupancyGrid& map, double depth, Rng&) {
  const Lattice& lattice = map.lattice();
  cv::Mat1b room(lattice.height(), lattice.width());
  for (std::size_t i = 0; i < lattice.size(); ++i) {
    room.data[i] = map.isOccupied(lattice.cell(i)) ? 0 : 1;
  }
  cv::Mat1f distance;
  cv::distanceTransform(room, distance, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  const float reach = static_cast<float>(inCells(depth, map)) + 1e-3F;
  return fill(lattice, [&](const Cell& cell) {
    return distance(cell.y, cell.x) <= reach ? OccupancyGrid::kOccupied : map.at(cell);
  });
}

/// About the map's middle: a map is not wrong the more, the farther away it begins.
OccupancyGrid stretch(const OccupancyGrid& map, double share, Rng&) {
  const Lattice& lattice = map.lattice();
  const int width = static_cast<int>(std::lround(lattice.width() * (1.0 + share)));
  const double ahead = 0.5 * (lattice.width() - width) * lattice.resolution();
  const Lattice longer(std::max(1, width), lattice.height(), lattice.resolution(),
                       lattice.origin() * Pose2{ahead, 0.0, 0.0});
  const double scale = static_cast<double>(lattice.width()) / longer.width();
  return fill(longer, [&](const Cell& cell) {
    return map.at({static_cast<int>(std::floor((cell.x + 0.5) * scale)), cell.y});
  });
}

/// A parabola through the map's middle, no higher than a quarter of a metre.
OccupancyGrid bend(const OccupancyGrid& map, double curvature, Rng&) {
  constexpr double kMost = 0.25;  // m
  const Lattice& lattice = map.lattice();
  const auto rise = [&](int column) {
    const double x = (column + 0.5 - 0.5 * lattice.width()) * lattice.resolution();
    return static_cast<int>(
        std::lround(std::min(kMost, 0.5 * curvature * x * x) / lattice.resolution()));
  };
  const Lattice higher(lattice.width(), lattice.height() + rise(0), lattice.resolution(),
                       lattice.origin());
  return fill(higher, [&](const Cell& cell) { return map.at({cell.x, cell.y - rise(cell.x)}); });
}

/// A box of cells.
struct Box {
  int width, height;
};

/// Boxes around random cells: within them `from` becomes `to`, until that share of all cells that
/// were `from` has changed.
template <class IsFrom, class DrawBox>
OccupancyGrid paintBoxes(const OccupancyGrid& map, double share, const IsFrom& isFrom,
                         std::int8_t to, Rng& rng, const DrawBox& drawBox) {
  const Lattice& lattice = map.lattice();
  Cells cells = map.cells();
  std::vector<bool> is_left(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) is_left[i] = isFrom(lattice.cell(i));
  auto goal =
      std::llround(share * static_cast<double>(std::count(is_left.begin(), is_left.end(), true)));
  while (goal > 0) {
    const std::size_t drawn = rng.below(cells.size());
    if (!is_left[drawn]) continue;
    const Cell middle = lattice.cell(drawn);
    const Box box = drawBox();
    for (int i = 0; i < box.width * box.height; ++i) {
      const Cell cell{middle.x + i % box.width - box.width / 2,
                      middle.y + i / box.width - box.height / 2};
      if (!lattice.contains(cell) || !is_left[lattice.index(cell)]) continue;
      is_left[lattice.index(cell)] = false;
      cells[lattice.index(cell)] = to;
      --goal;
    }
  }
  return {lattice, std::move(cells)};
}

OccupancyGrid cutGaps(const OccupancyGrid& map, double share, Rng& rng) {
  const int side = inCells(0.5, map);
  return paintBoxes(
      map, share, [&](const Cell& cell) { return map.isOccupied(cell); }, OccupancyGrid::kFree, rng,
      [&] {
        return Box{side, side};
      });
}

OccupancyGrid clutter(const OccupancyGrid& map, double share, Rng& rng) {
  const auto side = [&] { return inCells(rng.uniform(0.3, 0.8), map); };
  return paintBoxes(
      map, share, [&](const Cell& cell) { return map.isFree(cell); }, OccupancyGrid::kOccupied, rng,
      [&] {
        const int width = side();
        return Box{width, side()};
      });
}

OccupancyGrid dot(const OccupancyGrid& map, double share, Rng& rng) {
  return fill(map.lattice(), [&](const Cell& cell) {
    const bool is_gone = map.isOccupied(cell) && rng.uniform() < share;
    return is_gone ? OccupancyGrid::kUnknown : map.at(cell);
  });
}

OccupancyGrid speckle(const OccupancyGrid& map, double share, Rng& rng) {
  return fill(map.lattice(), [&](const Cell& cell) {
    if (!map.isFree(cell) || rng.uniform() >= share) return map.at(cell);
    return rng.uniform() < 0.5 ? OccupancyGrid::kOccupied : OccupancyGrid::kUnknown;
  });
}

OccupancyGrid shift(const OccupancyGrid& map, double by, Rng&) {
  const Lattice& lattice = map.lattice();
  const Pose2& origin = lattice.origin();
  return {Lattice(lattice.width(), lattice.height(), lattice.resolution(),
                  {origin.x + by, origin.y + by, origin.theta}),
          map.cells()};
}

}  // namespace

const Damages<OccupancyGrid>& mapDamages() {
  // Up to nine tenths: drawing the last cells of a kind would take long.
  static const Damages<OccupancyGrid> all{
      {{"thick", 0.2, {0.001, 10.0}, "m", "walls grow by this on every side"}, thicken},
      {{"coarse", 0.1, {0.001, 10.0}, "m", "cells of this size, walls where there was any"},
       coarsen},
      {{"gaps", 0.15, {0.0, 0.9}, "", "this share of the walls is free, in pieces of 0.5 m"},
       cutGaps},
      {{"dotted", 0.5, {0.0, 1.0}, "", "this share of the walls' cells is unknown, one by one"},
       dot},
      {{"clutter", 0.02, {0.0, 0.9}, "", "boxes of 0.3 to 0.8 m on this share of the free ground"},
       clutter},
      {{"speckle", 0.01, {0.0, 1.0}, "", "this share of the free cells is wall or unknown"},
       speckle},
      {{"shift", 0.03, {-100.0, 100.0}, "m", "the map lies this far off in x and in y"}, shift},
      {{"stretch", 0.01, {-0.5, 1.0}, "", "the map is longer in x by this share"}, stretch},
      {{"bend", 0.01, {0.0, 10.0}, "1/m", "curved sideways, by 0.25 m at the most"}, bend}};
  return all;
}

OccupancyGrid spoil(const OccupancyGrid& map, const std::string& kind, double amount,
                    std::uint64_t seed) {
  return spoilWith(mapDamages(), map, kind, amount, seed);
}

}  // namespace adaptive_localization
