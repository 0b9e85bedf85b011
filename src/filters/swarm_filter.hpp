// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "adaptive_localization/core/observations.hpp"
#include "adaptive_localization/core/rng.hpp"
#include "adaptive_localization/filters/filter.hpp"
#include "adaptive_localization/motion/motion_model.hpp"
#include "adaptive_localization/observation/composed_model.hpp"
#include "match/scan_tracker.hpp"
#include "particle/pose_sampler.hpp"
#include "pending_motion.hpp"
#include "swarm/swarm_move.hpp"
#include "swarm_fix.hpp"

namespace adaptive_localization {

struct SwarmFilterOptions {
  int swarm_size{400};
  double swarm_fix_deviation{0.0};
  double swarm_explained{0.16};
  bool swarm_spread{false};
  bool swarm_fuse{true};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("swarm_size", swarm_size, Range{2, 1000000}, "",
           "Largest number of searchers (lbba, ba, pso); swarm_budget may allow fewer.");
    option("swarm_fix_deviation", swarm_fix_deviation, kNotNegative, "m",
           "The swarm searches when the position's standard deviation by odometry exceeds this or "
           "a scan is not explained; 0: at every update.");
    option("swarm_explained", swarm_explained, kPositive, "m, 1",
           "Cost above which a place does not explain a scan: m, or a share of the range "
           "(swarm_error).");
    option("swarm_spread", swarm_spread,
           "Spread the swarm over the map when its place does not explain a scan, and take its "
           "answer at once; otherwise recovery searches the map.");
    option("swarm_fuse", swarm_fuse,
           "Fuse the swarm's answer with odometry by their covariances; otherwise the answer "
           "replaces it.");
  }
};

/// The parts that make the difference between pso, ba and lbba.
struct SwarmFilterParts {
  std::unique_ptr<MotionModel> motion;
  std::unique_ptr<SwarmMove> move;
  std::unique_ptr<SwarmFixer> fixer;
  MatchScan match{};  // none: places are as good as the swarm finds them
  std::unique_ptr<PoseSampler> elsewhere;
  std::unique_ptr<ObservationModel> senses{std::make_unique<ComposedModel>()};
};

/// A swarm looks for the pose that explains the scan best, in a narrow cloud where odometry says
/// the robot is, or everywhere if that is not known; between such fixes the pose rides on odometry
/// and its covariance grows. A fix is taken for another observation of the pose, if odometry
/// and it can both be right or it fits much better, twice in a row.
class SwarmFilter : public Filter {
 public:
  SwarmFilter(const SwarmFilterOptions& options, SwarmFilterParts parts, std::uint64_t seed)
      : options_(options), parts_(std::move(parts)), tracker_(parts_.match), rng_(seed) {
    options_.swarm_size = parts_.fixer->affordable(options_.swarm_size);
  }

  void reset(const Prior& prior) override;
  Estimate update(const Pose2& motion, const Observations& observations) override;
  Estimate estimate() const override { return estimate_; }
  const Particles& hypotheses() const override { return bats_; }
  Particles leaders() const override { return leaders_; }

 private:
  Eigen::Matrix3d cloudCovariance(double xy, double theta) const;
  void drawElsewhere();
  void trackHeaviest(const Estimate& estimate);
  void ride(const Pose2& motion, const Observations& observations);
  void fix(const Observations& observations);
  bool isFixDue(const Observations& observations) const;
  void align(const Observations& observations, SwarmFix& fix) const;
  SwarmFix lookHere(const Observations& observations);
  void fixHere(const Observations& observations);
  SwarmFix lookElsewhere(const Observations& observations);
  void fixAnywhere(const Observations& observations);
  bool isSpreadDue(double cost);
  void spread(const Observations& observations);
  void takeIfPlausible(const SwarmFix& fix, const Observations& observations);
  PoseObservation observationOf(const SwarmFix& fix) const;
  bool isUnexpected(const SwarmFix& fix, const Observations& observations);
  void take(const SwarmFix& fix, bool is_fused);

  SwarmFilterOptions options_;
  SwarmFilterParts parts_;
  ScanTracker tracker_;  // of the heaviest mode
  Rng rng_;
  Particles bats_, leaders_;
  Estimate estimate_;
  PendingMotion pending_;
  bool anywhere_{false};
  bool is_fix_asked_{false};
  bool is_undecided_{false};  // the bats are in several places
  int unexplained_{0};        // scans in a row
  int strange_{0};            // fixes in a row that odometry does not explain
};

}  // namespace adaptive_localization
