// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "adaptive_localization/filters/filter.hpp"
#include "adaptive_localization/ser/place_sampler.hpp"

namespace adaptive_localization {

struct ElsewhereOptions {
  std::string elsewhere{"places"};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("elsewhere", elsewhere, Choices{"free", "ser", "places"},
           "Where a robot that may be anywhere is looked for: in all free space, where scans have "
           "the energy of the one just taken (SER), or at the places where it fits best.");
  }
};

/// The context's places, or places of one's own.
std::shared_ptr<Places> placesFor(const FilterContext& context);

/// Draws poses elsewhere, as the options say.
std::unique_ptr<PoseSampler> makeSampler(const FilterContext& context,
                                         const std::shared_ptr<Places>& places);

}  // namespace adaptive_localization
