// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "eval/metrics.hpp"

namespace adaptive_localization {

/// What a run was made with.
struct RunDescription {
  std::string log, map, filter;
  int seed{1};
  int threads{1};
  std::string start{};  // where, in words; empty: not told
  std::string spoil{};  // what was spoiled, KIND:AMOUNT with commas between; empty: nothing
  std::uint64_t spoil_seed{1};
  LaserMount mount{};  // of the first scan
};

/// Description and numbers of a run; the errors are null without a reference.
nlohmann::json toJson(const RunDescription& description, const Metrics& metrics);

/// The same in one line for people.
std::string summarize(const RunDescription& description, const Metrics& metrics);

/// A table with a line for each scan, empty where there is no reference; metres, radians,
/// milliseconds. Throws std::runtime_error naming the file that could not be written.
void saveScans(const RunRecord& run, const std::string& file);

/// Modes as x, y, yaw, mass; hits as x, y and how far they are from the map's walls.
nlohmann::json toJson(const std::vector<RunView>& views);

/// Throws std::runtime_error naming the file that could not be written.
void saveJson(const nlohmann::json& json, const std::string& file);

}  // namespace adaptive_localization
