// SPDX-License-Identifier: BSD-3-Clause
#include "grid_filters.hpp"

#include <algorithm>

#include "adaptive_localization/observation/composed_model.hpp"
#include "markov_filter.hpp"
#include "presets.hpp"

namespace adaptive_localization {
namespace {

/// Scans are weighed with the deviation that hits have from anywhere within a cell.
std::unique_ptr<ObservationModel> makeScanModel(const FilterContext& context,
                                                const MarkovOptions& options) {
  const Ground& ground = context.ground;
  Parameters given = context.parameters;
  const double sigma = sigmaHit(given.read<ObservationOptions>(), ground.field->quality());
  given.set("laser_sigma_hit", OptionValue(sigmaInCells(sigma, options)));
  given.set("laser_sigma_sparse", OptionValue(0.0));  // cells are everywhere
  auto model = makeObservationModel(context.models.observations, given, ground.map, ground.field);
  const std::vector<std::string> unread = given.unknownKeys();
  for (const std::string& key : context.parameters.unknownKeys()) {
    if (std::find(unread.begin(), unread.end(), key) == unread.end()) {
      context.parameters.acknowledge(key);
    }
  }
  return model;
}

std::unique_ptr<Filter> makeMarkov(const FilterContext& context) {
  const Parameters& given = context.parameters;
  const Ground& ground = context.ground;
  auto options = given.read<MarkovOptions>();
  options.markov_cell = std::max(options.markov_cell, ground.map->lattice().resolution());
  const auto& observations = context.models.observations;
  checkPriceOfCells(options, *ground.map, given.read<ScanOptions>().laser_max_beams,
                    observations.find(given.read<ObservationChoice>().laser_model_type).price);
  auto senses = makeSenses(context.models.senses, given, ground.map, ground.field);
  senses->add(makeScanModel(context, options));
  MarkovParts parts{makeMotionModel(context.models.motions, given), std::move(senses), ground.map};
  return std::make_unique<MarkovFilter>(options, std::move(parts), context.seed);
}

}  // namespace

FilterDescription markov() {
  std::vector<OptionDescription> all;
  for (const auto& rows :
       {describe(MotionChoice{}), describe(ObservationChoice{}), describe(MarkovOptions{})}) {
    all.insert(all.end(), rows.begin(), rows.end());
  }
  return {"markov",
          "Markov localization: a histogram over all poses, for small maps.",
          makeMarkov,
          std::move(all),
          {{"recovery", true}, {"refine", true}},
          sourceOfMarkov()};
}

}  // namespace adaptive_localization
