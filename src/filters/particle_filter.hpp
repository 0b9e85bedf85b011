// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "adaptive_localization/filters/filter.hpp"
#include "adaptive_localization/motion/motion_model.hpp"
#include "adaptive_localization/observation/observation_model.hpp"
#include "adaptive_localization/particle/resampling.hpp"
#include "particle/exploration.hpp"
#include "particle/pose_sampler.hpp"
#include "particle/sample_size.hpp"
#include "pending_motion.hpp"

namespace adaptive_localization {

struct ParticleFilterOptions {
  int resample_interval{1};
  bool selective_resampling{true};
  double min_effective_share{0.1};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("resample_interval", resample_interval, Range{1, 1000}, "",
           "Number of updates from one resampling to the next, at least.");
    option("selective_resampling", selective_resampling,
           "Resample only when the effective number of particles is below half of them.");
    option("min_effective_share", min_effective_share, kProbability, "",
           "Least ratio of effective particles after an update to those before it; a likelihood "
           "that is too sharp is tempered. 0: never.");
  }
};

/// The parts of a particle filter that make the difference between mcl, kld, amcl and others.
struct ParticleFilterParts {
  std::unique_ptr<MotionModel> motion;
  std::unique_ptr<ObservationModel> observation;
  Resampling resampling;
  std::unique_ptr<SampleSize> size;
  std::unique_ptr<Exploration> exploration;
  std::unique_ptr<PoseSampler> elsewhere;
};

/// Monte Carlo localization (Dellaert, Fox, Burgard, Thrun 1999; Probabilistic Robotics,
/// table 8.2): move, weigh, resample. Particles that may be anywhere are drawn anew at the first
/// scan that tells where to look.
class ParticleFilter : public Filter {
 public:
  ParticleFilter(const ParticleFilterOptions& options, ParticleFilterParts parts,
                 std::uint64_t seed)
      : options_(options), parts_(std::move(parts)), rng_(seed) {}

  void reset(const Prior& prior) override;
  Estimate update(const Pose2& motion, const Observations& observations) override;
  Estimate estimate() const override;
  const Particles& hypotheses() const override { return particles_; }

 private:
  void drawElsewhere(Eigen::Index count);
  void move(const Pose2& motion);

  /// The particles' weights after the observations, normalised.
  Eigen::ArrayXd weigh(const Observations& observations);
  bool resamplingIsDue(const Eigen::ArrayXd& weights, double elsewhere);
  void resample(const Eigen::ArrayXd& weights, double elsewhere);

  ParticleFilterOptions options_;
  ParticleFilterParts parts_;
  Rng rng_;
  Particles particles_;
  PendingMotion pending_;
  int updates_since_resampling_{0};
  bool anywhere_{false};    // and no scan has told yet where to look
  bool taken_over_{false};  // from another filter, with its number of particles
};

}  // namespace adaptive_localization
