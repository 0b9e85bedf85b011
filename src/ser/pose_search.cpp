// SPDX-License-Identifier: BSD-3-Clause
#include "pose_search.hpp"

#include <utility>

#include "adaptive_localization/core/parallel.hpp"
#include "range_blocks.hpp"
#include "range_kernel.hpp"

namespace adaptive_localization {
namespace {

constexpr int kHeadingsPerGroup = 3;
constexpr std::size_t kBlocksAtOnce = 512;
constexpr SearchWork kBoundsPerPose = 4;  // which lie one after the other in memory

const RangeKernel kSumOfDistances = fastestSumOfDistances();

/// Indices of values, ascending by value; a counting sort.
std::vector<std::uint32_t> ascending(const std::vector<std::uint16_t>& values) {
  const std::uint16_t most = values.empty() ? 0 : *std::max_element(values.begin(), values.end());
  std::vector<std::uint32_t> starts(most + 2U, 0);
  for (const std::uint16_t value : values) ++starts[value + 1U];
  for (std::size_t i = 1; i < starts.size(); ++i) starts[i] += starts[i - 1];
  std::vector<std::uint32_t> order(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    order[starts[values[i]]++] = static_cast<std::uint32_t>(i);
  }
  return order;
}

}  // namespace

PoseSearch::PoseSearch(std::shared_ptr<const RangeTable> table, const DirectionalScan& scan,
                       const PoseSearchLimits& limits)
    : table_(std::move(table)),
      groups_(scan, kHeadingsPerGroup),
      targets_(scan, 1),
      limits_(limits),
      best_(limits.margin, limits.greatest) {}

bool PoseSearch::advance(SearchWork& left) {
  return bound(left) && visit(left);
}

bool PoseSearch::bound(SearchWork& left) {
  const RangeBlocks& blocks = table_->blocks();
  const auto per_block = static_cast<std::size_t>(groups_.size());
  bounds_.resize(blocks.size() * per_block);
  while (bounded_ < blocks.size() && left > 0) {
    const std::size_t count = std::min(kBlocksAtOnce, blocks.size() - bounded_);
    parallelFor(count, 128, [&](const Chunk& chunk) {
      for (std::size_t b = bounded_ + chunk.begin; b < bounded_ + chunk.end; ++b) {
        for (int g = 0; g < groups_.size(); ++g) {
          bounds_[b * per_block + static_cast<std::size_t>(g)] = static_cast<std::uint16_t>(
              kSumOfDistances(blocks.low(b), blocks.high(b), groups_.low(g), groups_.high(g),
                              limits_.truncation));
        }
      }
    });
    bounded_ += count;
    left -= static_cast<SearchWork>(count * per_block) / kBoundsPerPose;
  }
  return bounded_ == blocks.size();
}

bool PoseSearch::visit(SearchWork& left) {
  if (order_.empty()) order_ = ascending(bounds_);
  const RangeBlocks& blocks = table_->blocks();
  const auto per_block = static_cast<std::size_t>(groups_.size());
  for (; next_ < order_.size(); ++next_) {
    const std::uint32_t node = order_[next_];
    if (bounds_[node] > best_.limit() || visited_ >= limits_.most_visits) return true;
    if (left <= 0) return false;
    const std::size_t block = node / per_block;
    const int first = static_cast<int>(node % per_block) * kHeadingsPerGroup;
    const std::size_t before = visited_;
    for (const std::uint32_t* cell = blocks.begin(block); cell != blocks.end(block); ++cell) {
      const std::uint8_t* ranges = table_->ranges(*cell);
      for (int d = first; d < first + kHeadingsPerGroup; ++d) {
        best_.add({*cell, d,
                   kSumOfDistances(ranges, ranges, targets_.low(d), targets_.high(d),
                                   limits_.truncation)});
      }
      visited_ += kHeadingsPerGroup;
    }
    left -= static_cast<SearchWork>(visited_ - before);
  }
  return true;
}

}  // namespace adaptive_localization
