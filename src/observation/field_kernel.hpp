// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "adaptive_localization/map/sparse_grid.hpp"

namespace adaptive_localization {

/// A SparseGrid with a border one cell wide; limits are those of coordinates in it. It holds values
/// or, if there is a list of those, their places in it.
struct FieldView {
  const std::uint16_t* values;
  int stride;
  float max_u, max_v;  // just below the number of columns and rows
  const std::uint16_t* list{nullptr};
};

/// Poses in the coordinates of the table, in cells: position and the axes of base.
struct PoseColumns {
  const float* u;
  const float* v;
  const float* cos;
  const float* sin;
};

/// sums[i] = sum over hits j of table(u_i + c_i x_j - s_i y_j, v_i + s_i x_j + c_i y_j), hits in
/// cells, i in [begin, end). Points outside fall on the border.
using SumKernel = void (*)(const FieldView& field, const PoseColumns& poses, std::size_t begin,
                           std::size_t end, const float* x, const float* y, int hits,
                           std::int32_t* sums);

void sumPortable(const FieldView& field, const PoseColumns& poses, std::size_t begin,
                 std::size_t end, const float* x, const float* y, int hits, std::int32_t* sums);

/// The same in AVX2 or NEON where the processor has it, else sumPortable.
SumKernel fastestSum();

/// The value at a point; u and v in cells of the bordered table. A NaN falls on the border.
inline std::uint16_t valueAt(const FieldView& field, float u, float v) {
  constexpr int kInTile = SparseGrid::kTileRows - 1;
  const float column = u > 0.0F ? (u < field.max_u ? u : field.max_u) : 0.0F;
  const float row = v > 0.0F ? (v < field.max_v ? v : field.max_v) : 0.0F;
  const int y = static_cast<int>(row);
  const std::uint16_t value =
      field.values[(y & ~kInTile) * field.stride +
                   static_cast<int>(column) * SparseGrid::kTileRows + (y & kInTile)];
  return field.list ? field.list[value] : value;
}

}  // namespace adaptive_localization
