// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <limits>
#include <optional>

#include "adaptive_localization/core/observations.hpp"

namespace adaptive_localization {

/// What a compass and a gyroscope said lately, to be asked at the stamps of scans. Both are heard
/// in the order of their stamps.
class HeadingHistory {
 public:
  /// Keeps so much of each, s.
  explicit HeadingHistory(double kept = 60.0) : kept_(kept) {}

  struct Reading {
    double stamp;  // s
    Heading heading;
  };

  /// Throws std::invalid_argument naming what is wrong: a number that is not finite, a standard
  /// deviation that is not above 0 (it would be trusted without limit), a stamp that does not come
  /// after the last one. The reading is left out then. One that is before the last by more than a
  /// second begins anew: that one was from the future, or time was set back.
  void addHeading(double stamp, const Heading& heading);

  /// A rate in rad/s with its standard deviation. It holds until the next one; after half a second
  /// without any the sum begins anew. Throws as addHeading does.
  void addRate(double stamp, double rate, double deviation);

  /// The compass's reading at a stamp, between the ones before and after it, or else the one that
  /// is there; nothing where that is more than half a second away.
  std::optional<Reading> headingAt(double stamp) const;

  /// How far base had turned by a stamp; nothing where the gyroscope was silent for half a second.
  std::optional<GyroTurn> turnAt(double stamp) const;

  /// Stamps of the last ones; minus infinity without any.
  double lastHeading() const { return headings_.empty() ? kNever : headings_.back().stamp; }
  double lastRate() const { return rates_.empty() ? kNever : rates_.back().stamp; }

  void clear();

 private:
  static constexpr double kNever = -std::numeric_limits<double>::infinity();

  struct Rate {
    double stamp;
    double rate;    // from this stamp on, rad/s
    GyroTurn turn;  // until this stamp
  };

  double kept_;
  std::deque<Reading> headings_;
  std::deque<Rate> rates_;
};

}  // namespace adaptive_localization
