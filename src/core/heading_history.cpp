// SPDX-License-Identifier: BSD-3-Clause
#include "core/heading_history.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>

#include "adaptive_localization/core/pose2.hpp"
#include "core/refusal.hpp"

namespace adaptive_localization {
namespace {

constexpr double kSilence = 0.5;  // s, after which nobody knows

template <class Readings>
void checkStamp(Readings& known, double stamp) {
  constexpr double kJump = 1.0;  // s
  if (!std::isfinite(stamp)) reject("stamp", stamp, "a number of seconds");
  if (!known.empty() && stamp < known.back().stamp - kJump) known.clear();
  if (known.empty() || stamp > known.back().stamp) return;
  std::ostringstream text;
  text.precision(17);
  text << "stamp: got " << stamp << ", expected one after the last, " << known.back().stamp;
  throw std::invalid_argument(text.str());
}

void checkReading(const std::string& what, double value, double deviation) {
  if (!std::isfinite(value)) reject(what, value, "a number");
  if (deviation > 0.0 && std::isfinite(deviation)) return;
  reject("standard deviation of a " + what, deviation, "one above 0");
}

template <class Readings>
void dropOld(double kept, Readings& readings) {
  while (readings.back().stamp - readings.front().stamp > kept) readings.pop_front();
}

/// The first one after a stamp, or the end.
template <class Readings>
auto after(const Readings& readings, double stamp) {
  return std::upper_bound(readings.begin(), readings.end(), stamp,
                          [](double at, const auto& reading) { return at < reading.stamp; });
}

}  // namespace

void HeadingHistory::addHeading(double stamp, const Heading& heading) {
  checkReading("heading", heading.theta, heading.deviation);
  checkStamp(headings_, stamp);  // which may begin anew
  headings_.push_back({stamp, {wrapAngle(heading.theta), heading.deviation}});
  dropOld(kept_, headings_);
}

void HeadingHistory::addRate(double stamp, double rate, double deviation) {
  checkReading("turn rate", rate, deviation);
  checkStamp(rates_, stamp);
  GyroTurn turn{0.0, deviation, stamp};
  if (!rates_.empty() && stamp - rates_.back().stamp <= kSilence) {
    const Rate& last = rates_.back();
    turn.angle = last.turn.angle + last.rate * (stamp - last.stamp);
    turn.since = last.turn.since;
  }
  rates_.push_back({stamp, rate, turn});
  dropOld(kept_, rates_);
}

std::optional<HeadingHistory::Reading> HeadingHistory::headingAt(double stamp) const {
  const auto next = after(headings_, stamp);
  const bool has_next = next != headings_.end() && next->stamp - stamp <= kSilence;
  const bool has_last = next != headings_.begin() && stamp - std::prev(next)->stamp <= kSilence;
  if (!has_last) return has_next ? std::make_optional(*next) : std::nullopt;
  const Reading& last = *std::prev(next);
  if (!has_next) return last;
  const double share = (stamp - last.stamp) / (next->stamp - last.stamp);
  const double turn = wrapAngle(next->heading.theta - last.heading.theta);
  return Reading{stamp,
                 {wrapAngle(last.heading.theta + share * turn),
                  std::max(last.heading.deviation, next->heading.deviation)}};
}

std::optional<GyroTurn> HeadingHistory::turnAt(double stamp) const {
  const auto next = after(rates_, stamp);
  if (next == rates_.begin() || stamp - std::prev(next)->stamp > kSilence) return std::nullopt;
  const Rate& last = *std::prev(next);
  GyroTurn turn = last.turn;
  turn.angle += last.rate * (stamp - last.stamp);
  return turn;
}

void HeadingHistory::clear() {
  headings_.clear();
  rates_.clear();
}

}  // namespace adaptive_localization
