// SPDX-License-Identifier: BSD-3-Clause
#include "ser/scan_energy.hpp"

#include <algorithm>
#include <cmath>

namespace adaptive_localization {
namespace {

int wrapDirection(int direction) {
  return ((direction % kDirections) + kDirections) % kDirections;
}

double bearingOf(int direction, const ScanGeometry& geometry) {
  return (geometry.first + direction) * kDirectionStep + geometry.offset;
}

std::int16_t stepsOf(double range, double max_range) {
  return static_cast<std::int16_t>(
      std::min<double>(kNoReturn, std::round(range / max_range * kNoReturn)));
}

}  // namespace

bool ScanGeometry::operator==(const ScanGeometry& other) const {
  return position == other.position && max_range == other.max_range && offset == other.offset &&
         first == other.first && count == other.count && spacing == other.spacing;
}

int ScanGeometry::beams() const {
  constexpr double kTolerance = 1e-3;  // of a beam: spacings are rounded
  const double circle_or_view = count * kDirectionStep;
  return std::max(1, static_cast<int>(std::ceil(circle_or_view / spacing - kTolerance)));
}

int ScanGeometry::directionOf(int beam) const {
  return static_cast<int>(std::lround(beam * spacing / kDirectionStep));
}

double ScanGeometry::headingOf(int direction_of_beam_0) const {
  return wrapAngle((direction_of_beam_0 - first) * kDirectionStep - offset);
}

ScanGeometry geometryOf(const Scan& scan, double max_range) {
  // a driver's last digits must not make another geometry of every scan
  constexpr double kTolerance = 1e-3;  // rad
  const double offset_of_first = std::round(scan.view.start / kTolerance) * kTolerance;
  ScanGeometry geometry;
  geometry.position = scan.position;
  geometry.max_range = std::min(max_range, scan.max_range);
  geometry.first = static_cast<int>(std::floor(offset_of_first / kDirectionStep));
  geometry.offset = offset_of_first - geometry.first * kDirectionStep;
  const double steps = (scan.view.width + kTolerance) / kDirectionStep;
  geometry.count = std::clamp(static_cast<int>(std::floor(steps)) + 1, 1, kDirections);
  constexpr double kSpacingTolerance = 1e-5;  // rad: it adds up from beam to beam
  const double wider = std::max(0.0, scan.view.spacing - kDirectionStep);
  geometry.spacing = kDirectionStep + std::round(wider / kSpacingTolerance) * kSpacingTolerance;
  return geometry;
}

DirectionalScan toDirections(const Scan& scan, const ScanGeometry& geometry) {
  DirectionalScan result;
  result.range.fill(-1);
  std::array<double, kDirections> nearest;
  nearest.fill(0.5 * kDirectionStep + 1e-9);
  const double start = bearingOf(0, geometry);
  const auto take = [&](double bearing, std::int16_t range) {
    const double steps = wrapAngle(bearing - start) / kDirectionStep;
    const double whole = std::round(steps);
    const int beam = wrapDirection(static_cast<int>(whole));
    const double off = std::abs(steps - whole) * kDirectionStep;
    const auto k = static_cast<std::size_t>(beam);
    if (beam >= geometry.count || off >= nearest[k]) return;
    nearest[k] = off;
    result.range[k] = range;
  };
  for (Eigen::Index i = 0; i < scan.range.size(); ++i) {
    take(scan.bearing[i], stepsOf(scan.range[i], geometry.max_range));
  }
  for (Eigen::Index i = 0; i < scan.no_return_bearing.size(); ++i) {
    take(scan.no_return_bearing[i], kNoReturn);
  }
  result.valid = static_cast<int>(std::count_if(result.range.begin(), result.range.end(),
                                                [](std::int16_t range) { return range >= 0; }));
  return result;
}

int rangeIn(int direction, const Scan& scan, const ScanGeometry& geometry) {
  const double bearing = bearingOf(direction, geometry);
  double nearest = scan.view.spacing;
  int range = -1;
  for (Eigen::Index i = 0; i < scan.view.range.size(); ++i) {
    const double off = std::abs(wrapAngle(scan.view.bearing[i] - bearing));
    if (off >= nearest) continue;
    nearest = off;
    const float metres = scan.view.range[i];
    range = std::isnan(metres) ? -1 : stepsOf(metres, geometry.max_range);
  }
  return range;
}

}  // namespace adaptive_localization
