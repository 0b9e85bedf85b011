// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

#include "adaptive_localization/map/sparse_grid.hpp"

namespace adaptive_localization {

/// A table of nearnesses with a border one cell wide, as a DistanceField has it, in steps.
struct NearnessView {
  const std::uint16_t* values;
  int stride;
  int columns, rows;  // without the border
  int reach;
};

/// Where the points of a base are, in cells from the centre of the first:
/// (x + c px - s py, y + s px + c py).
struct PointFrame {
  double x, y, c, s;
};

/// Points in the frame of a base, every stride-th of them.
struct PointColumns {
  const float* x;
  const float* y;
  std::ptrdiff_t count, stride;
};

/// The sum of min(distance, most) over points, in steps, each between the four cells around it. The
/// same bits from each of them.
using DistanceKernel = double (*)(const NearnessView& field, const PointFrame& frame,
                                  const PointColumns& points, double most);

double sumOfStepsPortable(const NearnessView& field, const PointFrame& frame,
                          const PointColumns& points, double most);

/// In AVX2 where the processor has it, else sumOfStepsPortable.
DistanceKernel fastestSumOfSteps();

/// The distance at one point, bilinear between the centres of four cells; the reach if it is not on
/// the map, or no number.
inline double stepsBetween(const NearnessView& field, double x, double y) {
  const int last_x = field.columns - 1, last_y = field.rows - 1;
  if (!(x > -0.5 && y > -0.5 && x < last_x + 0.5 && y < last_y + 0.5)) return field.reach;
  const auto from = [](int cell) { return cell > 0 ? cell : 0; };
  const auto upTo = [](int cell, int last) { return cell < last ? cell : last; };
  const int left = static_cast<int>(x + 1.0) - 1, low = static_cast<int>(y + 1.0) - 1;  // floors
  const int first = from(left) + 1, second = upTo(left + 1, last_x) + 1;
  const int lower = from(low) + 1, upper = upTo(low + 1, last_y) + 1;
  const auto along = [&](int row) {
    const int in_tile = row & (SparseGrid::kTileRows - 1);
    const std::uint16_t* strip =
        field.values + static_cast<std::ptrdiff_t>(row - in_tile) * field.stride + in_tile;
    const int here = field.reach - strip[std::ptrdiff_t{first} * SparseGrid::kTileRows];
    const int next = field.reach - strip[std::ptrdiff_t{second} * SparseGrid::kTileRows];
    return here + (x - left) * (next - here);
  };
  const double below = along(lower);
  return below + (y - low) * (along(upper) - below);
}

}  // namespace adaptive_localization
