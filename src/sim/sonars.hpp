// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "adaptive_localization/core/observations.hpp"
#include "adaptive_localization/core/options.hpp"
#include "adaptive_localization/core/pose2.hpp"
#include "adaptive_localization/core/rng.hpp"

namespace adaptive_localization {

/// The sixteen sonars of a Pioneer 3-DX.
struct SonarsOptions {
  bool sonars{false};
  double sonar_view{0.524};
  double sonar_min_range{0.1};
  double sonar_max_range{5.0};
  double sonar_noise{0.01};
  double sonar_mirror_angle{0.524};
  double sonar_cross_talk{0.03};
  double sonar_period{0.04};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("sonars", sonars, "The robot has sonars.");
    option("sonar_view", sonar_view, Range{0.01, kPi}, "rad", "Angle of a sonar's cone.");
    option("sonar_min_range", sonar_min_range, Range{0, 1}, "m",
           "What is nearer is heard at this range.");
    option("sonar_max_range", sonar_max_range, Range{0.5, 20}, "m", "Farther there is no echo.");
    option("sonar_noise", sonar_noise, Range{0, 1}, "m",
           "Standard deviation of a range; 1 % of the range comes on top.");
    option("sonar_mirror_angle", sonar_mirror_angle, Range{0.01, kPi / 2.0}, "rad",
           "A surface turned away from a ray by more than this mirrors its sound away.");
    option("sonar_cross_talk", sonar_cross_talk, kProbability, "",
           "Share of pings in which another sonar's ping is heard, at any range.");
    option("sonar_period", sonar_period, Range{0.01, 10}, "s",
           "Time between two pings of the front's sonars, and of the back's beside them.");
  }
};

/// What a sonar heard of its ping.
struct Ping {
  double stamp{0.0};     // s
  std::size_t sonar{0};  // which one
  double range{0.0};     // m; infinity: no echo
};

/// Each ping is heard as rays are that fill its cone. What turns away from its ray mirrors it to
/// somewhere else, once, from where it may come back and reads too long. Else the nearest counts.
class Sonars {
 public:
  /// The true range of a ray (map frame), max_range if it meets nothing.
  using Caster = std::function<double(const Pose2& T_map_ray, double max_range)>;

  static constexpr std::size_t kCount = 16;

  /// Where they are on a Pioneer 3-DX (ARIA's p3dx-sh.p): T_base_sonar.
  static const std::array<Pose2, kCount>& mounts();

  Sonars(const SonarsOptions& options, Rng rng) : options_(options), rng_(rng) {}

  /// The next sonar of the front and the next one of the back ping, from a pose of base.
  std::vector<Ping> ping(double stamp, const Pose2& T_map_base, const Caster& cast);

  SonarReading reading(const Ping& ping) const;

 private:
  double listen(const Pose2& T_map_sonar, const Caster& cast);
  std::optional<double> echo(const Pose2& T_map_ray, double limit, const Caster& cast) const;

  SonarsOptions options_;
  Rng rng_;
  std::size_t next_{0};
};

}  // namespace adaptive_localization
