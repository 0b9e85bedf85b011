// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/particle/kidnap_test.hpp"

#include <algorithm>
#include <cmath>

#include "adaptive_localization/map/ray_caster.hpp"
#include "adaptive_localization/particle/usual_error.hpp"

namespace adaptive_localization {
namespace {

constexpr Eigen::Index kRays = 60;  // are enough for a mean
constexpr std::size_t kPlaces = 5;  // looked at again with those
constexpr int kScansPerSearch = 3;  // as long as nothing is found: a search is dear
constexpr double kCovered = 0.7;    // share of beams that are too short

/// How well a scan fits a pose.
struct Fit {
  double error;  // mean, truncated, m
  double short_share;
};

class KidnapTest : public Exploration {
 public:
  KidnapTest(const KidnapOptions& options, std::shared_ptr<const OccupancyGrid> map,
             FindElsewhere find)
      : options_(options), ray_caster_(std::move(map)), find_(std::move(find)) {}

  void reset() override {
    armed_ = explained_before_ = false;
    unexplained_ = 0;
    share_ = 0.0;
    candidates_.clear();
  }

  bool observe(const Evidence& evidence) override {
    share_ = 0.0;
    const Scan& scan = evidence.observations.scan;
    if (scan.hits() == 0) return true;
    armed_ = armed_ || isConverged(evidence);
    const Fit here = fitOf(evidence.best, scan);
    if (!(here.error > mostExplained())) {
      usual_.observe(here.error);
      explained_before_ = true;
      unexplained_ = 0;
      candidates_.clear();
      return true;
    }
    ++unexplained_;
    const bool is_elsewhere = options_.kidnap_ratio == 0.0 || isElsewhere(evidence, here.error);
    if (armed_ && unexplained_ >= options_.kidnap_confirm_scans && is_elsewhere) {
      share_ = 1.0 - options_.local_share;
    }
    const bool is_covered = options_.kidnap_ratio > 0.0 && here.short_share > kCovered;
    return share_ > 0.0 || !explained_before_ || !is_covered;
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

  /// The largest error of a particle that explains a scan.
  double mostExplained() const {
    return usual_.limit(options_.kidnap_unusual, options_.kidnap_mean_abs_error);
  }

  /// Whether a place found in the last scan explains this one too: what is before a covered laser
  /// may look like some place in the map, but not twice like the same.
  bool isElsewhere(const Evidence& evidence, double error_here) {
    const Scan& scan = evidence.observations.scan;
    const double most = error_here / options_.kidnap_ratio;
    const auto fails = [&](const Pose2& place) {
      return !(fitOf(place, scan, options_.kidnap_truncation).error < most);
    };
    for (Pose2& candidate : candidates_) candidate = candidate * evidence.motion;
    candidates_.erase(std::remove_if(candidates_.begin(), candidates_.end(), fails),
                      candidates_.end());
    if (!candidates_.empty() && options_.kidnap_confirm_scans > 1) return true;
    if (unexplained_ % kScansPerSearch != 1) return false;
    candidates_ = find_(evidence.observations);
    candidates_.resize(std::min(candidates_.size(), kPlaces));
    candidates_.erase(std::remove_if(candidates_.begin(), candidates_.end(), fails),
                      candidates_.end());
    if (candidates_.empty()) usual_.observe(error_here);
    return !candidates_.empty() && options_.kidnap_confirm_scans == 1;
  }

  /// Beams shorter than `least` count as wrong: a covered laser fits beside each wall.
  Fit fitOf(const Pose2& T_map_base, const Scan& scan, double least = 0.0) const {
    const Eigen::Vector2d start = T_map_base * scan.position;
    const Eigen::Index hits = scan.range.size();
    const Eigen::Index beams = hits + scan.no_return_bearing.size();
    const Eigen::Index step = std::max<Eigen::Index>(1, beams / kRays);
    double sum = 0.0;
    int count = 0, too_short = 0;
    for (Eigen::Index j = 0; j < beams; j += step, ++count) {
      const float bearing = j < hits ? scan.bearing[j] : scan.no_return_bearing[j - hits];
      const double z = j < hits ? static_cast<double>(scan.range[j]) : scan.max_range;
      const Pose2 ray{start.x(), start.y(), T_map_base.theta + static_cast<double>(bearing)};
      const double missing = ray_caster_.range(ray, scan.max_range) - z;
      const double error = z < least ? options_.kidnap_truncation : std::abs(missing);
      sum += error < options_.kidnap_truncation ? error : options_.kidnap_truncation;
      too_short += missing > options_.kidnap_truncation ? 1 : 0;
    }
    count = std::max(1, count);
    return {sum / count, static_cast<double>(too_short) / count};
  }

  KidnapOptions options_;
  RayCaster ray_caster_;
  FindElsewhere find_;
  bool armed_{false};
  bool explained_before_{false};
  int unexplained_{0};  // scans in a row
  double share_{0.0};
  UsualError usual_;               // of map and laser, wherever the robot is: outlives reset()
  std::vector<Pose2> candidates_;  // that explain the last scan much better
};

}  // namespace

std::unique_ptr<Exploration> kidnapTest(const KidnapOptions& options,
                                        std::shared_ptr<const OccupancyGrid> map,
                                        FindElsewhere find) {
  return std::make_unique<KidnapTest>(options, std::move(map), std::move(find));
}

}  // namespace adaptive_localization
