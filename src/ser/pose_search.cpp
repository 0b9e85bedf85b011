// SPDX-License-Identifier: BSD-3-Clause
#include "pose_search.hpp"

#include <utility>

#include "core/parallel.hpp"
#include "range_blocks.hpp"
#include "range_kernel.hpp"

namespace adaptive_localization {
namespace {

constexpr int kHeadingsPerGroup = 3;
constexpr std::size_t kBlocksAtOnce = 128;
constexpr SearchWork kSortedPerPose = 8;

const RangeKernel kSumOfDistances = fastestSumOfDistances();

}  // namespace

PoseSearch::PoseSearch(std::shared_ptr<const RangeTable> table, const DirectionalScan& scan,
                       const PoseSearchLimits& limits)
    : table_(std::move(table)),
      groups_(scan, kHeadingsPerGroup),
      targets_(scan, 1),
      limits_(limits),
      best_(limits.margin, limits.greatest),
      starts_(bucketOf(limits.greatest) + 2, 0) {}

bool PoseSearch::advance(SearchWork& left) {
  return bound(left) && sort(left) && visit(left);
}

bool PoseSearch::bound(SearchWork& left) {
  const RangeBlocks& blocks = table_->blocks();
  const auto per_block = static_cast<std::size_t>(groups_.size());
  std::vector<std::uint16_t> bounds(bounded_ < blocks.size() ? kBlocksAtOnce * per_block : 0);
  while (bounded_ < blocks.size() && left > 0) {
    const std::size_t count = std::min(kBlocksAtOnce, blocks.size() - bounded_);
    bounds.resize(count * per_block);
    parallelFor(count, 32, [&](const Chunk& chunk) {
      for (std::size_t k = chunk.begin; k < chunk.end; ++k) {
        const std::size_t block = bounded_ + k;
        for (int g = 0; g < groups_.size(); ++g) {
          bounds[k * per_block + static_cast<std::size_t>(g)] = static_cast<std::uint16_t>(
              kSumOfDistances(blocks.low(block), blocks.high(block), groups_.of(g),
                              limits_.truncation, limits_.greatest));
        }
      }
    });
    keep(bounded_, bounds);
    bounded_ += count;
    left -= static_cast<SearchWork>(bounds.size());
  }
  return bounded_ == blocks.size();
}

void PoseSearch::keep(std::size_t first_block, const std::vector<std::uint16_t>& bounds) {
  const std::size_t first = first_block * static_cast<std::size_t>(groups_.size());
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    if (bounds[i] > limits_.greatest) continue;
    nodes_.push_back({static_cast<std::uint32_t>(first + i), bounds[i]});
    ++starts_[bucketOf(bounds[i]) + 1];
  }
}

/// A counting sort: the number of nodes in each bucket is known.
bool PoseSearch::sort(SearchWork& left) {
  if (sorted_.size() != nodes_.size()) {
    for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
    sorted_.resize(nodes_.size());
  }
  for (; placed_ < nodes_.size(); ++placed_) {
    if (left <= 0) return false;
    const Node& node = nodes_[placed_];
    sorted_[starts_[bucketOf(node.bound)]++] = node;
    if (placed_ % kSortedPerPose == 0) --left;
  }
  return true;
}

bool PoseSearch::visit(SearchWork& left) {
  for (; next_ < sorted_.size(); ++next_) {
    const Node& node = sorted_[next_];
    const bool is_bucket_worse = bucketOf(node.bound) > bucketOf(best_.limit());
    if (is_bucket_worse || visited_ >= limits_.most_visits) return true;
    if (node.bound > best_.limit()) continue;
    if (left <= 0) return false;
    const std::size_t before = visited_;
    visit(node);
    left -= static_cast<SearchWork>(visited_ - before);
  }
  return true;
}

/// Each heading alone has a bound that is closer than the group's.
void PoseSearch::visit(const Node& node) {
  const RangeBlocks& blocks = table_->blocks();
  const auto groups = static_cast<std::uint32_t>(groups_.size());
  const std::size_t block = node.index / groups;
  const int first = static_cast<int>(node.index % groups) * kHeadingsPerGroup;
  for (int d = first; d < first + kHeadingsPerGroup; ++d) {
    const RangeTarget& target = targets_.of(d);
    const auto sumAt = [&](const std::uint8_t* low, const std::uint8_t* high) {
      return kSumOfDistances(low, high, target, limits_.truncation, best_.limit());
    };
    ++visited_;
    if (sumAt(blocks.low(block), blocks.high(block)) > best_.limit()) continue;
    for (const std::uint32_t* cell = blocks.begin(block); cell != blocks.end(block); ++cell) {
      const std::uint8_t* ranges = table_->ranges(*cell);
      best_.add({*cell, d, sumAt(ranges, ranges)});
      ++visited_;
    }
  }
}

}  // namespace adaptive_localization
