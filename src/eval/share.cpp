// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/eval/share.hpp"

#include <cmath>

namespace adaptive_localization {

Share wilson(int count, int of, double z) {
  if (of <= 0) return {};
  const double n = of, share = count / n;
  const double centre = (share + z * z / (2.0 * n)) / (1.0 + z * z / n);
  const double half =
      z / (1.0 + z * z / n) * std::sqrt(share * (1.0 - share) / n + z * z / (4.0 * n * n));
  const double low = count == 0 ? 0.0 : centre - half;  // without the rounding
  const double high = count == of ? 1.0 : centre + half;
  return {of, count, share, low, high};
}

}  // namespace adaptive_localization
