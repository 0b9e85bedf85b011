// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/particle/kidnap_test.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "adaptive_localization/map/ray_caster.hpp"

namespace adaptive_localization {
namespace {

constexpr Eigen::Index kRays = 60;  // are enough for a mean
constexpr std::size_t kPlaces = 5;  // looked at again with those

class KidnapTest : public Exploration {
 public:
  KidnapTest(const KidnapOptions& options, std::shared_ptr<const OccupancyGrid> map,
             FindElsewhere find)
      : options_(options), ray_caster_(std::move(map)), find_(std::move(find)) {}

  void reset() override {
    armed_ = explained_before_ = false;
    unexplained_ = 0;
    share_ = 0.0;
  }

  bool observe(const Evidence& evidence) override {
    const Scan& scan = evidence.observations.scan;
    share_ = 0.0;
    if (scan.hits() == 0) return true;
    armed_ = armed_ || isConverged(evidence);
    const double here = meanError(evidence.best, scan);
    if (!(here > options_.kidnap_mean_abs_error)) {
      explained_before_ = true;
      unexplained_ = 0;
      return true;
    }
    ++unexplained_;
    if (armed_ && unexplained_ >= options_.kidnap_confirm_scans &&
        isElsewhere(evidence.observations, here)) {
      share_ = 1.0 - options_.local_share;
    }
    return share_ > 0.0 || !explained_before_ || here < coveredError();
  }

  double share() const override { return share_; }

  void explored() override { share_ = 0.0; }

 private:
  bool isConverged(const Evidence& evidence) const {
    const bool is_narrow =
        options_.kidnap_arm_spread == 0.0 || evidence.spread < options_.kidnap_arm_spread;
    const bool are_few =
        options_.kidnap_arm_particles == 0 || evidence.particles < options_.kidnap_arm_particles;
    return is_narrow && are_few;
  }

  bool isElsewhere(const Observations& observations, double here) const {
    if (options_.kidnap_margin == 0.0) return true;
    const std::vector<Pose2> places = find_(observations);
    return std::any_of(places.begin(), places.begin() + std::min(places.size(), kPlaces),
                       [&](const Pose2& place) {
                         return meanError(place, observations.scan) < here - options_.kidnap_margin;
                       });
  }

  /// Half-way from an error that is too large to that of a scan in which every beam is wrong.
  double coveredError() const {
    if (options_.kidnap_margin == 0.0) return std::numeric_limits<double>::infinity();
    return 0.5 * (options_.kidnap_mean_abs_error + options_.kidnap_truncation);
  }

  double meanError(const Pose2& T_map_base, const Scan& scan) const {
    const Eigen::Vector2d start = T_map_base * scan.position;
    const Eigen::Index hits = scan.range.size();
    const Eigen::Index beams = hits + scan.no_return_bearing.size();
    const Eigen::Index step = std::max<Eigen::Index>(1, beams / kRays);
    double sum = 0.0;
    int count = 0;
    for (Eigen::Index j = 0; j < beams; j += step, ++count) {
      const float bearing = j < hits ? scan.bearing[j] : scan.no_return_bearing[j - hits];
      const double z = j < hits ? static_cast<double>(scan.range[j]) : scan.max_range;
      const Pose2 ray{start.x(), start.y(), T_map_base.theta + static_cast<double>(bearing)};
      const double error = std::abs(ray_caster_.range(ray, scan.max_range) - z);
      sum += error < options_.kidnap_truncation ? error : options_.kidnap_truncation;
    }
    return sum / std::max(1, count);
  }

  KidnapOptions options_;
  RayCaster ray_caster_;
  FindElsewhere find_;
  bool armed_{false};
  bool explained_before_{false};
  int unexplained_{0};  // scans in a row
  double share_{0.0};
};

}  // namespace

std::unique_ptr<Exploration> kidnapTest(const KidnapOptions& options,
                                        std::shared_ptr<const OccupancyGrid> map,
                                        FindElsewhere find) {
  return std::make_unique<KidnapTest>(options, std::move(map), std::move(find));
}

}  // namespace adaptive_localization
