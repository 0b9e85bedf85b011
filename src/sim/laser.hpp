// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "adaptive_localization/core/rng.hpp"
#include "adaptive_localization/core/scan.hpp"
#include "map/landmark_map.hpp"
#include "sim/drive_base.hpp"

namespace adaptive_localization {

/// A SICK LMS-291 as the sicklms driver shows it. Where the world has reflectors, scans have
/// intensities, from 0 to 255: a beam that ends on one, by its spot of 0.0129 rad at least, is
/// bright.
struct LaserOptions {
  int lasers{1};
  int laser_beams{181};
  double laser_view{180.0};
  bool laser_interlaced{false};
  double laser_x{0.021};
  double laser_y{0.0};
  double laser_yaw{0.0};
  double laser_max_range{80.0};
  double laser_noise{0.010};
  double laser_bias{0.035};
  double laser_resolution{0.01};
  double laser_mixed{0.5};
  double laser_grazing{0.3};
  double laser_short{0.002};
  double laser_dazzle{1e-4};
  double laser_glare{5e-4};
  double laser_intensity_noise{10.0};
  double laser_latency{0.0};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("lasers", lasers, Range{0, 2}, "",
           "None: a robot without a laser. Two: the second one sits as the first, half a turn "
           "round the middle of the robot.");
    option("laser_beams", laser_beams, Range{2, 3601}, "",
           "Beams over the view; a SICK LMS has 181 or 361.");
    option("laser_view", laser_view, Range{1, 360}, "deg",
           "Angle from the first beam to the last.");
    option("laser_interlaced", laser_interlaced,
           "Alternate 181 beams from -90 and 180 beams from -89.5 degrees, 1 degree apart, as "
           "sicklms does at half-degree resolution.");
    option("laser_x", laser_x, Range{-2, 2}, "m", "The laser's place before base_link.");
    option("laser_y", laser_y, Range{-2, 2}, "m", "The same to its left.");
    option("laser_yaw", laser_yaw, Range{-kPi, kPi}, "rad", "Where the middle of its view points.");
    option("laser_max_range", laser_max_range, Range{1, 1000}, "m",
           "Farther is no return: 80, or 8 in the millimetre mode.");
    option("laser_noise", laser_noise, Range{0, 1}, "m", "Standard deviation of a range.");
    option("laser_bias", laser_bias, Range{0, 1}, "m",
           "The run's common error of all ranges is drawn from plus or minus this: as much as the "
           "data sheet allows.");
    option("laser_resolution", laser_resolution, Range{0, 1}, "m",
           "Ranges are multiples of this; 0: not rounded.");
    option("laser_mixed", laser_mixed, kProbability, "",
           "Share of beams split by an edge that return a range between its two sides.");
    option("laser_grazing", laser_grazing, kProbability, "",
           "Share of beams that meet a surface at more than 80 degrees and return nothing valid.");
    option("laser_short", laser_short, kProbability, "", "Share of random short readings.");
    option("laser_dazzle", laser_dazzle, kProbability, "", "Share of invalid readings.");
    option("laser_glare", laser_glare, kProbability, "",
           "Share of other beams that are as bright as those that end on a reflector.");
    option("laser_intensity_noise", laser_intensity_noise, Range{0, 255}, "",
           "Standard deviation of an intensity: 200 on a reflector, else 40.");
    option("laser_latency", laser_latency, Range{0, 10}, "s",
           "A scan comes, and is stamped, so long after it was taken (0.1 at 38400 baud).");
  }
};

/// T_base_laser of each laser.
std::vector<Pose2> laserMounts(const LaserOptions& options);

class Laser {
 public:
  /// The true range of a ray (map frame), max_range if it meets nothing.
  using Caster = std::function<double(const Pose2& T_map_ray, double max_range)>;

  /// Of the landmarks those that are reflectors count.
  Laser(const LaserOptions& options, const Pose2& T_base_laser, Rng rng,
        const std::vector<Landmark>& landmarks = {});

  /// The scan of a robot that is at a pose when the first beam is sent and drives on while the
  /// others are; NaN invalid, infinity no return, as sicklms gives them. What returns nothing has
  /// an intensity of 0.
  LaserScan scan(const Pose2& T_map_base, const Caster& cast, const Velocity& velocity = {});

  const Pose2& mount() const { return T_base_laser_; }

 private:
  struct Beam {
    float range;
    bool is_on_reflector{false};
  };

  Beam measure(const Pose2& T_map_ray, const Caster& cast);
  bool isOnReflector(const Pose2& T_map_ray, double range) const;
  float intensity(const Beam& beam);

  LaserOptions options_;
  Pose2 T_base_laser_;
  Rng rng_;
  Rng intensity_rng_;  // so that reflectors do not change ranges
  double bias_;
  std::vector<Landmark> reflectors_;
  bool second_half_{false};
};

}  // namespace adaptive_localization
