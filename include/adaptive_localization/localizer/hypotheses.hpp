// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "adaptive_localization/core/belief.hpp"
#include "adaptive_localization/observation/composed_model.hpp"
#include "adaptive_localization/ser/ground.hpp"

namespace adaptive_localization {

/// Places where the robot may be, with log odds. They ride on the odometry, are aligned with each
/// scan, and are judged by their mean range error e against the least of all:
///
///     log odds -= w max(0, e - 1.25 u - t) / s,   u = max(e_min, usual),   s = max(s_0, u / 4)
///
/// w <= 1 is the share of the scan that is new, t what maps are off by, s_0 the error that makes a
/// place e times less likely where the map is good. Where even the best place leaves much
/// unexplained, or much is usual, a little more tells nothing; a scan that fits nowhere as well as
/// is usual may be of something that the map does not have, and says little of any place. Unlike
/// the modes of a particle cloud, masses of places that look the same do not drift: only what is
/// seen decides between them.
class Hypotheses {
 public:
  explicit Hypotheses(Ground ground, Senses senses = noSenses())
      : ground_(std::move(ground)), senses_(std::move(senses)) {}

  /// Goes on with another map and other models.
  void standOn(Ground ground, Senses senses) {
    ground_ = std::move(ground);
    senses_ = std::move(senses);
  }

  void clear() { all_.clear(); }
  bool isEmpty() const { return all_.empty(); }

  /// One more place, unless it is known or not finite.
  void add(const Pose2& T_map_base, double log_odds);

  bool knows(const Pose2& T_map_base) const;

  /// The largest log odds; 0 without a place.
  double bestOdds() const;

  /// The least mean range error of the last scan, m.
  double leastError() const { return least_error_; }

  void ride(const Pose2& motion);

  /// Aligns all with a scan and takes note of what it and the other senses say of them.
  void weigh(const Observations& observations, double share, double usual);

  /// Leaves out those that became one with a likelier one, and those too unlikely.
  void prune();

  /// Likeliest first; their masses sum up to 1.
  std::vector<Mode> modes() const;

 private:
  struct Hypothesis {
    Pose2 T_map_base;
    double log_odds{0.0};
    double error{0.0};
    bool is_new{true};  // not judged yet: a scan counts in full
  };

  /// Of each, by the senses other than the laser.
  Eigen::ArrayXd scores(const Observations& observations) const;

  Ground ground_;
  Senses senses_;
  double least_error_{0.0};
  std::vector<Hypothesis> all_;
};

}  // namespace adaptive_localization
