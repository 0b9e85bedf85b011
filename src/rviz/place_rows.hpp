// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "panel_state.hpp"

namespace adaptive_localization {

/// Which row of a list shows which place, so that none jumps away from under the mouse. Places come
/// likeliest first and stand so. While the rows are held, a place keeps its row as it moves or gets
/// likelier; one that is gone leaves its row with what it last was; new ones come after the others.
class PlaceRows {
 public:
  struct Row {
    NamedPlace place;
    bool is_there{true};  // false: gone, shown as long as the rows are held
  };

  /// At most `most` rows.
  explicit PlaceRows(std::size_t most) : most_(most) {}

  void update(const std::vector<NamedPlace>& places, bool are_held);
  const std::vector<Row>& rows() const { return rows_; }

 private:
  const std::size_t most_;
  std::vector<Row> rows_;
};

}  // namespace adaptive_localization
