// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "adaptive_localization/core/options.hpp"
#include "ser/place_sampler.hpp"

namespace adaptive_localization {

struct ElsewhereOptions {
  std::string elsewhere{"places"};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("elsewhere", elsewhere, Choices{"free", "ser", "places"},
           "Where a robot that may be anywhere is looked for: free, in all free space; ser, where "
           "the energy is similar to the scan's; places, where the scan fits best.");
  }
};

/// Draws poses elsewhere, as the options say.
std::unique_ptr<PoseSampler> makeSampler(const Parameters& given,
                                         const std::shared_ptr<const OccupancyGrid>& map,
                                         const std::shared_ptr<Places>& places);

}  // namespace adaptive_localization
