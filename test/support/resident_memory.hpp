// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <unistd.h>

#include <fstream>

namespace adaptive_localization {

/// Memory that this process has, MB.
inline double residentMegabytes() {
  std::ifstream statm("/proc/self/statm");
  double all = 0.0, resident = 0.0;  // pages
  statm >> all >> resident;
  return 1e-6 * resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

}  // namespace adaptive_localization
