// SPDX-License-Identifier: BSD-3-Clause
#include "ser/places.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "grid_cache.hpp"

namespace adaptive_localization {
namespace {

constexpr std::size_t kKept = 4;                         // grids, for robots with several lasers
constexpr int kShortestPause = 8, kLongestPause = 1024;  // scans that ask for a grid

/// Drivers alternate between 180 and 181 beams, mounts move a little: a grid made for one does for
/// the other.
bool suits(const ScanGeometry& grid, const ScanGeometry& scan) {
  const double turned = grid.headingOf(0) - scan.headingOf(0);
  return (grid.position - scan.position).norm() < 0.02 && grid.max_range == scan.max_range &&
         std::abs(wrapAngle(turned)) < 0.5 * kDirectionStep &&
         std::abs(grid.count - scan.count) <= 2 &&
         std::abs(grid.spacing - scan.spacing) < 0.05 * kDirectionStep;
}

/// Stamps alone do not tell: a log may have the same for all.
bool isSame(const Observations& a, const Observations& b) {
  const auto equal = [](const Eigen::ArrayXf& p, const Eigen::ArrayXf& q) {
    return p.size() == q.size() && (p == q).all();
  };
  return a.stamp == b.stamp && equal(a.scan.range, b.scan.range) &&
         equal(a.scan.bearing, b.scan.bearing);
}

}  // namespace

Places::Places(std::shared_ptr<const OccupancyGrid> map,
               std::shared_ptr<const DistanceField> distance_field,
               const EnergyGridOptions& options, const GlobalSearchOptions& search, Build build)
    : map_(std::move(map)),
      distance_field_(std::move(distance_field)),
      options_(options),
      search_options_(search),
      build_(build) {}

Places::~Places() = default;

/// Only reads what does not change: may run in another thread.
Places::Entry Places::make(const ScanGeometry& geometry, std::shared_ptr<const RangeTable> ranges,
                           const StopToken& stop) const {
  GridCache cache(options_.cache_dir, *map_);
  Entry entry;
  entry.geometry = geometry;
  if (!ranges) {
    ranges =
        cache.ranges(geometry.max_range, EnergyGrid::spacingFor(*map_, geometry, options_), stop);
  }
  entry.grid = std::make_shared<const EnergyGrid>(ranges, geometry, options_);
  entry.is_from_cache = cache.hadAll();
  entry.warnings = cache.warnings();
  entry.search =
      std::make_shared<const GlobalSearch>(entry.grid, map_, distance_field_, search_options_);
  return entry;
}

std::shared_ptr<const RangeTable> Places::rangesFor(const ScanGeometry& geometry) const {
  for (const Entry& entry : entries_) {
    if (entry.geometry.max_range == geometry.max_range) return entry.grid->sharedRanges();
  }
  return nullptr;
}

void Places::keep(Entry entry) {
  for (const std::string& warning : entry.warnings) warn(warning);
  const int spacing = entry.grid->ranges().spacing();
  if (spacing > EnergyGrid::spacingAskedFor(*map_, options_)) {
    const std::string side = std::to_string(spacing);
    warn("energy grid: uses one cell of " + side + " by " + side +
         " to keep within energy_grid_max_memory, which is " +
         std::to_string(static_cast<int>(options_.energy_grid_max_memory)) + " MB");
  }
  if (entries_.size() == kKept) entries_.erase(entries_.begin());
  entries_.push_back(std::move(entry));
}

/// Once each.
void Places::warn(const std::string& warning) {
  if (said_.insert(warning).second) warnings_.push_back(warning);
}

void Places::poll() {
  if (auto outcome = building_.poll()) take(std::move(*outcome));
}

/// Without memory for a grid there is none, and the rest goes on; it is tried again ever more
/// seldom.
void Places::take(Outcome<Entry> outcome) {
  pause_ = outcome.value ? 0 : std::clamp(2 * pause_, kShortestPause, kLongestPause);
  asks_left_ = pause_;
  if (!outcome.value) {
    warn("energy grid: cannot be made, no other places are known: " + outcome.error);
  } else {
    keep(std::move(*outcome.value));
  }
}

std::shared_ptr<const EnergyGrid> Places::newestGrid() {
  poll();
  return entries_.empty() ? nullptr : entries_.back().grid;
}

const Places::Entry* Places::entryFor(const Scan& scan) {
  poll();
  const ScanGeometry geometry = geometryOf(scan, options_.energy_max_range);
  for (const Entry& entry : entries_) {
    if (suits(entry.geometry, geometry)) return &entry;
  }
  if (building_.isRunning() || asks_left_-- > 0) return nullptr;
  auto ranges = rangesFor(geometry);
  if (build_ == Build::kAtOnce) {
    take(outcomeOf([&] { return make(geometry, ranges, {}); }));
    return pause_ > 0 ? nullptr : &entries_.back();
  }
  building_.start(
      [this, geometry, ranges](const StopToken& stop) { return make(geometry, ranges, stop); });
  return nullptr;
}

std::shared_ptr<const EnergyGrid> Places::energyGrid(const Scan& scan) {
  const Entry* entry = entryFor(scan);
  return entry ? entry->grid : nullptr;
}

bool Places::isReadyFor(const Scan& scan) {
  return entryFor(scan) || pause_ > 0 || !entries_.empty();
}

void Places::beginUpdate(const Pose2& T_odom_base, SearchWork work) {
  constexpr double kStale = 8.0;  // m or rad, after which odometry tells too little
  const Pose2 motion = between(T_odom_base_, T_odom_base);
  T_odom_base_ = T_odom_base;
  way_ += std::hypot(motion.x, motion.y) + std::abs(motion.theta);
  work_ = work_left_ = work;
  if (!question_) return;
  if (!(way_ < kStale)) {
    question_.reset();
  } else {
    question_->search->advance(work_left_);
  }
}

void Places::searchOn(SearchWork work) {
  if (question_) question_->search->advance(work);
}

void Places::ask(const Observations& observations) {
  const Entry* entry = question_ ? nullptr : entryFor(observations.scan);
  if (!entry) return;
  question_ = Question{observations, T_odom_base_,
                       std::make_shared<PlaceSearch>(entry->search, observations.scan)};
  way_ = 0.0;
}

std::optional<std::vector<Place>> Places::search(const Observations& observations) {
  if (searched_ && isSame(*searched_, observations)) return found_;
  searched_.reset();
  asked_before_.reset();
  found_.clear();
  ask(observations);
  if (!question_) return found_;
  if (!question_->search->advance(work_left_)) return std::nullopt;
  const PlaceSearch& search = *question_->search;
  if (isSame(question_->observations, observations)) {
    found_ = search.places();
  } else {
    const SearchWork after = search.workAfter();
    if (after > work_left_ && work_left_ < work_) return std::nullopt;  // the next update's work
    const Pose2 motion = between(question_->T_odom_base, T_odom_base_);
    found_ = search.placesAfter(motion, observations.scan);
    work_left_ -= after;
    asked_before_ = Asked{std::move(question_->observations), search.places(), motion};
  }
  question_.reset();
  searched_ = observations;
  return found_;
}

const Places::Asked* Places::askedBefore(const Observations& observations) const {
  const bool is_answer = searched_ && isSame(*searched_, observations);
  return is_answer && asked_before_ ? &*asked_before_ : nullptr;
}

std::vector<std::string> Places::takeWarnings() {
  return std::exchange(warnings_, {});
}

}  // namespace adaptive_localization
