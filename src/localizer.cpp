// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/localizer.hpp"

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "adaptive_localization/parallel.hpp"

namespace adaptive_localization {
namespace {

constexpr double kLostFit = 0.2;   // below: the scan contradicts the map
constexpr double kFoundFit = 0.5;  // above: it confirms it

std::vector<OptionDescription> localizerOptions() {
  std::vector<OptionDescription> all = describe(LocalizerOptions{});
  for (const auto& rows : {describe(ScanOptions{}), describe(ConfidenceOptions{})}) {
    all.insert(all.end(), rows.begin(), rows.end());
  }
  return all;
}

}  // namespace

std::string toText(Status status) {
  switch (status) {
    case Status::kGlobalizing:
      return "globalizing";
    case Status::kTracking:
      return "tracking";
    case Status::kAmbiguous:
      return "ambiguous";
    case Status::kLost:
      return "lost";
    default:
      return "uninitialised";
  }
}

Localizer::Localizer(Parameters parameters, std::shared_ptr<const OccupancyGrid> map) {
  options_ = parameters.read<LocalizerOptions>();
  std::istringstream plugins(options_.plugins);
  for (std::string path; std::getline(plugins, path, ':');) registry_.loadLibrary(path);

  const FilterDescription& filter = registry_.find(options_.filter);
  Parameters preset;
  const auto& values = options_.preset == "seed" ? filter.seed : filter.recommended;
  for (const auto& entry : values) preset.set(entry.first, entry.second);
  parameters.fill(preset);
  options_ = parameters.read<LocalizerOptions>();
  scan_options_ = parameters.read<ScanOptions>();
  confidence_options_ = parameters.read<ConfidenceOptions>();
  for (const auto& name : registry_.names()) {  // other cores' options are no mistakes
    for (const auto& option : registry_.find(name).options) parameters.acknowledge(option.key);
  }
  setThreads(options_.threads);
  context_.parameters = std::move(parameters);
  context_.seed = static_cast<std::uint64_t>(options_.seed);
  makeFilter(std::move(map));
}

void Localizer::makeFilter(std::shared_ptr<const OccupancyGrid> map) {
  FilterContext context = context_;
  context.map = std::move(map);
  context.distance_field = std::make_shared<const DistanceField>(*context.map);
  filter_ = registry_.find(options_.filter).make(context);
  confidence_.emplace(confidence_options_, context.distance_field);
  context_ = std::move(context);
}

void Localizer::reset(const Prior& prior) {
  const auto* gaussian = std::get_if<Gaussian2>(&prior);
  if (gaussian && !(isFinite(gaussian->mean) && gaussian->covariance.allFinite())) {
    throw std::invalid_argument("initial pose: got a number that is not finite");
  }
  filter_->reset(prior);
  confidence_->reset();
  converged_ = false;
  from_anywhere_ = std::holds_alternative<Anywhere>(prior);
  T_odom_base_at_update_.reset();
  last_ = {};
  last_.status = Status::kGlobalizing;
  last_.estimate = filter_->estimate();
  last_.T_map_base = last_.estimate.T_map_base;
}

void Localizer::setMap(std::shared_ptr<const OccupancyGrid> map) {
  makeFilter(std::move(map));
  if (last_.status == Status::kUninitialised) return;
  const Gaussian2 belief{last_.T_map_base, last_.estimate.covariance};
  if (from_anywhere_ && !converged_) {
    reset(Anywhere{});
  } else {
    reset(belief);
  }
}

bool Localizer::gateOpens(const Pose2& motion) const {
  return std::hypot(motion.x, motion.y) >= options_.update_min_d ||
         std::abs(motion.theta) >= options_.update_min_a;
}

Localization Localizer::update(const Pose2& T_odom_base, const Observations& observations) {
  last_.updated = false;
  if (last_.status == Status::kUninitialised || !isFinite(T_odom_base)) return last_;
  const bool first = !T_odom_base_at_update_;
  const Pose2 motion = first ? Pose2{} : between(*T_odom_base_at_update_, T_odom_base);
  if (first || update_requested_ || gateOpens(motion)) {
    updateFilter(motion, observations);
    T_odom_base_at_update_ = T_odom_base;
    last_.T_map_odom = last_.estimate.T_map_base * inverse(T_odom_base);
    update_requested_ = false;
  }
  last_.T_map_base = last_.T_map_odom * T_odom_base;
  return last_;
}

void Localizer::updateFilter(const Pose2& motion, const Observations& observations) {
  last_.estimate = filter_->update(motion, observations);
  confidence_->observe(last_.estimate, observations);
  last_.confidence = confidence_->value();
  last_.status = judge();
  converged_ = converged_ || last_.status == Status::kTracking;
  last_.updated = true;
}

Status Localizer::judge() const {
  const bool was_lost = last_.status == Status::kLost || !converged_;
  const bool fits = confidence_->fit() >= (was_lost ? kFoundFit : kLostFit);
  if (confidence_->isCompact() && confidence_->isAmbiguous()) return Status::kAmbiguous;
  if (confidence_->isCompact() && fits) return Status::kTracking;
  return from_anywhere_ && !converged_ ? Status::kGlobalizing : Status::kLost;
}

std::vector<std::string> Localizer::unknownKeys() const {
  return context_.parameters.unknownKeys();
}

std::vector<OptionDescription> Localizer::effectiveOptions() const {
  std::vector<OptionDescription> rows = localizerOptions();
  const auto& filter = registry_.find(options_.filter).options;
  rows.insert(rows.end(), filter.begin(), filter.end());
  for (auto& row : rows) {
    const auto given = context_.parameters.values().find(row.key);
    if (given != context_.parameters.values().end()) row.value = given->second;
  }
  return rows;
}

}  // namespace adaptive_localization
