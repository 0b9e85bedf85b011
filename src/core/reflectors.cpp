// SPDX-License-Identifier: BSD-3-Clause
#include "core/reflectors.hpp"

#include <algorithm>
#include <cmath>

#include "core/beam_reader.hpp"

namespace adaptive_localization {
namespace {

constexpr double kRangeDeviation = 0.05;  // m
constexpr double kStep = 0.2;             // m, of range, from one beam to the next of a reflector

/// Beams of a scan, and which of them are bright.
class BrightBeams {
 public:
  BrightBeams(const LaserScan& scan, const LaserMount& mount, const ScanOptions& options,
              const BaseVelocity& velocity)
      : scan_(scan), least_(options.reflector_intensity), reader_(scan, mount, options, velocity) {}

  bool isBright(std::size_t i) const {
    return scan_.intensities[i] >= least_ && std::isfinite(read(i).range);
  }
  /// Of the run of bright ones that begins here.
  std::size_t endOfRun(std::size_t i) const {
    while (++i < scan_.ranges.size() && isBright(i)) {
      if (!(std::abs(scan_.ranges[i] - scan_.ranges[i - 1]) < kStep)) break;
    }
    return i;
  }

  Sighting sighting(std::size_t first, std::size_t end) const {
    Eigen::Vector2d sum(0.0, 0.0);
    for (std::size_t i = first; i < end; ++i) sum += read(i).point;
    const auto count = static_cast<double>(end - first);
    const Eigen::Vector2d point = sum / count;
    Sighting sighting;
    sighting.range = point.norm();
    sighting.bearing = std::atan2(point.y(), point.x());
    sighting.range_deviation = kRangeDeviation;
    const double increment = std::max(std::abs(scan_.angle_increment), 1e-4);
    sighting.bearing_deviation = std::max(1.0, 0.5 * count) * increment;
    return sighting;
  }

 private:
  BeamReader::Beam read(std::size_t i) const { return reader_.read(static_cast<Eigen::Index>(i)); }

  const LaserScan& scan_;
  double least_;
  BeamReader reader_;
};

}  // namespace

void addReflectors(const LaserScan& scan, const LaserMount& mount, const ScanOptions& options,
                   const BaseVelocity& velocity, Observations& observations) {
  if (!(options.reflector_intensity > 0.0)) return;
  if (scan.intensities.size() != scan.ranges.size()) return;
  if (!observations.landmarks) observations.landmarks.emplace();
  const BrightBeams beams(scan, mount, options, velocity);
  for (std::size_t i = 0; i < scan.ranges.size();) {
    if (!beams.isBright(i)) {
      ++i;
      continue;
    }
    const std::size_t end = beams.endOfRun(i);
    observations.landmarks->push_back(beams.sighting(i, end));
    i = end;
  }
}

}  // namespace adaptive_localization
