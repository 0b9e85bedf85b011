// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "adaptive_localization/filters/builtins.hpp"
#include "adaptive_localization/filters/filter.hpp"
#include "adaptive_localization/localizer/confidence.hpp"
#include "adaptive_localization/localizer/rivals.hpp"
#include "adaptive_localization/match/scan_matcher.hpp"

namespace adaptive_localization {

class EstimateRefiner;

/// What is known of the robot's place, in a word. Globalizing: it is being looked for, or there is
/// an initial pose that no scan has verified yet.
enum class Status { kUninitialised, kGlobalizing, kTracking, kAmbiguous, kLost };
std::string toText(Status status);

struct LocalizerOptions {
  std::string filter{"sa_kld"};
  std::string preset{"recommended"};
  std::string plugins;  // paths, separated by colons
  int seed{1};
  int threads{1};
  double update_min_d{0.1};
  double update_min_a{0.05};
  bool relocalize{false};
  bool refine{false};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("filter", filter, Choices{}, "Filter core, by name.");
    option("preset", preset, Choices{"recommended", "seed"},
           "Values of options that are not given: what we recommend, or the literature's.");
    option("plugins", plugins, Choices{},
           "Shared libraries with filter cores and models of your own, separated by colons.");
    option("seed", seed, kWhole, "", "Seed of all randomness.");
    option("threads", threads, Range{1, 256}, "", "Threads used by one update.");
    option("update_min_d", update_min_d, kNotNegative, "m",
           "Distance to travel before the filter is updated.");
    option("update_min_a", update_min_a, kNotNegative, "rad",
           "Angle to turn before the filter is updated.");
    option("relocalize", relocalize,
           "Move the filter to the places that explain the scans once they rule out its own.");
    option(
        "refine", refine,
        "Polish the filter's estimate by matching the scan with the map (no need with ekf_icp).");
  }
};

/// What the localizer answers to a scan.
struct Localization {
  Pose2 T_map_odom;         // the correction of odometry; valid for scans to come
  Pose2 T_map_base;         // at this scan
  Estimate estimate;        // of the last update; modes and covariance
  std::vector<Mode> modes;  // all places where the robot may be, most likely first
  bool updated{false};      // this scan went through the filter
  double confidence{0.0};   // in [0, 1]
  Status status{Status::kUninitialised};
};

/// Drives a filter: motion gate, filter, confidence, rivals, status. The node, the replayer and the
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
  /// Throws std::invalid_argument for numbers that are not finite and for a cloud without
  /// particles.
  void reset(const Prior& prior);

  /// The next scan updates the filter whether the robot moved or not.
  void requestUpdate() { update_requested_ = true; }

  /// A new map in the same frame: keeps the particles that stand on free ground of it, or where
  /// none does the heaviest mode, and weighs them at the next scan. Throws as the constructor does,
  /// and then keeps the old map.
  void setMap(Ground ground);

  /// One scan, with the odometry at its stamp. Before reset() the status is kUninitialised.
  Localization update(const Pose2& T_odom_base, const Observations& observations);

  /// How well scans fit the map at the estimate, how sure the belief is.
  const Confidence& confidence() const { return *confidence_; }

  /// Where in the map a scan can have been taken.
  Places& places() const { return *ground_.places; }

  /// The belief as a cloud; empty before reset().
  const Particles& hypotheses() const { return filter_->hypotheses(); }

  /// Those that the others follow, where the filter has such.
  Particles leaders() const { return filter_->leaders(); }

  /// How the last scan was aligned with the map, by the filter or to refine its estimate; null
  /// where nobody does.
  const Match* match() const;

  const ScanOptions& scanOptions() const { return setup_.scan; }
  const LocalizerOptions& options() const { return setup_.options; }

  /// Keys that neither the localizer nor the filter knows.
  std::vector<std::string> unknownKeys() const;

  /// All options of localizer and filter with the values in effect, given or default.
  std::vector<OptionDescription> effectiveOptions() const;

  /// The same, and then those that only the other filters have.
  std::vector<OptionDescription> allOptions() const;

 private:
  /// What parameters say, with the preset's values filled in.
  struct Setup {
    LocalizerOptions options;
    ScanOptions scan;
    ConfidenceOptions confidence;
    RivalsOptions rivals;
    Parameters parameters;
  };

  Setup read(Parameters parameters);
  void loadPlugins(const std::string& paths);
  void build(Setup setup, Ground ground, const std::optional<Prior>& belief);
  bool hasSameFilter(const Setup& setup) const;
  bool hasSamePlaces(const Setup& setup) const;
  bool hasSameMatcher(const Setup& setup) const;
  std::optional<Prior> belief() const;
  std::optional<Prior> beliefOn(const OccupancyGrid& map) const;
  bool gateOpens(const Pose2& motion, const Observations& observations) const;
  bool isCorrection(const Pose2& T_map_base_by_odometry) const;
  Pose2 corrected(const Pose2& T_map_base_by_odometry) const;
  void updateFilter(const Pose2& motion, const Observations& observations);
  void relocalize();
  bool isDoubtful(const Pose2& T_map_base_expected) const;
  void checkWhatWasTold(const Pose2& motion, const Observations& observations);
  void conclude();
  Status judge() const;

  Registries registries_ = builtins();
  std::set<std::string> loaded_plugins_;
  Setup setup_;
  Ground ground_;
  std::unique_ptr<Filter> filter_;
  std::optional<Confidence> confidence_;
  std::optional<Rivals> rivals_;
  std::unique_ptr<EstimateRefiner> refiner_;  // if estimates are to be refined

  bool converged_{false};  // was localized since the last reset
  bool from_anywhere_{false};
  bool is_told_{false};        // where it is, by somebody, and other places may explain scans too
  bool is_unverified_{false};  // what it was told: no scan could contradict it yet
  double way_to_check_{0.0};   // m or rad until the next check of that
  double way_of_checks_{0.0};  // between checks
  bool update_requested_{false};
  std::uint64_t relocalizations_{0};
  std::optional<Pose2> T_odom_base_at_update_;
  Localization last_;
};

}  // namespace adaptive_localization
