// SPDX-License-Identifier: BSD-3-Clause
#include "update_price.hpp"

#include <sstream>
#include <stdexcept>

#include "adaptive_localization/core/scan.hpp"
#include "particle/sample_size.hpp"

namespace adaptive_localization {
namespace {

// In look-ups, of 0.45 ns each on a core of 3 GHz.
constexpr double kParticle = 500.0;  // to move, count and draw one, whatever the beams
constexpr double kLimit = 5e9;       // 2.3 s; the default sizes with the beam model are within

}  // namespace

void checkPriceOfUpdate(const Parameters& given, const ObservationDescription& model) {
  const int particles = given.read<SampleSizeOptions>().max_particles;
  const int beams = given.read<ScanOptions>().laser_max_beams;
  const double price = particles * (kParticle + beams * model.price);
  if (price <= kLimit) return;
  std::ostringstream text;
  text << "option 'max_particles': got '" << particles << "', which with laser_max_beams " << beams
       << " and laser_model_type " << model.name << " takes " << price
       << " look-ups per update, expected at most " << kLimit << " (seconds of a fast core)";
  throw std::invalid_argument(text.str());
}

}  // namespace adaptive_localization
