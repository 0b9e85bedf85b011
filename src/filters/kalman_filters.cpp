// SPDX-License-Identifier: BSD-3-Clause
#include "kalman_filters.hpp"

#include <stdexcept>

#include "adaptive_localization/match/line_matcher.hpp"
#include "adaptive_localization/observation/composed_model.hpp"
#include "ekf_icp.hpp"
#include "elsewhere.hpp"
#include "presets.hpp"

namespace adaptive_localization {
namespace {

MatchScan makeMatchScan(const std::string& landmarks, const Parameters& given,
                        const Ground& ground) {
  const auto options = given.read<MatchOptions>();
  const auto lines = given.read<LineOptions>();
  if (landmarks == "hits")
    return matchBy(makeScanMatcher(options, *ground.map, ground.field->quality()));
  if (options.line_map.empty()) {
    throw std::invalid_argument(
        "option 'line_map': got '', expected a floor plan, as ekf_landmarks is 'lines'");
  }
  return matchBy(LineMatcher(lines, loadLineMap(options.line_map, ground.map->lattice())));
}

std::unique_ptr<Filter> makeEkfIcp(const FilterContext& context) {
  const Parameters& given = context.parameters;
  const auto options = given.read<EkfOptions>();
  PlaceSamplerOptions places;
  places.place_ser_share = 0.0;  // the best places alone
  EkfParts parts{
      makeMotionModel(context.models.motions, given),
      makeMatchScan(options.ekf_landmarks, given, context.ground),
      std::make_unique<PlaceSampler>(places, placesFor(context.ground, given), context.ground.map),
      makeSenses(context.models.senses, given, context.ground.map, context.ground.field)};
  const Ground& ground = context.ground;
  auto scans = makeObservationModel(context.models.observations, given, ground.map, ground.field);
  const bool has_plan = !given.read<MatchOptions>().line_map.empty();
  const bool hits_slide = ground.field->quality().hasThickWalls() && !has_plan;
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
