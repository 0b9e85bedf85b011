// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "last_minute.hpp"

namespace adaptive_localization {

/// How many of a machine's cores a process keeps busy: its processor time, of all threads, over
/// real time, in the last minute.
class ProcessorShare {
 public:
  /// Both times in s since whenever; to be called about once a second.
  void add(double now, double processor_time) { readings_.add(now, {now, processor_time}); }

  /// 1 for one core; 0 before there are two readings.
  double at(double now) const {
    std::optional<Reading> first;
    Reading last;
    readings_.visit(now, [&](const Reading& reading) {
      if (!first) first = reading;
      last = reading;
    });
    const double seconds = first ? last.time - first->time : 0.0;
    return seconds > 0.0 ? (last.processor_time - first->processor_time) / seconds : 0.0;
  }

 private:
  struct Reading {
    double time{0.0};
    double processor_time{0.0};
  };

  LastMinute<Reading> readings_{100};
};

}  // namespace adaptive_localization
