// SPDX-License-Identifier: BSD-3-Clause
#include "core/chi_square.hpp"

#include <boost/math/distributions/chi_squared.hpp>
#include <limits>

namespace adaptive_localization {

double chiSquare(int degrees, double probability) {
  if (probability >= 1.0) return std::numeric_limits<double>::infinity();
  return boost::math::quantile(boost::math::chi_squared(degrees), probability);
}

}  // namespace adaptive_localization
