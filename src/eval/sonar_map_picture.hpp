// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "eval/sonar_map.hpp"

namespace adaptive_localization {

/// Draws the probabilities of maps in grey, black being occupied, with the path of the robot, and
/// the true surfaces beside them if they are given. Throws std::runtime_error naming the file that
/// could not be written.
void saveMaps(const std::vector<SonarMap>& maps, const std::optional<OccupancyGrid>& surfaces,
              const SonarDrive& drive, const std::string& file);

/// Draws what single readings of 1, 2, 3 m and so on, below the greatest range, tell of a cell on
/// the axis of the sonar, and of one on the arc, for each of the models, with such cells, m.
void saveProfiles(const std::vector<std::string>& models, const EvidenceOptions& options,
                  const SonarReading& sonar, double resolution, const std::string& file);

}  // namespace adaptive_localization
