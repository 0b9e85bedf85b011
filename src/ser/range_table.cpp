// SPDX-License-Identifier: BSD-3-Clause
#include "ser/range_table.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <string>

#include "core/parallel.hpp"
#include "fan.hpp"
#include "numbering.hpp"
#include "range_blocks.hpp"
#include "sweep.hpp"

namespace adaptive_localization {
namespace {

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

}  // namespace

/// Sweeps some directions at a time, strip by strip of the map, and deals out to the cells what was
/// seen in a strip.
class RangeTableBuilder {
 public:
  RangeTableBuilder(const OccupancyGrid& map, double max_range, int spacing)
      : map_(map),
        box_(map.known()),
        spaced_(box_, spacing),
        spacing_(spacing),
        free_(at(0, spaced_.height(), spaced_.width())) {
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
    std::optional<SweepMap> lines;
    std::size_t done = 0;
    for (const Fan& fan : fans()) {
      const bool is_new = !lines || lines_are_columns_ != fan.is_along_x;
      lines_are_columns_ = fan.is_along_x;
      if (is_new) lines.emplace(map_, box_, lines_are_columns_, spacing_);
      sweep(*lines, fan, ranges.data(), stop);
      done += fan.count;
      if (progress) progress(done);
    }
  }

 private:
  static std::size_t at(int column, int row, int width) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(column);
  }

  /// Lines that are asked for, as numbers of the spaced box.
  struct Strip {
    int first, end;
  };

  void sweep(const SweepMap& lines, const Fan& fan, std::uint8_t* ranges, const StopToken& stop) {
    std::vector<std::optional<Sweep>> sweeps(fan.count);
    parallelFor(sweeps.size(), 1, [&](const Chunk& chunk) {
      stop.check();
      sweeps[chunk.begin].emplace(lines, fan.direction(chunk.begin), scale_);
    });
    const int count = lines_are_columns_ ? spaced_.width() : spaced_.height();
    const int strips = (count + kTile - 1) / kTile;
    plane_size_ = at(0, kTile, lines.length());
    planes_.resize(sweeps.size() * plane_size_);
    for (int n = 0; n < strips; ++n) {
      const int first = (fan.sense > 0 ? strips - 1 - n : n) * kTile;
      const Strip strip{first, std::min(first + kTile, count)};
      const int end = strip.end < count ? strip.end * spacing_ : lines.lines();
      parallelFor(sweeps.size(), 1, [&](const Chunk& chunk) {
        stop.check();
        std::uint8_t* plane = planes_.data() + chunk.begin * plane_size_;
        sweeps[chunk.begin]->advance(strip.first * spacing_, end, plane);
      });
      dealOut(strip, fan, lines.length(), ranges);
    }
  }

  /// Tile by tile, so that what is written stays in the cache.
  void dealOut(const Strip& strip, const Fan& fan, int line_length, std::uint8_t* ranges) const {
    const int length = lines_are_columns_ ? spaced_.height() : spaced_.width();
    const auto tiles = static_cast<std::size_t>((length + kTile - 1) / kTile);
    parallelFor(tiles, 1, [&](const Chunk& chunk) {
      const int first = static_cast<int>(chunk.begin) * kTile;
      for (int line = strip.first; line < strip.end; ++line) {
        const FreeCells cells = freeCells(line, first, std::min(first + kTile, length));
        for (std::size_t c = 0; c < cells.count; ++c) {
          __builtin_prefetch(ranges + cells.row[c] + fan.first, 1);
        }
        const std::uint8_t* seen = planes_.data() + at(0, line - strip.first, line_length);
        for (std::size_t c = 0; c < cells.count; ++c) {
          std::array<std::uint8_t, Fan::kMost> of_cell;
          for (std::size_t k = 0; k < fan.count; ++k) {
            of_cell[k] = seen[k * plane_size_ + cells.place[c]];
          }
          std::copy_n(of_cell.begin(), fan.count, ranges + cells.row[c] + fan.first);
        }
      }
    });
  }

  static constexpr int kTile = 32;  // lines of a strip, and cells along them

  /// The free cells of a part of a line: where on it, and where their rows of ranges begin.
  struct FreeCells {
    std::size_t count{0};
    std::array<std::size_t, kTile> place;
    std::array<std::size_t, kTile> row;
  };
  FreeCells freeCells(int line, int first, int end) const {
    const int first_place = lines_are_columns_ ? spaced_.firstY() : spaced_.firstX();
    FreeCells cells;
    for (int v = first; v < end; ++v) {
      const std::size_t cell =
          lines_are_columns_ ? at(line, v, spaced_.width()) : at(v, line, spaced_.width());
      if (!free_.isMarked(cell)) continue;
      const std::size_t c = cells.count++;
      cells.place[c] = static_cast<std::size_t>(first_place + v * spacing_);
      cells.row[c] = free_.number(cell) * kRangeStride;
    }
    return cells;
  }

  const OccupancyGrid& map_;
  CellBox box_;
  SpacedBox spaced_;
  int spacing_;
  float scale_;
  Numbering free_;  // of the spaced cells
  bool lines_are_columns_{false};
  std::vector<std::uint8_t> planes_;  // of a strip, one for each direction of a fan
  std::size_t plane_size_{0};
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
