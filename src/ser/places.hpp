// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "adaptive_localization/core/observations.hpp"
#include "adaptive_localization/map/distance_field.hpp"
#include "core/background.hpp"
#include "ser/energy_grid.hpp"
#include "ser/global_search.hpp"
#include "ser/place_search.hpp"

namespace adaptive_localization {

/// Where in a map a scan can have been taken: the energy grid for the laser in use, and the global
/// search on it. One per map, shared by all that ask "where else could I be".
///
/// The grid is made when a scan first asks for it, and anew when the laser's geometry changes; it
/// is taken from cache_dir if it is there.
class Places {
 public:
  enum class Build { kAtOnce, kInBackground };

  Places(std::shared_ptr<const OccupancyGrid> map,
         std::shared_ptr<const DistanceField> distance_field, const EnergyGridOptions& options,
         const GlobalSearchOptions& search, Build build = Build::kAtOnce);
  ~Places();

  /// The grid for this scan's geometry; null while it is being made in the background.
  std::shared_ptr<const EnergyGrid> energyGrid(const Scan& scan);

  /// Begins an update: so much work may be done until the next one, and what is being searched for
  /// goes on. Until this is called for the first time there is no limit.
  void beginUpdate(const Pose2& T_odom_base, SearchWork work);

  /// What is being searched for goes on between two updates.
  void searchOn(SearchWork work);

  /// Begins to search for the places where the robot can be by this scan, unless it does so for
  /// another one already: search() has the answer.
  void ask(const Observations& observations);

  /// The robot may have been carried away: a scan from before tells no more where it is.
  void askAnew() { question_.reset(); }

  /// Of this update's work; below 0 by one step of a search at the most.
  SearchWork workLeft() const { return work_left_; }

  /// The places where the robot can be by this scan, most likely first; empty while the grid is
  /// being made and for a scan without hits. Nothing if the work that may be done does not suffice:
  /// ask again at the next scan. What is answered then was searched for by the scan that was asked
  /// about first, rides on the odometry since, and is judged by the scan that is asked about now: a
  /// robot that was carried on meanwhile is at none of those places. The answer to the same scan
  /// again is remembered.
  std::optional<std::vector<Place>> search(const Observations& observations);

  /// What an answer was searched for by, and the places by that scan alone.
  struct Asked {
    Observations observations;
    std::vector<Place> places;
    Pose2 motion;  // since then
  };

  /// The same for the last answer; null if it was to another scan than this, or searched for by it.
  const Asked* askedBefore(const Observations& observations) const;

  /// Whether search() tells as much of this scan as it will: false while the first grid is being
  /// made. A laser whose mount turns all the time may never find one that is made for it.
  bool isReadyFor(const Scan& scan);

  /// Whether a grid is being made in the background.
  bool isBuilding() const { return building_.isRunning(); }

  /// What is being made in the background is no longer wanted: ends soon, without a result.
  void stopBuilding() { building_.stop(); }

  /// The grid that was ready last; null before the first. Starts nothing.
  std::shared_ptr<const EnergyGrid> newestGrid();

  /// Whether that one was read from cache_dir.
  bool isNewestFromCache() const { return !entries_.empty() && entries_.back().is_from_cache; }

  /// What there was to say since last asked: damaged cache files, coarser grids.
  std::vector<std::string> takeWarnings();

 private:
  struct Entry {
    ScanGeometry geometry;
    std::shared_ptr<const EnergyGrid> grid;
    std::shared_ptr<const GlobalSearch> search;
    bool is_from_cache{false};
    std::vector<std::string> warnings;
  };

  /// A scan that is being searched for, and from where by the odometry.
  struct Question {
    Observations observations;
    Pose2 T_odom_base;
    std::shared_ptr<PlaceSearch> search;
  };

  Entry make(const ScanGeometry& geometry, std::shared_ptr<const RangeTable> ranges,
             const StopToken& stop) const;
  std::shared_ptr<const RangeTable> rangesFor(const ScanGeometry& geometry) const;
  const Entry* entryFor(const Scan& scan);
  void keep(Entry entry);
  void take(Outcome<Entry> outcome);
  void warn(const std::string& warning);
  void poll();

  std::shared_ptr<const OccupancyGrid> map_;
  std::shared_ptr<const DistanceField> distance_field_;
  EnergyGridOptions options_;
  GlobalSearchOptions search_options_;
  Build build_;
  std::vector<Entry> entries_;
  std::vector<std::string> warnings_;     // to be taken
  int pause_{0};                          // after a grid that could not be made; 0 if it could:
  int asks_left_{0};                      // so many scans that ask for one until it is tried again
  std::set<std::string> said_;            // all warnings
  Pose2 T_odom_base_;                     // at this update
  double way_{0.0};                       // m or rad, since the question
  SearchWork work_{kUnlimitedWork};       // of this update
  SearchWork work_left_{kUnlimitedWork};  // of that
  std::optional<Question> question_;
  std::optional<Observations> searched_;  // what found_ is the answer to
  std::vector<Place> found_;
  std::optional<Asked> asked_before_;
  Background<Entry> building_;  // last, so that it ends before what it reads
};

}  // namespace adaptive_localization
