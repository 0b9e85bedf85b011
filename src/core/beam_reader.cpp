// SPDX-License-Identifier: BSD-3-Clause
#include "core/beam_reader.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace adaptive_localization {
namespace {

[[noreturn]] void reject(const std::string& what, double value, const std::string& expected) {
  throw std::invalid_argument("scan: " + what + " is " + std::to_string(value) + ", expected " +
                              expected);
}

void check(const LaserScan& message) {
  if (message.ranges.empty()) reject("number of beams", 0.0, "at least 1");
  if (!std::isfinite(message.angle_min)) reject("angle_min", message.angle_min, "a finite angle");
  const bool increments = std::isfinite(message.angle_increment) && message.angle_increment != 0.0;
  if (message.ranges.size() > 1 && !increments) {
    reject("angle_increment", message.angle_increment, "a finite angle other than 0");
  }
  const auto steps = static_cast<double>(message.ranges.size() - 1);
  const double last = message.angle_min + steps * message.angle_increment;
  if (steps > 0.0 && !std::isfinite(last)) reject("angle of the last beam", last, "a finite angle");
  if (!(message.range_min >= 0.0)) reject("range_min", message.range_min, "0 m or more");
  if (!(message.range_max > message.range_min)) {
    reject("range_max", message.range_max, "more than range_min");
  }
}

/// A mount that mirrors the plane (upside down) makes the last beam the rightmost.
ScanView viewOf(const LaserScan& message, const LaserMount& mount, const BeamReader& reader) {
  const auto last = static_cast<Eigen::Index>(message.ranges.size()) - 1;
  const double increment = last > 0 ? message.angle_increment : 0.0;
  const double swept = static_cast<double>(last) * increment;
  const bool mirrored = mount.axes(0, 0) * mount.axes(1, 1) < mount.axes(0, 1) * mount.axes(1, 0);
  const bool last_is_rightmost = (swept < 0.0) != mirrored;
  const double angle = message.angle_min + (last_is_rightmost ? swept : 0.0);
  const Eigen::Vector2d direction = mount.axes * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  ScanView view;
  view.start = std::atan2(direction.y(), direction.x());
  view.width = std::min(std::abs(swept), 2.0 * kPi);
  view.spacing = std::max(std::abs(increment), ScanView::kFinest);
  constexpr double kTolerance = 1e-3;  // of a spacing: increments are rounded
  const auto count = static_cast<Eigen::Index>(view.width / view.spacing + kTolerance) + 1;
  view.range.resize(count);
  view.bearing.resize(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const double steps = k == 0 ? 0.0 : static_cast<double>(k) * view.spacing / std::abs(increment);
    const Eigen::Index i = std::min<Eigen::Index>(std::lround(steps), last);
    const BeamReader::Beam beam = reader.read(last_is_rightmost ? last - i : i);
    view.range[k] = static_cast<float>(beam.range);
    view.bearing[k] = static_cast<float>(beam.bearing);
  }
  return view;
}

/// Number k of the beams used: evenly spread from the first to the last, rounded to the nearest.
Eigen::Index usedBeam(Eigen::Index k, Eigen::Index used, Eigen::Index beams) {
  return used == beams ? k : (k * (beams - 1) + (used - 1) / 2) / (used - 1);
}

}  // namespace

Scan toScan(const LaserScan& message, const LaserMount& mount, const ScanOptions& options,
            const BaseVelocity& velocity) {
  check(message);
  const BeamReader reader(message, mount, options, velocity);
  const auto beams = static_cast<Eigen::Index>(message.ranges.size());
  const Eigen::Index used = std::min<Eigen::Index>(beams, options.laser_max_beams);

  Scan scan;
  scan.position = mount.position;
  scan.max_range = reader.maxRange();
  scan.view = viewOf(message, mount, reader);
  for (auto* column : {&scan.x, &scan.y, &scan.range, &scan.bearing, &scan.no_return_bearing}) {
    column->resize(used);
  }
  Eigen::Index hits = 0;
  Eigen::Index no_returns = 0;
  for (Eigen::Index k = 0; k < used; ++k) {
    const BeamReader::Beam beam = reader.read(usedBeam(k, used, beams));
    if (std::isnan(beam.range)) {
      ++scan.invalid;
    } else if (std::isinf(beam.range)) {
      scan.no_return_bearing[no_returns++] = static_cast<float>(beam.bearing);
    } else {
      scan.x[hits] = static_cast<float>(beam.point.x());
      scan.y[hits] = static_cast<float>(beam.point.y());
      scan.range[hits] = static_cast<float>(beam.range);
      scan.bearing[hits] = static_cast<float>(beam.bearing);
      ++hits;
    }
  }
  for (auto* column : {&scan.x, &scan.y, &scan.range, &scan.bearing}) {
    column->conservativeResize(hits);
  }
  scan.no_return_bearing.conservativeResize(no_returns);
  return scan;
}

}  // namespace adaptive_localization
