// SPDX-License-Identifier: BSD-3-Clause
#include "latency.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace adaptive_localization {
namespace {

constexpr double kAhead = 0.1;    // s; a simulated clock may come a little after what it dates
constexpr double kBehind = 10.0;  // s; as far as tf remembers

double quantile(std::vector<double>& values, double share) {
  const auto count = static_cast<double>(values.size());
  const auto rank = static_cast<std::ptrdiff_t>(std::ceil(share * count));
  const auto place = values.begin() + std::max<std::ptrdiff_t>(rank - 1, 0);
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

Latency::Figures figuresOf(std::vector<double>& values) {
  if (values.empty()) return {};
  return {quantile(values, 0.5), quantile(values, 0.99), quantile(values, 1.0)};
}

}  // namespace

void Latency::add(double sent, double from_stamp, double from_arrival) {
  delays_.add(sent, {sent - from_arrival, from_stamp, from_arrival});
}

Latency::Minute Latency::lastMinute(double now) const {
  Minute minute;
  std::vector<double> from_stamp, from_arrival;
  double first = now, last = 0.0;
  delays_.visit(now, [&](const Delay& delay) {
    ++minute.scans;
    if (delay.from_stamp < -kAhead) ++minute.from_future;
    if (delay.from_stamp > kBehind) ++minute.from_past;
    from_stamp.push_back(delay.from_stamp);
    from_arrival.push_back(delay.from_arrival);
    first = std::min(first, delay.arrival);
    last = std::max(last, delay.arrival);
  });
  minute.from_stamp = figuresOf(from_stamp);
  minute.from_arrival = figuresOf(from_arrival);
  if (minute.scans > 1) minute.period = (last - first) / (minute.scans - 1);
  return minute;
}

}  // namespace adaptive_localization
