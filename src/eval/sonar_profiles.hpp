// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "adaptive_localization/core/observations.hpp"
#include "map/evidence_grid.hpp"

namespace adaptive_localization {

/// What single readings of 1, 2, 3 m and so on, below the greatest range, tell of a cell of such a
/// size (m), for each of the models: its probability on the axis of the sonar over the distance
/// (m), on the arc of the reading over the bearing (degrees), and half way before it. scripts/draw
/// draws it.
nlohmann::json sonarProfiles(const std::vector<std::string>& models, const EvidenceOptions& options,
                             const SonarReading& sonar, double resolution);

}  // namespace adaptive_localization
