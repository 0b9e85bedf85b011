// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "last_minute.hpp"

namespace adaptive_localization {

/// How late a node tells where the robot is: the time to the sending of a transform from the stamp
/// of the scan that brought it about, in the time that dates scans, and from the arrival of this
/// scan, by a clock that only goes on.
class Latency {
 public:
  /// Quantiles of times in s: the least value that is not below a share of all, the inverse of
  /// their empirical distribution (Hyndman and Fan, "Sample quantiles in statistical packages",
  /// 1996, definition 1). Values as they are, negative ones too.
  struct Figures {
    double median{0.0};
    double p99{0.0};
    double max{0.0};
  };

  /// The scans of a minute.
  struct Minute {
    int scans{0};
    int from_future{0};  // of them: stamps more than 0.1 s after the time at which they were used,
    int from_past{0};    // or more than 10 s before
    Figures from_stamp;
    Figures from_arrival;
    double period{0.0};  // s between arrivals, the mean; 0 of fewer than two scans

    /// Whether scans come faster than they are used: one of a hundred waits for the next.
    bool isLate() const { return period > 0.0 && from_arrival.p99 > period; }

    /// Whether the stamps of most are by another clock than the time they are compared with.
    bool isOtherClock() const { return 2 * (from_future + from_past) > scans; }
  };

  /// A transform was sent at a time in s of the clock that only goes on.
  void add(double sent, double from_stamp, double from_arrival);

  Minute lastMinute(double now) const;

 private:
  struct Delay {
    double arrival{0.0};
    double from_stamp{0.0};
    double from_arrival{0.0};
  };

  static constexpr std::size_t kRoom = 6000;  // scans: 100 in a second
  LastMinute<Delay> delays_{kRoom};
};

}  // namespace adaptive_localization
