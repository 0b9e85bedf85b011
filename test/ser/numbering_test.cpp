// SPDX-License-Identifier: BSD-3-Clause
#include "../../src/ser/numbering.hpp"

#include <gtest/gtest.h>

#include "adaptive_localization/core/rng.hpp"

namespace adaptive_localization {
namespace {

TEST(Numbering, NumbersWhatIsMarkedInItsOrder) {
  for (const double share : {0.0, 0.01, 0.5, 1.0}) {
    for (const std::size_t cells : {1U, 63U, 64U, 65U, 1000U}) {
      Rng rng(1);
      std::vector<bool> is_marked(cells);
      Numbering numbering(cells);
      for (std::size_t cell = 0; cell < cells; ++cell) {
        is_marked[cell] = rng.uniform() < share;
        if (is_marked[cell]) numbering.mark(cell);
      }
      std::size_t next = 0;
      for (std::size_t cell = 0; cell < cells; ++cell) {
        ASSERT_EQ(numbering.isMarked(cell), is_marked[cell]) << cell << " of " << cells;
        if (!is_marked[cell]) continue;
        ASSERT_EQ(numbering.number(cell), next) << cell << " of " << cells;
        ++next;
      }
    }
  }
}

}  // namespace
}  // namespace adaptive_localization
