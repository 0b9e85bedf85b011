// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/map/sparse_grid.hpp"

#include <sys/mman.h>

#include <algorithm>
#include <new>

namespace adaptive_localization {
namespace {

std::size_t bytesFor(std::size_t tiles) {
  return tiles * SparseGrid::kTileSize * sizeof(std::uint16_t);
}

std::size_t tilesFor(int cells, int side) {
  return static_cast<std::size_t>((cells + side - 1) / side);
}

/// Pages that the system makes when they are written to. Huge ones would hold hundreds of tiles.
std::uint16_t* pages(std::size_t bytes) {
  void* memory = mmap(nullptr, bytes, PROT_READ | PROT_WRITE,
                      MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (memory == MAP_FAILED) throw std::bad_alloc();
  madvise(memory, bytes, MADV_NOHUGEPAGE);
  return static_cast<std::uint16_t*>(memory);
}

}  // namespace

SparseGrid::SparseGrid(int columns, int rows)
    : stride_(static_cast<int>(tilesFor(columns, kTileColumns)) * kTileColumns),
      is_written_(tilesFor(columns, kTileColumns) * tilesFor(rows, kTileRows), 0) {
  values_ = {pages(bytesFor(tiles())), Unmap{bytesFor(tiles())}};
}

SparseGrid::SparseGrid(const SparseGrid& other)
    : stride_(other.stride_),
      is_written_(other.is_written_),
      values_(pages(bytesFor(tiles())), Unmap{bytesFor(tiles())}) {
  for (std::size_t number = 0; number < tiles(); ++number) {
    if (isWritten(number)) std::copy_n(other.tile(number), kTileSize, write(number));
  }
}

void SparseGrid::Unmap::operator()(std::uint16_t* values) const {
  munmap(values, bytes);
}

}  // namespace adaptive_localization
