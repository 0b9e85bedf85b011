// SPDX-License-Identifier: BSD-3-Clause
#include "eval/search_run.hpp"

#include <algorithm>
#include <iomanip>
#include <sstream>
#include <stdexcept>

#include "eval/statistics.hpp"
#include "eval/stopwatch.hpp"

namespace adaptive_localization {
namespace {

bool isRight(const Place& place, const Pose2& reference) {
  return distance(place.T_map_base, reference) <= kRightDistance &&
         std::abs(wrapAngle(place.T_map_base.theta - reference.theta)) <= kRightHeading;
}

void take(const std::vector<Place>& places, const Pose2& reference, SearchMetrics& metrics) {
  const bool right = !places.empty() && isRight(places.front(), reference);
  ++metrics.scans;
  metrics.right += right ? 1 : 0;
  metrics.among += std::any_of(places.begin(), places.end(),
                               [&](const Place& place) { return isRight(place, reference); })
                       ? 1
                       : 0;
  metrics.nowhere += places.empty() ? 1 : 0;
  metrics.ambiguous += places.size() > 1 ? 1 : 0;
  metrics.right_if_unique += right && places.size() == 1 ? 1 : 0;
  metrics.places_mean += static_cast<double>(places.size());
}

}  // namespace

SearchMetrics searchLog(const Log& log, Places& places, const ScanOptions& options, int count,
                        const RunProgress& progress) {
  const std::size_t wanted = std::min(static_cast<std::size_t>(count), log.scans.size());
  SearchMetrics metrics;
  std::vector<double> times;
  for (std::size_t k = 0; k < wanted; ++k) {
    if (progress) progress(k + 1);
    const std::size_t i = k * log.scans.size() / wanted;
    const LogScan& scan = log.scans[i];
    if (!scan.T_map_base) continue;
    Observations observations;
    try {
      observations = {scan.scan.stamp, toScan(scan.scan, scan.mount, options, velocityAt(log, i))};
    } catch (const std::invalid_argument&) {
      continue;  // counted by runLog, which reads the whole log
    }
    places.energyGrid(observations.scan);  // made once, not timed
    const Stopwatch watch;
    const std::vector<Place> found = places.search(observations).value();  // work is unlimited
    times.push_back(watch.milliseconds());
    take(found, *scan.T_map_base, metrics);
  }
  if (metrics.scans == 0) {
    throw std::invalid_argument("--search: no scan has a reference pose, expected some");
  }
  metrics.places_mean /= metrics.scans;
  metrics.ms_median = quantile(times, 0.5);
  metrics.ms_p95 = quantile(times, 0.95);
  metrics.ms_max = largest(times);
  return metrics;
}

nlohmann::json toJson(const SearchMetrics& metrics) {
  nlohmann::json json;
  json["scans"] = metrics.scans;
  json["right"] = metrics.right;
  json["among"] = metrics.among;
  json["ambiguous"] = metrics.ambiguous;
  json["right_if_unique"] = metrics.right_if_unique;
  json["nowhere"] = metrics.nowhere;
  json["places_mean"] = metrics.places_mean;
  json["search_ms"] = {
      {"median", metrics.ms_median}, {"p95", metrics.ms_p95}, {"max", metrics.ms_max}};
  return json;
}

std::string summarize(const SearchMetrics& metrics) {
  const int unique = metrics.scans - metrics.ambiguous - metrics.nowhere;
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << metrics.scans
       << " scans, each alone: the best place "
       << "is right for " << metrics.right << ", one of " << metrics.places_mean
       << " places on average for " << metrics.among << "; one place only for " << unique
       << ", right for " << metrics.right_if_unique << " of these; none for " << metrics.nowhere
       << "; " << metrics.ms_median << " ms per search, " << metrics.ms_p95 << " ms for 95 %, "
       << metrics.ms_max << " ms at most";
  return text.str();
}

}  // namespace adaptive_localization
