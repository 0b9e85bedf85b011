// SPDX-License-Identifier: BSD-3-Clause
#include "particle/kidnap_test.hpp"

#include <limits>

#include "map/range_error.hpp"

namespace adaptive_localization {
namespace {

class KidnapTest : public Exploration {
 public:
  KidnapTest(const KidnapOptions& options, std::shared_ptr<const OccupancyGrid> map,
             std::shared_ptr<const DistanceField> field)
      : options_(options),
        range_error_(std::move(map), std::move(field), std::numeric_limits<double>::infinity(),
                     0.0) {}

  void reset() override {
    is_armed_ = false;
    share_ = 0.0;
  }

  void observe(const Evidence& evidence) override {
    share_ = 0.0;
    const Scan& scan = evidence.observations.scan;
    if (scan.hits() == 0 || options_.kidnap_mean_abs_error == 0.0) return;
    is_armed_ = is_armed_ || isConverged(evidence);
    const double error = range_error_.at(evidence.best, scan).error;
    if (is_armed_ && error > options_.kidnap_mean_abs_error) share_ = 1.0 - options_.local_share;
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

  KidnapOptions options_;
  RangeError range_error_;
  bool is_armed_{false};
  double share_{0.0};
};

}  // namespace

std::unique_ptr<Exploration> kidnapTest(const KidnapOptions& options,
                                        std::shared_ptr<const OccupancyGrid> map,
                                        std::shared_ptr<const DistanceField> field) {
  return std::make_unique<KidnapTest>(options, std::move(map), std::move(field));
}

}  // namespace adaptive_localization
