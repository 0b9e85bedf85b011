// SPDX-License-Identifier: BSD-3-Clause
#include "elsewhere.hpp"

namespace adaptive_localization {

std::unique_ptr<PoseSampler> makeSampler(const Parameters& given,
                                         const std::shared_ptr<const OccupancyGrid>& map,
                                         const std::shared_ptr<Places>& places) {
  const auto options = given.read<PlaceSamplerOptions>();
  const std::string where = given.read<ElsewhereOptions>().elsewhere;
  if (where == "ser") return std::make_unique<SerSampler>(places, map);
  if (where == "free") return std::make_unique<FreeSpaceSampler>(map);
  return std::make_unique<PlaceSampler>(options, places, map);
}

}  // namespace adaptive_localization
