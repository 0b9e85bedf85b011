// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "map/evidence_grid.hpp"

namespace adaptive_localization {

/// moravec-elfes, elfes and konolige: in the order of their years.
const std::vector<std::string>& evidenceModels();

/// A grid that knows nothing yet. Throws std::invalid_argument listing the names if there is no
/// such model.
std::unique_ptr<EvidenceGrid> makeEvidenceGrid(const std::string& model, const Lattice& lattice,
                                               const EvidenceOptions& options = {});

}  // namespace adaptive_localization
