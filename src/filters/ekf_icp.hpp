// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "adaptive_localization/core/rng.hpp"
#include "adaptive_localization/filters/filter.hpp"
#include "adaptive_localization/motion/motion_model.hpp"
#include "adaptive_localization/observation/composed_model.hpp"
#include "core/chi_square.hpp"
#include "match/scan_matcher.hpp"
#include "match/scan_tracker.hpp"
#include "match/sonar_line_matcher.hpp"
#include "particle/pose_sampler.hpp"
#include "pending_motion.hpp"

namespace adaptive_localization {

struct EkfOptions {
  std::string ekf_landmarks{"hits"};
  double ekf_gate_probability{0.99};
  int ekf_rejected_scans{3};
  int cloud_particles{200};
  bool ekf_weigh_cloud{true};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("ekf_landmarks", ekf_landmarks, Choices{"hits", "lines"},
           "What corrects the pose of ekf_icp: hits, matched with the map; lines, straight lines "
           "found in scans and sonar readings, matched with the walls of line_map, which is then "
           "required.");
    option("ekf_gate_probability", ekf_gate_probability, kProbability, "",
           "Probability that a right match passes the gate, a chi-square test of its distance from "
           "the prediction; 1: no gate.");
    option("ekf_rejected_scans", ekf_rejected_scans, Range{1, 1000}, "",
           "A match that the gate refuses is taken after so many good ones in a row.");
    option("cloud_particles", cloud_particles, Range{1, 100000}, "",
           "Particles drawn from the belief of ekf_icp or markov, published and used where the "
           "belief has no simpler form.");
    option("ekf_weigh_cloud", ekf_weigh_cloud,
           "Where walls are thick and hits slide in them, correct by the mean and covariance of a "
           "weighted cloud (Kotecha and Djuric 2003).");
  }
};

struct EkfParts {
  std::unique_ptr<MotionModel> motion;
  MatchScan match;
  std::unique_ptr<PoseSampler> elsewhere;
  std::unique_ptr<ObservationModel> senses{std::make_unique<ComposedModel>()};
  std::unique_ptr<ObservationModel> scans{};  // null: a map on which matches correct
  std::optional<SonarLineMatcher> sonars{};   // none: single readings alone
};

/// An extended Kalman filter that is corrected by matching scans with the map:
///
///     predict   x = x (+) odometry,   P = F P F^T + G Q G^T
///     correct   by the matched pose, along the directions that the scan tells something of
///
/// A match with too many outliers, or one that odometry contradicts (gate), corrects nothing: the
/// covariance grows. A match that fits scan after scan is believed after all. From an unknown start
/// the pose is that of the place where the first scan fits best.
///
/// Where walls are thick on the map, hits slide in them. There a small cloud corrects: poses drawn
/// from the belief are weighed by the observation model, and their mean and covariance are the
/// belief (Gaussian particle filter, Kotecha and Djuric, IEEE Transactions on Signal Processing
/// 51(10), 2003); each 0.1 m or 0.1 rad, as scans from one place tell the same.
class EkfIcp : public Filter {
 public:
  EkfIcp(const EkfOptions& options, EkfParts parts, std::uint64_t seed)
      : options_(options),
        gate_(chiSquare(3, options.ekf_gate_probability)),
        parts_(std::move(parts)),
        tracker_(parts_.match),
        rng_(seed) {}

  void reset(const Prior& prior) override;
  Estimate update(const Pose2& motion, const Observations& observations) override;
  Estimate estimate() const override;
  const Particles& hypotheses() const override { return cloud_; }
  const Match* match() const override { return match_ ? &*match_ : nullptr; }

 private:
  void move(const Pose2& motion);
  void correctBySonars(const Observations& observations);
  void undoJump(const Pose2& T_map_base_before, const Scan& scan);
  void correct();
  void weighCloud(const Observations& observations);
  void startAt(const Observations& observations);

  EkfOptions options_;
  double gate_;  // squared Mahalanobis distance from odometry
  EkfParts parts_;
  ScanTracker tracker_;
  Rng rng_;
  Particles cloud_;
  PendingMotion pending_;
  std::optional<Match> match_;
  bool anywhere_{false};
  double stamp_{0.0};  // of the last update, s
  double way_{0.0};    // since a cloud was weighed, m or rad
  int refused_{0};     // good matches in a row
};

}  // namespace adaptive_localization
