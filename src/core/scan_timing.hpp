// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "adaptive_localization/core/options.hpp"

namespace adaptive_localization {

/// What is wrong with the stamps of scans.
struct ScanTiming {
  double scan_time_offset{0.0};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("scan_time_offset", scan_time_offset, Range{-10, 10}, "s",
           "Added to the stamps of scans: negative for drivers that stamp late, positive for those "
           "that stamp early.");
  }
};

}  // namespace adaptive_localization
