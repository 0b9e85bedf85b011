// SPDX-License-Identifier: BSD-3-Clause
#include "kalman_filters.hpp"

#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "adaptive_localization/observation/composed_model.hpp"
#include "ekf_icp.hpp"
#include "elsewhere.hpp"
#include "match/line_matcher.hpp"
#include "presets.hpp"
#include "shared_parts.hpp"

namespace adaptive_localization {
namespace {

/// The walls that lines are matched with; nothing where hits are.
std::optional<std::vector<Segment>> surfacesFor(const std::string& landmarks,
                                                const Parameters& given, const Lattice& lattice) {
  if (landmarks == "hits") return std::nullopt;
  const std::string file = given.read<MatchOptions>().line_map;
  if (!file.empty()) return loadLineMap(file, lattice);
  throw std::invalid_argument(
      "option 'line_map': got '', expected a floor plan, as ekf_landmarks is 'lines'");
}

std::unique_ptr<Filter> makeEkfIcp(const FilterContext& context) {
  const Parameters& given = context.parameters;
  const Ground& ground = context.ground;
  const auto options = given.read<EkfOptions>();
  const auto matching = given.read<MatchOptions>();
  const auto lines = given.read<LineOptions>();
  PlaceSamplerOptions places;
  places.place_ser_share = 0.0;  // the best places alone
  const auto surfaces = surfacesFor(options.ekf_landmarks, given, ground.map->lattice());
  EkfParts parts{
      makeMotionModel(context.models.motions, given),
      surfaces ? matchBy(LineMatcher(lines, *surfaces)) : matchBy(scanMatcherFor(ground, matching)),
      std::make_unique<PlaceSampler>(places, placesFor(ground, given), ground.map),
      makeSenses(context.models.senses, given, ground.map, ground.field)};
  if (surfaces) parts.sonars.emplace(lines, *surfaces);
  auto scans = makeObservationModel(context.models.observations, given, ground.map, ground.field);
  const bool hits_slide = ground.field->quality().hasThickWalls() && matching.line_map.empty();
  if (options.ekf_weigh_cloud && hits_slide) parts.scans = std::move(scans);
  return std::make_unique<EkfIcp>(options, std::move(parts), context.seed);
}

}  // namespace

FilterDescription ekfIcp() {
  std::vector<OptionDescription> all;
  for (const auto& rows : {describe(MotionChoice{}), describe(ObservationChoice{}),
                           describe(EkfOptions{}), describe(LineOptions{})}) {
    all.insert(all.end(), rows.begin(), rows.end());
  }
  return {"ekf_icp",
          "Extended Kalman filter on odometry, corrected by matching scans with the map.",
          makeEkfIcp,
          std::move(all),
          {{"recovery", true}, {"update_min_d", 0.0}, {"update_min_a", 0.0}},
          sourceOfEkfIcp()};
}

}  // namespace adaptive_localization
