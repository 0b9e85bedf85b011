// SPDX-License-Identifier: BSD-3-Clause
// A file of the cache whose bytes were exchanged: it is made again, and says why.
#include "ser/grid_cache.hpp"

#include "fuzz/input_file.hpp"

namespace al = adaptive_localization;

namespace {

constexpr double kRange = 2.0;  // m

al::OccupancyGrid smallMap() {
  const al::Lattice lattice(8, 6, 0.25, {});
  std::vector<std::int8_t> cells(lattice.size(), al::OccupancyGrid::kFree);
  for (std::size_t i = 0; i < 8; ++i) cells[i] = al::OccupancyGrid::kOccupied;
  return {lattice, cells};
}

std::string onlyFileIn(const std::string& folder) {
  return std::filesystem::directory_iterator(folder)->path().string();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const al::OccupancyGrid map = smallMap();
  static const std::string folder = al::inputFolder().file("cache");
  static const auto right = al::GridCache(folder, map).ranges(kRange, 1);
  static const std::string file = onlyFileIn(folder);
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  return al::tryToRead([] {
    if (al::GridCache(folder, map).ranges(kRange, 1)->size() != right->size()) std::abort();
  });
}
