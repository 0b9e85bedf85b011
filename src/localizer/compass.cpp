// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/localizer/compass.hpp"

#include <algorithm>
#include <cmath>

namespace adaptive_localization {
namespace {

constexpr double kMostKnown = 1.0;    // rad, an offset's deviation at which headings tell something
constexpr double kLocal = 0.1;        // rad, deviation of what differs from place to place
constexpr double kLeast = 0.03;       // rad, of an offset, however long it was learned
constexpr double kNewWay = 0.3;       // m or rad, after which a reading is new evidence
constexpr double kDoubt = 0.6;        // of way: so long a disturbance, it is one
constexpr double kAnotherWay = 30.0;  // of way, after which another offset is the true one

double square(double value) {
  return value * value;
}

}  // namespace

Compass::Compass(const CompassOptions& options)
    : options_(options), known_{options.heading_offset, square(options.heading_offset_std)} {}

void Compass::configure(const CompassOptions& options) {
  if (options.heading_offset == options_.heading_offset &&
      options.heading_offset_std == options_.heading_offset_std) {
    return;
  }
  *this = Compass(options);
}

bool Compass::isKnown() const {
  return known_.variance < square(kMostKnown);
}

std::optional<Heading> Compass::inMap(const std::optional<Heading>& reading) const {
  if (!reading || !isKnown() || is_disturbed_) return std::nullopt;
  return Heading{wrapAngle(reading->theta + known_.offset),
                 std::sqrt(square(reading->deviation) + known_.variance)};
}

bool Compass::agree(const Belief& belief, double offset, double variance) {
  return square(wrapAngle(offset - belief.offset)) < 9.0 * (belief.variance + variance);
}

void Compass::learn(double offset, double variance, double way, Belief& belief) {
  const double share = std::min(1.0, way / kNewWay);
  const double gain = belief.variance / (belief.variance + variance / share);
  belief.offset = wrapAngle(belief.offset + gain * wrapAngle(offset - belief.offset));
  belief.variance = std::max((1.0 - gain) * belief.variance, square(kLeast));
  belief.way += way;
}

void Compass::compare(const Heading& reading, double yaw, double variance, double way) {
  if (!(way > 0.0)) return;
  const double offset = wrapAngle(yaw - reading.theta);
  variance += square(reading.deviation) + square(kLocal);
  if (agree(known_, offset, variance)) {
    learn(offset, variance, way, known_);
    doubt_ = std::max(0.0, doubt_ - way);
    if (doubt_ == 0.0) is_disturbed_ = false;
    other_.reset();
    return;
  }
  doubt_ = std::min(kDoubt, doubt_ + way);
  if (doubt_ == kDoubt) is_disturbed_ = true;
  if (!other_ || !agree(*other_, offset, variance)) other_ = Belief{offset, variance};
  learn(offset, variance, way, *other_);
  if (other_->way < kAnotherWay) return;
  known_ = *other_;
  other_.reset();
  doubt_ = 0.0;
  is_disturbed_ = false;
}

std::string Compass::state() const {
  if (is_disturbed_) return "disturbed";
  return isKnown() ? "used" : "offset not learned yet";
}

}  // namespace adaptive_localization
