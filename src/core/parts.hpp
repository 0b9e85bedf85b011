// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "core/parallel.hpp"

namespace adaptive_localization {

/// Arrays longer than kShort are worked on in parts of kPart numbers, side by side; for others
/// another thread would not pay: they are one part. Both are part of what a seed means, as they
/// tell in what order is summed.
constexpr Eigen::Index kShort = 8192;
constexpr Eigen::Index kPart = 2048;

/// Calls body(first, size) for each part of [0, count).
template <class Body>
void forEachPart(Eigen::Index count, const Body& body) {
  if (count <= kShort) {
    body(Eigen::Index{0}, count);
    return;
  }
  parallelFor(static_cast<std::size_t>(count), static_cast<std::size_t>(kPart),
              [&](const Chunk& chunk) {
                body(static_cast<Eigen::Index>(chunk.begin),
                     static_cast<Eigen::Index>(chunk.end - chunk.begin));
              });
}

/// The sum of body(first, size) over all parts, in their order; body(0, 0) if there are no numbers.
template <class Sum, class Body>
Sum sumOverParts(Eigen::Index count, const Body& body) {
  if (count <= kShort) return body(Eigen::Index{0}, count);
  std::vector<Sum> sums(static_cast<std::size_t>((count + kPart - 1) / kPart));
  forEachPart(count, [&](Eigen::Index first, Eigen::Index size) {
    sums[static_cast<std::size_t>(first / kPart)] = body(first, size);
  });
  Sum sum = std::move(sums.front());
  for (std::size_t i = 1; i < sums.size(); ++i) sum += sums[i];
  return sum;
}

}  // namespace adaptive_localization
