// SPDX-License-Identifier: BSD-3-Clause
#include "free_memory.hpp"

#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

namespace adaptive_localization {
namespace {

constexpr int kLargeBlock = 4 << 20;  // bytes: fields and grids of maps, nothing of an update
constexpr double kUnknown = std::numeric_limits<double>::infinity();

double availableToAll() {
  std::ifstream file("/proc/meminfo");
  for (std::string key, rest; file >> key && std::getline(file, rest);) {
    if (key == "MemAvailable:") return 1024.0 * std::stod(rest);
  }
  return kUnknown;
}

double leftByLimit() {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return kUnknown;
  double pages = 0.0;
  std::ifstream("/proc/self/statm") >> pages;
  return static_cast<double>(limit.rlim_cur) - pages * static_cast<double>(sysconf(_SC_PAGESIZE));
}

}  // namespace

double freeMemory() {
  return std::min(availableToAll(), leftByLimit());
}

void returnFreedBlocks() {
  mallopt(M_MMAP_THRESHOLD, kLargeBlock);
}

}  // namespace adaptive_localization
