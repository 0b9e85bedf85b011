// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "adaptive_localization/filters/filter.hpp"
#include "adaptive_localization/localizer/setup.hpp"
#include "adaptive_localization/observation/composed_model.hpp"
#include "estimate_refiner.hpp"

namespace adaptive_localization {

/// A map, and what filter, senses and matching make of it with the options of a localizer.
struct PreparedMap {
  /// Throws std::invalid_argument naming key, value and range when a parameter is wrong or when the
  /// map has no free cell.
  PreparedMap(std::shared_ptr<const SetupReader> the_reader, Setup the_setup, Ground the_ground);

  std::shared_ptr<const SetupReader> reader;  // the filter may refer to its models
  Setup setup;
  Ground ground;
  std::unique_ptr<Filter> filter;
  Senses senses;
  std::unique_ptr<EstimateRefiner> refiner;  // if estimates are to be refined
};

}  // namespace adaptive_localization
