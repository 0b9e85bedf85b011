// SPDX-License-Identifier: BSD-3-Clause
#include "update_price.hpp"

#include <sstream>
#include <stdexcept>

#include "adaptive_localization/core/scan.hpp"
#include "adaptive_localization/observation/observation_model.hpp"
#include "adaptive_localization/particle/sample_size.hpp"

namespace adaptive_localization {
namespace {

// In look-ups, of 0.45 ns each on a core of 3 GHz.
constexpr double kRay = 500.0;       // a ray that is cast
constexpr double kParticle = 500.0;  // to move, count and draw one, whatever the beams
constexpr double kLimit = 5e9;       // 2.3 s; the default sizes with the beam model are within

double perBeam(const std::string& model) {
  return model == "beam" || model == "inverse_l1" ? kRay : 1.0;
}

}  // namespace

void checkPriceOfUpdate(const Parameters& given) {
  const int particles = given.read<SampleSizeOptions>().max_particles;
  const int beams = given.read<ScanOptions>().laser_max_beams;
  const std::string model = given.read<ObservationOptions>().laser_model_type;
  const double price = particles * (kParticle + beams * perBeam(model));
  if (price <= kLimit) return;
  std::ostringstream text;
  text << "option 'max_particles': got '" << particles << "', which with laser_max_beams " << beams
       << " and laser_model_type " << model << " takes " << price
       << " look-ups per update, expected at most " << kLimit << " (seconds of a fast core)";
  throw std::invalid_argument(text.str());
}

}  // namespace adaptive_localization
