// SPDX-License-Identifier: BSD-3-Clause
#include "map/evidence_models.hpp"

#include <stdexcept>

#include "map/elfes_grid.hpp"
#include "map/konolige_grid.hpp"
#include "map/moravec_elfes_grid.hpp"

namespace adaptive_localization {

const std::vector<std::string>& evidenceModels() {
  static const std::vector<std::string> all{"moravec-elfes", "elfes", "konolige"};
  return all;
}

std::unique_ptr<EvidenceGrid> makeEvidenceGrid(const std::string& model, const Lattice& lattice,
                                               const EvidenceOptions& options) {
  if (model == "moravec-elfes") return std::make_unique<MoravecElfesGrid>(lattice, options);
  if (model == "elfes") return std::make_unique<ElfesGrid>(lattice, options);
  if (model == "konolige") return std::make_unique<KonoligeGrid>(lattice, options);
  throw std::invalid_argument("model: got '" + model +
                              "', expected one of moravec-elfes, elfes, konolige");
}

}  // namespace adaptive_localization
