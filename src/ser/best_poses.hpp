// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

#include "ser/search_pose.hpp"

namespace adaptive_localization {

/// The best poses so far: those within the margin of the best, and the first kMost of them at the
/// most, so that a scan that fits everywhere does not fill the memory.
class BestPoses {
 public:
  static constexpr std::size_t kMost = 100000;

  /// Poses of more than the greatest cost are none at all.
  BestPoses(int margin, int greatest) : margin_(margin), limit_(greatest) {}

  int limit() const { return limit_; }

  void add(const SearchPose& pose) {
    if (pose.cost > limit_) return;
    poses_.push_back(pose);
    limit_ = std::min(limit_, pose.cost + margin_);
    if (poses_.size() == 2 * kMost) drop();
  }

  /// Best first, ties by cell and direction; then there are none left.
  std::vector<SearchPose> sorted() {
    drop();
    std::sort(poses_.begin(), poses_.end(), isBefore);
    return std::move(poses_);
  }

 private:
  static bool isBefore(const SearchPose& a, const SearchPose& b) {
    return std::tie(a.cost, a.cell, a.direction) < std::tie(b.cost, b.cell, b.direction);
  }

  void drop() {
    const auto worse = [this](const SearchPose& pose) { return pose.cost > limit_; };
    poses_.erase(std::remove_if(poses_.begin(), poses_.end(), worse), poses_.end());
    if (poses_.size() <= kMost) return;
    const auto last = poses_.begin() + (kMost - 1);
    std::nth_element(poses_.begin(), last, poses_.end(), isBefore);
    limit_ = last->cost;
    poses_.resize(kMost);
  }

  int margin_;
  int limit_;
  std::vector<SearchPose> poses_;
};

}  // namespace adaptive_localization
