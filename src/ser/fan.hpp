// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "digital_line.hpp"

namespace adaptive_localization {

/// Neighbouring directions, which are swept together: they step along the same axis in one sense.
struct Fan {
  static constexpr std::size_t kMost = 16;
  bool is_along_x;
  int sense;
  int first;  // direction
  std::size_t count;

  SweepDirection direction(std::size_t k) const;
};

/// Of all directions of a range table, those along x first.
std::vector<Fan> fans();

}  // namespace adaptive_localization
