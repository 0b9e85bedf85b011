// SPDX-License-Identifier: BSD-3-Clause
#include "grid_cache.hpp"

#include <xxhash.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <utility>

#include "range_blocks.hpp"

namespace adaptive_localization {
namespace {

namespace fs = std::filesystem;

constexpr const char* kExtension = ".ser_grid";
constexpr std::size_t kFilesKept = 8;
constexpr double kEdition = 3.0;  // of what is in the files: to be raised when ranges change

std::uint64_t hashOf(const std::vector<double>& values, std::uint64_t seed) {
  return XXH64(values.data(), values.size() * sizeof(double), seed);
}

/// Removes the files used longest ago, and what crashed programs left of theirs.
void tidy(const std::string& folder) {
  std::vector<std::pair<fs::file_time_type, fs::path>> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const bool is_ours = entry.path().filename().string().find(kExtension) != std::string::npos;
    if (is_ours) files.emplace_back(entry.last_write_time(error), entry.path());
  }
  std::sort(files.rbegin(), files.rend());
  for (std::size_t i = kFilesKept; i < files.size(); ++i) fs::remove(files[i].second, error);
}

}  // namespace

GridCache::GridCache(std::string folder, const OccupancyGrid& map)
    : folder_(std::move(folder)), map_(map) {}

std::uint64_t GridCache::keyOf(double max_range, int spacing) const {
  const Lattice& lattice = map_.lattice();
  const std::uint64_t cells = XXH64(map_.cells().data(), map_.cells().size(), 0);
  return hashOf(
      {kEdition, double(lattice.width()), double(lattice.height()), lattice.resolution(),
       lattice.origin().x, lattice.origin().y, lattice.origin().theta, max_range, double(spacing)},
      cells);
}

std::string GridCache::fileOf(const std::string& kind, std::uint64_t key) const {
  char digits[17];
  std::snprintf(digits, sizeof(digits), "%016llx", static_cast<unsigned long long>(key));
  return folder_ + "/" + kind + "_" + digits + kExtension;
}

/// Says that the file is in use, too.
bool GridCache::isThere(const std::string& file) const {
  std::error_code error;
  if (folder_.empty() || !fs::exists(file, error)) return false;
  fs::last_write_time(file, fs::file_time_type::clock::now(), error);
  return true;
}

void GridCache::write(const std::string& file, std::uint64_t key,
                      const std::vector<ArrayFile::Bytes>& arrays) {
  had_all_ = false;
  if (folder_.empty()) return;
  std::error_code error;
  fs::create_directories(folder_, error);
  try {
    ArrayFile::write(file, key, arrays);
    tidy(folder_);
  } catch (const std::runtime_error& exception) {
    warnings_.push_back("cache_dir " + folder_ + ": cannot be written to (" + exception.what() +
                        "); energy grids are made anew at each start");
    folder_.clear();
  }
}

std::shared_ptr<const RangeTable> GridCache::read(const std::string& file, std::uint64_t key,
                                                  double max_range) const {
  const ArrayFile arrays(file, key);
  std::shared_ptr<RangeTable> table(new RangeTable(map_.lattice()));
  table->max_range_ = max_range;
  table->spacing_ = arrays.array<std::int32_t>(0)[0];
  table->cells_ = arrays.array<std::uint32_t>(1);
  table->ranges_ = arrays.array<std::uint8_t>(2);
  const RangeBlocks::Arrays blocks{arrays.array<std::uint32_t>(3), arrays.array<std::uint32_t>(4),
                                   arrays.array<std::uint8_t>(5), arrays.array<std::uint8_t>(6)};
  table->blocks_ = std::make_shared<const RangeBlocks>(blocks);
  return table;
}

std::shared_ptr<const RangeTable> GridCache::ranges(double max_range, int spacing,
                                                    const StopToken& stop) {
  const std::uint64_t key = folder_.empty() ? 0 : keyOf(max_range, spacing);
  const std::string file = fileOf("ranges", key);
  if (isThere(file)) {
    try {
      return read(file, key, max_range);
    } catch (const std::runtime_error& error) {
      warnings_.push_back(std::string(error.what()) + "; made anew");
    }
  }
  auto table = std::make_shared<const RangeTable>(map_, max_range, spacing, stop);
  const ConstArray<std::int32_t> made_with(std::vector<std::int32_t>{table->spacing()});
  const RangeBlocks::Arrays& blocks = table->blocks().arrays();
  write(file, key,
        {ArrayFile::bytesOf(made_with), ArrayFile::bytesOf(table->cells_),
         ArrayFile::bytesOf(table->ranges_), ArrayFile::bytesOf(blocks.cells),
         ArrayFile::bytesOf(blocks.starts), ArrayFile::bytesOf(blocks.low),
         ArrayFile::bytesOf(blocks.high)});
  return table;
}

std::shared_ptr<const EnergyGrid> GridCache::grid(std::shared_ptr<const RangeTable> ranges,
                                                  const ScanGeometry& geometry,
                                                  const EnergyGridOptions& options,
                                                  const StopToken& stop) {
  const std::uint64_t key =
      folder_.empty() ? 0
                      : hashOf({double(geometry.count), geometry.spacing,
                                double(options.energy_beams), double(options.energy_orientations)},
                               keyOf(ranges->maxRange(), ranges->spacing()));
  const std::string file = fileOf("energies", key);
  if (isThere(file)) {
    try {
      const ArrayFile arrays(file, key);
      EnergyGrid::Sorted sorted{arrays.array<std::uint32_t>(0), arrays.array<std::uint32_t>(1)};
      return std::shared_ptr<const EnergyGrid>(
          new EnergyGrid(std::move(ranges), geometry, options, std::move(sorted)));
    } catch (const std::runtime_error& error) {
      warnings_.push_back(std::string(error.what()) + "; made anew");
    }
  }
  auto grid = std::make_shared<const EnergyGrid>(std::move(ranges), geometry, options, stop);
  write(file, key,
        {ArrayFile::bytesOf(grid->sorted_.poses), ArrayFile::bytesOf(grid->sorted_.starts)});
  return grid;
}

}  // namespace adaptive_localization
