// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace adaptive_localization {

/// A share with its confidence interval.
struct Share {
  int of{0};
  int count{0};
  double value{0.0};
  double low{0.0}, high{1.0};
};

/// The Wilson score interval (Wilson 1927) at the standard normal quantile z, 1.96 for 95 %:
/// unlike the textbook interval it makes sense for few trials and for shares near 0 and 1.
Share wilson(int count, int of, double z = 1.959963984540054);

}  // namespace adaptive_localization
