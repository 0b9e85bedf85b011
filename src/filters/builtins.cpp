// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/filters/builtins.hpp"

#include "builtin_filters.hpp"
#include "motion/differential_drive.hpp"
#include "motion/omni_drive.hpp"
#include "observation/heading_prior.hpp"
#include "observation/landmark_model.hpp"
#include "observation/likelihood_field.hpp"
#include "observation/range_models.hpp"
#include "observation/sonar_model.hpp"
#include "observation/thick_walls_field.hpp"

namespace adaptive_localization {
namespace {

using MapPtr = std::shared_ptr<const OccupancyGrid>;
using FieldPtr = std::shared_ptr<const DistanceField>;

template <class Drive>
MotionDescription motion(const std::string& name, const std::string& sentence, NoiseRule rule) {
  const auto make = [rule](const Parameters& given) {
    return std::make_unique<Drive>(given.read<MotionOptions>(), rule);
  };
  return {name, sentence, make, describe(MotionOptions{})};
}

void addMotions(Registry<MotionDescription>& motions) {
  motions.add(motion<DifferentialDrive>("diff-corrected", "A robot that turns and drives.",
                                        NoiseRule::kVariances));
  motions.add(motion<DifferentialDrive>(
      "diff", "As diff-corrected, with variances for standard deviations (amcl's older model).",
      NoiseRule::kDeviations));
  motions.add(motion<OmniDrive>("omni-corrected", "A robot that moves in any direction.",
                                NoiseRule::kVariances));
  motions.add(motion<OmniDrive>(
      "omni", "As omni-corrected, with variances for standard deviations (amcl's older model).",
      NoiseRule::kDeviations));
}

ObservationDescription likelihoodField(const std::string& name, const std::string& sentence,
                                       LikelihoodField::Form form) {
  const auto make = [form](const Parameters& given, const MapPtr& map,
                           const FieldPtr& field) -> std::unique_ptr<ObservationModel> {
    const auto options = given.read<ObservationOptions>();
    if (form == LikelihoodField::Form::kTempered && field->quality().hasThickWalls()) {
      return std::make_unique<ThickWallsField>(options, map, field);
    }
    return std::make_unique<LikelihoodField>(options, form, field);
  };
  return {name, sentence, make, describe(ObservationOptions{})};
}

template <class Make>
ObservationDescription rangeModel(const std::string& name, const std::string& sentence,
                                  const Make& make_from) {
  constexpr double kRay = 500.0;  // look-ups that take as long as a ray
  const auto make = [make_from](const Parameters& given, const MapPtr& map, const FieldPtr& field) {
    return make_from(given.read<ObservationOptions>(), map, field);
  };
  return {name, sentence, make, describe(ObservationOptions{}), kRay};
}

void addObservations(Registry<ObservationDescription>& observations) {
  using Form = LikelihoodField::Form;
  observations.add(likelihoodField(
      "likelihood_field", "How near hits are to walls, tempered: beams are not independent.",
      Form::kTempered));
  observations.add(likelihoodField("likelihood_field_prob",
                                   "As likelihood_field, not tempered (amcl's); may skip beams.",
                                   Form::kSum));
  observations.add(likelihoodField(
      "likelihood_field_cubed",
      "As likelihood_field, by one and the sum of cubes (amcl's older rule).", Form::kCubed));
  observations.add(
      rangeModel("beam", "Ranges against those expected by ray casting, tempered; slow.",
                 [](const ObservationOptions& options, const MapPtr& map, const FieldPtr& field) {
                   return std::make_unique<BeamModel>(options, map, field);
                 }));
  observations.add(rangeModel(
      "inverse_l1",
      "One by the sum of range errors, by ray casting (SAMCL's and SA-KLD's source); slow.",
      [](const ObservationOptions&, const MapPtr& map, const FieldPtr& field) {
        return std::make_unique<InverseL1>(map, field);
      }));
}

void addSenses(Registry<ObservationDescription>& senses) {
  const auto make = [](const Parameters&, const MapPtr&, const FieldPtr&) {
    return std::make_unique<HeadingPrior>();
  };
  senses.add({"heading", "What a compass says.", make, {}});
  senses.add({"landmarks", "What sightings of known landmarks say.",
              [](const Parameters& given, const MapPtr& map, const FieldPtr& field) {
                return std::make_unique<LandmarkModel>(given.read<LandmarkOptions>(), map, field);
              },
              describe(LandmarkOptions{})});
  senses.add({"sonar", "What echoes of sonars say.",
              [](const Parameters& given, const MapPtr& map, const FieldPtr& field) {
                return std::make_unique<SonarModel>(given.read<SonarOptions>(), map, field);
              },
              describe(SonarOptions{})});
}

void addResamplings(Registry<ResamplingDescription>& resamplings) {
  const auto add = [&](const std::string& name, const std::string& sentence, Resampling scheme) {
    resamplings.add({name, sentence, [scheme](const Parameters&) { return scheme; }, {}});
  };
  add("systematic", "All draws by one random number: the least variance.", systematicIndices);
  add("stratified", "A random number for each draw, evenly spread.", stratifiedIndices);
  add("multinomial", "Independent draws, as amcl has them.", multinomialIndices);
}

Registries makeBuiltins() {
  Registries registries;
  addMotions(registries.motions);
  addObservations(registries.observations);
  addSenses(registries.senses);
  addResamplings(registries.resamplings);
  for (auto& filter : builtinFilters()) registries.filters.add(std::move(filter));
  return registries;
}

}  // namespace

const Registries& builtins() {
  static const Registries all = makeBuiltins();
  return all;
}

}  // namespace adaptive_localization
