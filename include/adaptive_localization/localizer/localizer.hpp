// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "adaptive_localization/filters/filter.hpp"
#include "adaptive_localization/localizer/compass.hpp"
#include "adaptive_localization/localizer/gyroscope.hpp"
#include "adaptive_localization/localizer/setup.hpp"
#include "adaptive_localization/localizer/sonar_ring.hpp"
#include "adaptive_localization/localizer/status.hpp"
#include "adaptive_localization/match/match.hpp"

namespace adaptive_localization {

class EstimateRefiner;
class Places;
class Recovery;
struct PreparedMap;

/// What the localizer answers to a scan.
struct Localization {
  Pose2 T_map_odom;  // the correction of odometry; valid for scans to come
  Pose2 T_map_base;  // at this scan
  /// Of T_map_base, (x, y, theta) in the map's frame: the estimate's, and more where the pose is
  /// kept on odometry, away from the estimate.
  Eigen::Matrix3d covariance{Eigen::Matrix3d::Zero()};
  Estimate estimate;        // of the last update
  std::vector<Mode> modes;  // all places where the robot may be, most likely first
  bool updated{false};      // this scan went through the filter
  double confidence{0.0};   // in [0, 1]
  Status status{Status::kUninitialised};
};

/// Drives a core: motion gate, core, refiner, recovery, answer. The node, the replayer and the
/// tests all call this. No ROS, no clock.
class Localizer {
 public:
  /// Throws std::invalid_argument naming key, value and range when a parameter is wrong or when the
  /// map has no free cell. The belief is empty until reset().
  Localizer(const Parameters& parameters, Ground ground);
  ~Localizer();

  /// Other options from now on, all of them: what is not given takes its default. The belief goes
  /// on, whichever filter is named, and so do gate, correction, confidence and status.
  /// Throws std::invalid_argument naming key, value and range; the options before then stay.
  void configure(const Parameters& parameters);

  /// Starts anew from a prior; the next scan updates the filter whether the robot moved or not.
  /// Throws std::invalid_argument for numbers that are not finite, places beyond kFarthest,
  /// variances beyond kVariance and a cloud without particles.
  void reset(const Prior& prior);

  /// The next scan updates the filter whether the robot moved or not.
  void requestUpdate() { update_requested_ = true; }

  /// A new map in the same frame: keeps the particles that stand on free ground of it, or where
  /// none does the heaviest mode, and weighs them at the next scan. Throws as the constructor does,
  /// and then keeps the old map.
  void setMap(Ground ground);

  /// Prepares a map for this localizer, with its options as they are now, which takes long on a
  /// large one. The function may be called in another thread, whatever becomes of the localizer; it
  /// throws as setMap().
  std::function<std::shared_ptr<PreparedMap>(Ground)> preparer() const;

  /// The same as with a map; takes apart what was prepared. The options must still be the same.
  void setMap(PreparedMap& prepared);

  /// One scan, with the odometry at its stamp: without numbers, or beyond kFarthest, the scan is
  /// ignored. Before reset() the status is kUninitialised.
  Localization update(const Pose2& T_odom_base, const Observations& observations);

  /// Goes on with a search of the map for a lost robot that the last update did not finish, for
  /// search_share of the time since the scan before it: between scans, once what update() answered
  /// is published.
  void searchOn();

  /// How well scans fit the map at the estimate, how sure the belief is.
  const Confidence& confidence() const;

  /// Where in the map a scan can have been taken.
  Places& places() const { return *ground_.places; }

  /// How far the map's walls are.
  const DistanceField& field() const { return *ground_.field; }

  /// The belief as a cloud; empty before reset().
  const Particles& hypotheses() const { return filter_->hypotheses(); }

  /// Those that the others follow, where the filter has such.
  Particles leaders() const { return filter_->leaders(); }

  /// How the last scan was aligned with the map, by the filter or to refine its estimate; null
  /// where nobody does.
  const Match* match() const { return match_ ? &*match_ : nullptr; }

  /// What is known of the compass and of the gyroscope.
  const Compass& compass() const { return compass_; }
  const Gyroscope& gyroscope() const { return gyroscope_; }

  const ScanOptions& scanOptions() const { return setup_.scan; }
  const LocalizerOptions& options() const { return setup_.options; }

  /// Keys that neither the localizer nor the filter knows.
  std::vector<std::string> unknownKeys() const { return setup_.parameters.unknownKeys(); }

  /// All options of localizer and filter with the values in effect, given or default.
  std::vector<OptionDescription> effectiveOptions() const {
    return reader_.effectiveOptions(setup_);
  }

  /// The same, and then those that only the other filters have.
  std::vector<OptionDescription> allOptions() const { return reader_.allOptions(setup_); }

 private:
  void build(Setup setup, Ground ground, const std::optional<Prior>& belief);
  void use(PreparedMap& prepared, const std::optional<Prior>& belief);
  std::optional<Prior> belief() const;
  std::optional<Prior> beliefOn(const OccupancyGrid& map) const;
  bool gateOpens(const Pose2& motion, const Observations& observations) const;
  Observations forCores(const Pose2& T_odom_base, Observations observations) const;
  void updateBelief(const Pose2& motion, const Pose2& T_odom_base,
                    const Observations& observations);
  Observations evidenceOf(const Pose2& T_map_base, const Observations& observations) const;
  void refine(const Pose2& motion, const Observations& seen, const Scan& whole);
  void moveBelief();
  void assess(const Pose2& T_map_base);

  SetupReader reader_;
  std::shared_ptr<const SetupReader> used_reader_;  // what follows may refer to its models
  Setup setup_;
  Ground ground_;
  std::unique_ptr<Filter> filter_;
  std::unique_ptr<EstimateRefiner> refiner_;  // if estimates are to be refined
  std::unique_ptr<Recovery> recovery_;
  Compass compass_;
  Gyroscope gyroscope_;
  SonarRing sonars_;

  bool is_anywhere_{false};  // was reset so, and not tracked since
  bool update_requested_{false};
  std::uint64_t moves_{0};  // of the belief
  std::optional<Pose2> T_odom_base_at_update_;
  double stamp_{0.0}, interval_{0.0};  // of the last scan, and before it, s
  bool is_searched_on_{false};         // since then: the next update need not
  std::optional<Match> match_;         // of the last update's scan
  Localization last_;
};

}  // namespace adaptive_localization
