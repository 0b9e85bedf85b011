// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace adaptive_localization {

/// Bytes on the heap through operator new since it was made; this program replaces that operator.
class HeapMeter {
 public:
  HeapMeter() : before_(inUse()) {}
  std::size_t grown() const { return inUse() - before_; }

 private:
  static std::size_t inUse();
  std::size_t before_;
};

}  // namespace adaptive_localization
