// SPDX-License-Identifier: BSD-3-Clause
// Libraries that are no good as plug-ins, one for each value of BROKEN.
#include "adaptive_localization/filter_registry.hpp"

#if BROKEN == 1  // the entry point is a variable
extern "C" {
int adaptive_localization_register_filters_v1 = 1;
}
#elif BROKEN == 2  // it throws what is no std::exception
extern "C" void adaptive_localization_register_filters_v1(
    adaptive_localization::FilterRegistry& registry);
void adaptive_localization_register_filters_v1(adaptive_localization::FilterRegistry&) {
  throw 42;
}
#endif
