// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "best_poses.hpp"
#include "scan_targets.hpp"
#include "ser/range_table.hpp"
#include "ser/search_pose.hpp"

namespace adaptive_localization {

/// What a search of a range table leaves out. Costs and errors in steps of the table.
struct PoseSearchLimits {
  int truncation{1};          // of the error of one range
  int margin{0};              // above the best cost
  int greatest{0};            // cost
  std::size_t most_visits{};  // poses looked at
};

/// A search of GlobalSearch in parts: first the bounds of all blocks and groups of headings, which
/// are then sorted, and looked into in the order of their bounds: roughly, and where bounds are
/// much the same block after block, which has its ranges in the processor's cache for all of its
/// headings.
class PoseSearch {
 public:
  PoseSearch(std::shared_ptr<const RangeTable> table, const DirectionalScan& scan,
             const PoseSearchLimits& limits);

  /// Goes on for as much work as is left; whether all is done.
  bool advance(SearchWork& left);

  /// Best first.
  std::vector<SearchPose> takePoses() { return best_.sorted(); }

  std::size_t visited() const { return visited_; }

 private:
  static constexpr int kBucket = 64;  // bounds from one multiple of this to the next

  struct Node {
    std::uint32_t index;  // block * groups + group
    std::uint16_t bound;  // of the cost of its poses
  };

  static std::size_t bucketOf(int bound) { return static_cast<std::size_t>(bound / kBucket); }
  bool bound(SearchWork& left);
  void keep(std::size_t first_block, const std::vector<std::uint16_t>& bounds);
  bool sort(SearchWork& left);
  bool visit(SearchWork& left);
  void visit(const Node& node);

  std::shared_ptr<const RangeTable> table_;
  ScanTargets groups_, targets_;
  PoseSearchLimits limits_;
  BestPoses best_;
  std::size_t bounded_{0};             // blocks whose bounds are known
  std::vector<Node> nodes_;            // those that can have a pose
  std::vector<std::uint32_t> starts_;  // of each bucket's nodes, once sorted
  std::size_t placed_{0};              // nodes, among the
  std::vector<Node> sorted_;           // by buckets, and there by blocks
  std::size_t next_{0};                // in that order
  std::size_t visited_{0};
};

}  // namespace adaptive_localization
