// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>
#include <vector>

#include "adaptive_localization/core/options.hpp"
#include "adaptive_localization/core/scan.hpp"
#include "adaptive_localization/filters/builtins.hpp"
#include "adaptive_localization/localizer/compass.hpp"
#include "adaptive_localization/localizer/confidence.hpp"

namespace adaptive_localization {

struct LocalizerOptions {
  std::string filter{"sa_kld"};
  std::string preset{"recommended"};
  std::string amcl_compatibility{"keep"};
  std::string plugins;  // paths, separated by colons
  int seed{1};
  int threads{1};
  double update_min_d{0.1};
  double update_min_a{0.05};
  double update_budget{5.0};
  double search_share{0.25};
  bool recovery{false};
  bool refine{false};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("filter", filter, Choices{}, "Filter core, by name.");
    option(
        "preset", preset, Choices{"recommended", "seed", "fp"},
        "Values of the options that are not given: recommended, or seed for those of the "
        "literature; fp (mcl) for the particle filter that Araujo Neto 2019 compared swarms with.");
    option("amcl_compatibility", amcl_compatibility, Choices{"keep", "ignore_untuned"},
           "Parameters of filter, laser and odometry that still have amcl's usual values when the "
           "node starts: keep uses them; ignore_untuned replaces them by this package's defaults, "
           "which are more accurate.");
    option("plugins", plugins, Choices{},
           "Shared libraries with filter cores and models of your own, separated by colons.");
    option("seed", seed, kWhole, "", "Seed of all randomness.");
    option("threads", threads, Range{1, 256}, "", "Threads used by one update.");
    option("update_min_d", update_min_d, kNotNegative, "m",
           "Distance to travel before the filter is updated.");
    option("update_min_a", update_min_a, kNotNegative, "rad",
           "Angle to turn before the filter is updated.");
    option("update_budget", update_budget, kNotNegative, "ms",
           "Work limit of map searches per update in nominal ms: 40000 poses evaluated each, about "
           "1 ms of a 3 GHz core, so that results do not depend on the machine. Comparing places "
           "comes first: 0.1 ms each, and 1.2 ms for each that slipping wheels may have left; a "
           "fifth is left for searches. A longer search continues with the next scans; 0: no "
           "limit. The search at the first scan and the one that verifies an initial pose are not "
           "limited.");
    option("search_share", search_share, Range{0.0, 1.0}, "",
           "Share of the time between two scans, 0.2 s at the most, for which a search of the map "
           "continues after the pose has been published, while the robot is lost; in nominal ms as "
           "well. 0: searches continue only with the next scans.");
    option("recovery", recovery,
           "True: move the filter to the hypotheses that explain the scans once its own pose is "
           "ruled out. False: the hypotheses only set the status.");
    option("refine", refine,
           "Correct the filter's estimate by matching the scan with the map (not needed with "
           "ekf_icp).");
  }
};

/// What parameters say, with the preset's values filled in.
struct Setup {
  LocalizerOptions options;
  ScanOptions scan;
  ConfidenceOptions confidence;
  CompassOptions compass;
  Parameters parameters;
};

/// Reads parameters and compares them, knowing the filters and their options.
class SetupReader {
 public:
  /// Loads the plug-ins that are named. Throws std::invalid_argument naming key, value and range.
  Setup read(Parameters parameters);

  const Registries& registries() const { return registries_; }

  bool haveSameFilter(const Setup& a, const Setup& b) const;
  bool haveSamePlaces(const Setup& a, const Setup& b) const;
  bool haveSameMatcher(const Setup& a, const Setup& b) const;

  /// All options of localizer and filter with the values in effect, given or default.
  std::vector<OptionDescription> effectiveOptions(const Setup& setup) const;

  /// The same, and then those that only the other filters have.
  std::vector<OptionDescription> allOptions(const Setup& setup) const;

 private:
  void loadPlugins(const std::string& paths);

  Registries registries_ = builtins();
  std::set<std::string> loaded_plugins_;
};

}  // namespace adaptive_localization
