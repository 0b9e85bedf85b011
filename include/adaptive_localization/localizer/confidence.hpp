// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>

#include "adaptive_localization/core/belief.hpp"
#include "adaptive_localization/core/observations.hpp"
#include "adaptive_localization/core/options.hpp"
#include "adaptive_localization/map/distance_field.hpp"
#include "adaptive_localization/observation/composed_model.hpp"

namespace adaptive_localization {

struct ConfidenceOptions {
  double confidence_inlier_distance{0.2};
  double confidence_low_inliers{0.4};
  double confidence_high_inliers{0.75};
  double confidence_rate{0.2};
  double converged_std{0.5};
  double ambiguous_mass{0.1};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("confidence_inlier_distance", confidence_inlier_distance, kPositive, "m",
           "Largest distance from an obstacle of the map at which a hit agrees with it.");
    option("confidence_low_inliers", confidence_low_inliers, kProbability, "",
           "Share of agreeing hits at which the fit is 0.");
    option("confidence_high_inliers", confidence_high_inliers, kProbability, "",
           "Share of agreeing hits at which the fit is 1.");
    option("confidence_rate", confidence_rate, Range{1e-3, 1}, "",
           "Weight of the newest update in the running mean of the fit.");
    option("converged_std", converged_std, kPositiveDeviation, "m",
           "Largest standard deviation of position at which a mode is a single place.");
    option("ambiguous_mass", ambiguous_mass, kProbability, "",
           "Least mass of a second mode at which the status is ambiguous.");
  }
};

/// How far an estimate can be trusted, from what any filter tells: how well the scan fits the map
/// at the estimated pose, how much of the belief is in its heaviest mode, and how wide that mode
/// is.
///
///     confidence = fit * mass / (1 + (std / converged_std)^2)
///
/// fit is the share of hits within confidence_inlier_distance of an obstacle, stretched from
/// [low, high] to [0, 1], as a running mean over updates; without a scan it is what other senses
/// say. Another sense that contradicts the estimate halves the confidence.
class Confidence {
 public:
  static constexpr double kContradiction = 0.2;  // a fit below tells that the robot is not there

  Confidence(const ConfidenceOptions& options, std::shared_ptr<const DistanceField> field,
             Senses senses = noSenses());

  /// Forgets all scans.
  void reset();

  /// Goes on from what another one has seen.
  void copyStateOf(const Confidence& other);

  /// Takes note of observations and the estimate made from them.
  void observe(const Estimate& estimate, const Observations& observations);

  /// A scan without hits that should have some does not fit at all.
  void contradict();

  /// How well a scan fits the map at a pose, [0, 1]; the scan must have hits.
  double fitOf(const Pose2& T_map_base, const Scan& scan) const;

  /// The same of all that is observed: of other senses where there is no scan; nothing where none
  /// tells.
  std::optional<double> fitOf(const Pose2& T_map_base, const Observations& observations) const;

  double value() const { return value_; }                   // [0, 1]
  double latestFit() const { return latest_fit_; }          // of the newest scan alone
  int contradictions() const { return contradictions_; }    // scans in a row with hardly any fit
  double fit() const { return fit_ < 0.0 ? 0.0 : fit_; }    // [0, 1]
  bool isContradicted() const { return is_contradicted_; }  // by another sense than the laser
  bool isCompact() const { return compact_; }               // the heaviest mode is one place
  bool isAmbiguous() const { return ambiguous_; }           // a second mode is nearly as heavy

 private:
  void note(double fit);

  ConfidenceOptions options_;
  std::shared_ptr<const DistanceField> field_;
  Senses senses_;
  double fit_{-1.0};  // none yet
  double latest_fit_{0.0};
  int contradictions_{0};
  double value_{0.0};
  bool is_contradicted_{false};
  bool compact_{false};
  bool ambiguous_{false};
};

}  // namespace adaptive_localization
