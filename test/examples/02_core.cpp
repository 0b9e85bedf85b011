// SPDX-License-Identifier: BSD-3-Clause
// A filter core that lives in a library of its own: it believes its odometry and nothing else.
#include "adaptive_localization/filters/registries.hpp"
#include "adaptive_localization/particle/resampling.hpp"
#include "adaptive_localization/particle/summary.hpp"

namespace {

using namespace adaptive_localization;  // as a library of someone else would

struct DeadReckoningOptions {
  double scale{1.0};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("dead_reckoning_scale", scale, Range{0.5, 2.0}, "",
           "What a metre of odometry is in metres.");
  }
};

class DeadReckoning : public Filter {
 public:
  explicit DeadReckoning(const FilterContext& context)
      : scale_(context.parameters.read<DeadReckoningOptions>().scale), particles_(1) {}

  void reset(const Prior& prior) override {
    Pose2 start;
    if (const auto* gaussian = std::get_if<Gaussian2>(&prior)) start = gaussian->mean;
    if (const auto* cloud = std::get_if<Particles>(&prior)) {
      start = summarize(*cloud, normalisedWeights(cloud->log_weight)).T_map_base;
    }
    particles_.setPose(0, start);
  }

  Estimate update(const Pose2& motion, const Observations&) override {
    const Pose2 scaled{scale_ * motion.x, scale_ * motion.y, motion.theta};
    particles_.setPose(0, particles_.pose(0) * scaled);
    return estimate();
  }

  Estimate estimate() const override {
    Mode mode;
    mode.T_map_base = particles_.pose(0);
    mode.mass = 1.0;
    return {mode.T_map_base, mode.covariance, {mode}};
  }

  const Particles& hypotheses() const override { return particles_; }

 private:
  double scale_;
  Particles particles_;
};

}  // namespace

extern "C" void adaptive_localization_register_v2(Registries& registries) {
  registries.filters.add({"dead_reckoning",
                          "Odometry alone.",
                          [](const FilterContext& context) -> std::unique_ptr<Filter> {
                            return std::make_unique<DeadReckoning>(context);
                          },
                          describe(DeadReckoningOptions{}),
                          {},
                          {{"dead_reckoning_scale", 2.0}}});
}
