// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace adaptive_localization {

/// A table of 16-bit values, most of which are 0. It is laid out in tiles of 64 columns and 32
/// rows, each of them one page of memory: a tile that nobody wrote to takes none. So maps of which
/// most is unknown cost what is known of them, and a value is found without looking for its tile:
///
///     index(column, row) = (row - row % 32) stride + 32 column + row % 32
class SparseGrid {
 public:
  static constexpr int kTileColumns = 64;
  static constexpr int kTileRows = 32;
  static constexpr std::size_t kTileSize = 2048;  // values

  /// All 0. Throws std::bad_alloc.
  SparseGrid(int columns, int rows);

  /// Copies what was written. Throws std::bad_alloc.
  SparseGrid(const SparseGrid& other);
  SparseGrid(SparseGrid&&) = default;
  SparseGrid& operator=(SparseGrid&&) = default;

  /// Columns, rounded up to whole tiles.
  int stride() const { return stride_; }

  std::size_t index(int column, int row) const {
    const int in_tile = row & (kTileRows - 1);
    return static_cast<std::size_t>(row - in_tile) * static_cast<std::size_t>(stride_) +
           static_cast<std::size_t>(column * kTileRows + in_tile);
  }
  std::uint16_t at(int column, int row) const { return values_[index(column, row)]; }

  const std::uint16_t* values() const { return values_.get(); }

  /// Tiles are numbered along the rows of tiles. Different tiles may be written at the same time.
  std::size_t tiles() const { return is_written_.size(); }
  bool isWritten(std::size_t tile) const { return is_written_[tile] != 0; }
  const std::uint16_t* tile(std::size_t number) const { return &values_[number * kTileSize]; }
  /// Takes memory for it.
  std::uint16_t* write(std::size_t number) {
    is_written_[number] = 1;
    return &values_[number * kTileSize];
  }
  void set(int column, int row, std::uint16_t value) {
    const std::size_t at = index(column, row);
    write(at / kTileSize)[at % kTileSize] = value;
  }

 private:
  struct Unmap {
    std::size_t bytes;
    void operator()(std::uint16_t* values) const;
  };

  int stride_;
  std::vector<std::uint8_t> is_written_;
  std::unique_ptr<std::uint16_t[], Unmap> values_;
};

}  // namespace adaptive_localization
