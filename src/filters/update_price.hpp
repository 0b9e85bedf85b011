// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "adaptive_localization/core/options.hpp"
#include "adaptive_localization/observation/observation_model.hpp"

namespace adaptive_localization {

/// Refuses sizes with which one update of a particle filter would hold up a robot for seconds: so
/// many particles, so many beams, and what the observation model takes for a beam. Priced in
/// look-ups of the likelihood field, which are the same on every machine.
/// Throws std::invalid_argument naming options, values and price.
void checkPriceOfUpdate(const Parameters& given, const ObservationDescription& model);

}  // namespace adaptive_localization
