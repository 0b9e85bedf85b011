// SPDX-License-Identifier: BSD-3-Clause
#include "eval/map_score.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace adaptive_localization {
namespace {

/// Whether something holds for a cell or one of the eight around it.
template <class Predicate>
bool isNear(const Cell& cell, const Predicate& holds) {
  for (int y = cell.y - 1; y <= cell.y + 1; ++y) {
    for (int x = cell.x - 1; x <= cell.x + 1; ++x) {
      if (holds(Cell{x, y})) return true;
    }
  }
  return false;
}

double entropyOf(double p) {
  const auto term = [](double share) { return share > 0.0 ? -share * std::log2(share) : 0.0; };
  return term(p) + term(1.0 - p);
}

double ratio(std::size_t part, std::size_t whole) {
  return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0.0;
}

/// The share of the occupied cells of a map that are near one of another.
double shareNear(const OccupancyGrid& map, const OccupancyGrid& other) {
  std::size_t occupied = 0, near = 0;
  for (std::size_t i = 0; i < map.lattice().size(); ++i) {
    const Cell cell = map.lattice().cell(i);
    if (!map.isOccupied(cell)) continue;
    ++occupied;
    near += isNear(cell, [&](const Cell& beside) { return other.isOccupied(beside); }) ? 1 : 0;
  }
  return ratio(near, occupied);
}

}  // namespace

OccupancyGrid surfacesOn(const Lattice& lattice, const OccupancyGrid& truth) {
  std::vector<std::int8_t> cells(lattice.size(), OccupancyGrid::kUnknown);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Cell cell = truth.lattice().cellAt(lattice.centre(lattice.cell(i)));
    if (truth.isFree(cell)) cells[i] = OccupancyGrid::kFree;
  }
  for (std::size_t i = 0; i < truth.lattice().size(); ++i) {
    const Cell cell = truth.lattice().cell(i);
    if (!truth.isOccupied(cell)) continue;
    const Cell at = lattice.cellAt(truth.lattice().centre(cell));
    if (!lattice.contains(at)) continue;
    const bool is_surface = isNear(cell, [&](const Cell& beside) { return truth.isFree(beside); });
    std::int8_t& value = cells[lattice.index(at)];
    if (is_surface) {
      value = OccupancyGrid::kOccupied;
    } else if (value == OccupancyGrid::kFree) {
      value = OccupancyGrid::kUnknown;
    }
  }
  return OccupancyGrid(lattice, std::move(cells));
}

MapScore scoreOf(const EvidenceGrid& made, const OccupancyGrid& surfaces) {
  if (!(made.lattice() == surfaces.lattice())) {
    throw std::invalid_argument("the true map has another lattice than the map that was made");
  }
  const OccupancyGrid map = made.toOccupancyGrid();
  MapScore score;
  std::size_t known = 0, correct = 0;
  for (std::size_t i = 0; i < surfaces.lattice().size(); ++i) {
    const Cell cell = surfaces.lattice().cell(i);
    const bool is_occupied = surfaces.isOccupied(cell);
    if (!is_occupied && !surfaces.isFree(cell)) continue;
    ++score.cells;
    score.entropy += entropyOf(made.probability(cell));
    known += map.isOccupied(cell) || map.isFree(cell) ? 1 : 0;
    correct += (is_occupied ? map.isOccupied(cell) : map.isFree(cell)) ? 1 : 0;
  }
  if (score.cells == 0) throw std::invalid_argument("the true map knows of no cell here");
  score.entropy /= static_cast<double>(score.cells);
  score.known_share = ratio(known, score.cells);
  score.correct_share = ratio(correct, score.cells);
  score.precision = shareNear(map, surfaces);
  score.recall = shareNear(surfaces, map);
  const double sum = score.precision + score.recall;
  score.f_score = sum > 0.0 ? 2.0 * score.precision * score.recall / sum : 0.0;
  return score;
}

}  // namespace adaptive_localization
