// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>

#include "swarm/swarm_move.hpp"

namespace adaptive_localization {

/// What a swarm's iterations cost, in ranges looked up in a table. Measured: such a range takes
/// 1.7 ns; the prices are the ratios of the other times to this one.
class SwarmPrice {
 public:
  /// With so many beams looked up, or cast, and leaders that each bat looks at.
  SwarmPrice(int beams, bool is_cast, const std::optional<LeaderOptions>& leaders);

  /// Of one iteration of one searcher among so many.
  double ofOne(Eigen::Index searchers) const;

  /// So many of the searchers, 2 at the least, as a budget lets fly kRounds iterations.
  Eigen::Index affordable(Eigen::Index searchers, double budget) const;

  static constexpr double kRounds = 10.0;

 private:
  double beams_;
  std::optional<LeaderOptions> leaders_;
};

}  // namespace adaptive_localization
