// SPDX-License-Identifier: BSD-3-Clause
#include "ser/range_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include "core/parallel.hpp"
#include "numbering.hpp"
#include "range_blocks.hpp"
#include "sweep.hpp"

namespace adaptive_localization {
namespace {

constexpr double kPlanesMemory = 8e6;  // bytes, while a table is being made

/// Cells of a box whose lattice indices are divisible by the spacing, as a lattice of their own.
class SpacedBox {
 public:
  SpacedBox(const CellBox& box, int spacing)
      : box_(box), spacing_(spacing), first_x_(remainder(box.x)), first_y_(remainder(box.y)) {
    width_ = (box.width - first_x_ + spacing - 1) / spacing;
    height_ = (box.height - first_y_ + spacing - 1) / spacing;
  }

  int width() const { return width_; }
  int height() const { return height_; }
  int firstX() const { return first_x_; }
  int firstY() const { return first_y_; }
  Cell cell(int x, int y) const {
    return {box_.x + first_x_ + x * spacing_, box_.y + first_y_ + y * spacing_};
  }

 private:
  int remainder(int first) const { return (spacing_ - first % spacing_) % spacing_; }

  CellBox box_;
  int spacing_, first_x_, first_y_;
  int width_{0}, height_{0};
};

/// Directions in which x is the faster axis, or y.
std::vector<int> directionsWith(bool x_is_faster) {
  std::vector<int> directions;
  for (int d = 0; d < kDirections; ++d) {
    const double angle = d * kDirectionStep;
    if ((std::abs(std::cos(angle)) >= std::abs(std::sin(angle))) == x_is_faster) {
      directions.push_back(d);
    }
  }
  return directions;
}

}  // namespace

/// Sweeps a few directions at a time into planes, and deals the planes out to the cells.
class RangeTableBuilder {
 public:
  RangeTableBuilder(const OccupancyGrid& map, double max_range, int spacing)
      : map_(map),
        box_(knownCells(map)),
        spaced_(box_, spacing),
        spacing_(spacing),
        free_(planeSize()) {
    scale_ = static_cast<float>(map.lattice().resolution() / max_range * kNoReturn);
  }

  void build(std::vector<std::uint32_t>& cells, std::vector<std::uint8_t>& ranges,
             const StopToken& stop, const SweepProgress& progress) {
    for (int y = 0; y < spaced_.height(); ++y) {
      stop.check();
      for (int x = 0; x < spaced_.width(); ++x) {
        const Cell cell = spaced_.cell(x, y);
        if (!map_.isFree(cell)) continue;
        free_.mark(at(x, y, spaced_.width()));
        cells.push_back(static_cast<std::uint32_t>(map_.lattice().index(cell)));
      }
    }
    if (cells.empty()) return;
    ranges.assign(cells.size() * kRangeStride, 0);
    for (const bool x_is_faster : {true, false}) {
      sweepAll(x_is_faster, ranges.data(), stop, progress);
    }
  }

 private:
  static std::size_t at(int column, int row, int width) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(column);
  }
  std::size_t planeSize() const { return at(0, spaced_.height(), spaced_.width()); }

  void sweepAll(bool x_is_faster, std::uint8_t* ranges, const StopToken& stop,
                const SweepProgress& progress) {
    const SweepMap lines = sweepMapOf(map_, box_, x_is_faster);
    const std::vector<int> directions = directionsWith(x_is_faster);
    const auto at_once = std::clamp<std::size_t>(
        static_cast<std::size_t>(kPlanesMemory / static_cast<double>(planeSize() + 1)), 1, 32);
    std::vector<std::uint8_t> planes(at_once * planeSize());
    for (std::size_t first = 0; first < directions.size(); first += at_once) {
      const std::size_t count = std::min(at_once, directions.size() - first);
      parallelFor(count, 1, [&](const Chunk& chunk) {
        std::uint8_t* plane = planes.data() + chunk.begin * planeSize();
        sweepOne(lines, directions[first + chunk.begin], x_is_faster, plane, stop);
      });
      dealOut({directions.data() + first, count}, planes, x_is_faster, ranges);
      done_ += count;
      if (progress) progress(done_);
    }
  }

  void sweepOne(const SweepMap& lines, int direction, bool x_is_faster, std::uint8_t* plane,
                const StopToken& stop) const {
    const double angle = direction * kDirectionStep;
    const double du = x_is_faster ? std::cos(angle) : std::sin(angle);
    const double dv = x_is_faster ? std::sin(angle) : std::cos(angle);
    Sweep request;
    request.sense = du > 0.0 ? 1 : -1;
    request.slope = std::clamp(dv / std::abs(du), -1.0, 1.0);
    request.scale = scale_;
    request.spacing = spacing_;
    request.first_u = x_is_faster ? spaced_.firstX() : spaced_.firstY();
    request.first_v = x_is_faster ? spaced_.firstY() : spaced_.firstX();
    request.steps = plane;
    request.pitch = static_cast<std::size_t>(x_is_faster ? spaced_.height() : spaced_.width());
    sweep(lines, request, stop);
  }

  struct Directions {
    const int* begin;
    std::size_t count;
  };

  /// Tile by tile and there line by line of the planes, so that what is read and what is written
  /// stays in the cache.
  void dealOut(const Directions& directions, const std::vector<std::uint8_t>& planes,
               bool planes_are_columns, std::uint8_t* ranges) const {
    const int lines = planes_are_columns ? spaced_.width() : spaced_.height();
    const int length = planes_are_columns ? spaced_.height() : spaced_.width();
    const int tiles_across = (length + kTile - 1) / kTile;
    const auto tiles = static_cast<std::size_t>(tiles_across) *
                       static_cast<std::size_t>((lines + kTile - 1) / kTile);
    parallelFor(tiles, 1, [&](const Chunk& chunk) {
      const int first_line = static_cast<int>(chunk.begin) / tiles_across * kTile;
      const int first = static_cast<int>(chunk.begin) % tiles_across * kTile;
      for (int line = first_line; line < std::min(first_line + kTile, lines); ++line) {
        const FreeCells cells =
            freeCells(line, first, std::min(first + kTile, length), planes_are_columns);
        for (std::size_t k = 0; k < directions.count; ++k) {
          const std::uint8_t* seen = planes.data() + k * planeSize() + at(0, line, length);
          std::uint8_t* out = ranges + directions.begin[k];
          for (std::size_t c = 0; c < cells.count; ++c) out[cells.row[c]] = seen[cells.place[c]];
        }
      }
    });
  }

  static constexpr int kTile = 32;

  /// The free cells of a part of a line: where on it, and where their rows of ranges begin.
  struct FreeCells {
    std::size_t count{0};
    std::array<int, kTile> place;
    std::array<std::size_t, kTile> row;
  };
  FreeCells freeCells(int line, int first, int end, bool lines_are_columns) const {
    FreeCells cells;
    for (int v = first; v < end; ++v) {
      const std::size_t cell =
          lines_are_columns ? at(line, v, spaced_.width()) : at(v, line, spaced_.width());
      if (!free_.isMarked(cell)) continue;
      const std::size_t c = cells.count++;
      cells.place[c] = v;
      cells.row[c] = free_.number(cell) * kRangeStride;
    }
    return cells;
  }

  const OccupancyGrid& map_;
  CellBox box_;
  SpacedBox spaced_;
  int spacing_;
  float scale_;
  Numbering free_;       // of the spaced cells
  std::size_t done_{0};  // directions
};

RangeTable::RangeTable(const OccupancyGrid& map, double max_range, int spacing,
                       const StopToken& stop, const SweepProgress& progress)
    : lattice_(map.lattice()), max_range_(max_range), spacing_(spacing) {
  if (!(max_range > 0.0) || spacing < 1) {
    throw std::invalid_argument("range table: got max_range " + std::to_string(max_range) +
                                " and spacing " + std::to_string(spacing) +
                                ", expected a positive one and at least 1");
  }
  std::vector<std::uint32_t> cells;
  std::vector<std::uint8_t> ranges;
  for (; cells.empty() && spacing_ > 0; --spacing_) {
    RangeTableBuilder(map, max_range, spacing_).build(cells, ranges, stop, progress);
  }
  ++spacing_;
  if (cells.empty()) throw std::invalid_argument("map: got no free cell, expected at least one");
  cells_ = ConstArray<std::uint32_t>(std::move(cells));
  ranges_ = ConstArray<std::uint8_t>(std::move(ranges));
  stop.check();
  blocks_ = std::make_shared<const RangeBlocks>(lattice_, spacing_, cells_, ranges_);
}

std::size_t RangeTable::bytes() const {
  return ranges_.bytes() + cells_.bytes() + blocks_->bytes();
}

}  // namespace adaptive_localization
