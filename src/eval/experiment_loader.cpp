// SPDX-License-Identifier: BSD-3-Clause
#include "eval/experiment_loader.hpp"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "experiment_values.hpp"
#include "fingerprint.hpp"
#include "yaml_value.hpp"

namespace adaptive_localization {
namespace {

const std::set<std::string> kCaseKeys{"label",       "world",  "map",        "route",     "start",
                                      "start_known", "told",   "simulation", "duration",  "events",
                                      "success",     "probes", "bounds",     "half_turn", "options",
                                      "cores",       "seeds"};

std::set<std::string> with(std::set<std::string> keys, const std::set<std::string>& more) {
  keys.insert(more.begin(), more.end());
  return keys;
}

std::string firstPart(const std::string& key) {
  return key.substr(0, key.find('.'));
}

bool isOfFile(const std::string& key) {
  return kCaseKeys.count(firstPart(key)) > 0 && firstPart(key) != "options";
}

/// {a: {b: value}} of a.b and value.
YAML::Node nested(const std::string& key, const std::string& value) {
  YAML::Node node;
  const auto dot = key.find('.');
  node[key.substr(0, dot)] =
      dot == std::string::npos ? YAML::Load(value) : nested(key.substr(dot + 1), value);
  return node;
}

YAML::Node overridden(YAML::Node node, const Overrides& overrides) {
  for (const auto& [key, value] : overrides) {
    if (isOfFile(key)) node = merged(node, nested(key, value));
  }
  return node;
}

void addOptions(const Overrides& overrides, Parameters& parameters) {
  for (const auto& [key, value] : overrides) {
    if (!isOfFile(key)) parameters.set(key, value);
  }
}

/// A case is what the file says in general, overlaid with what it says of the case, overlaid with
/// the command line.
YAML::Node caseNode(const YAML::Node& root, const YAML::Node& of_case, const Overrides& overrides) {
  YAML::Node general = YAML::Clone(root);
  for (const char* key : {"name", "sentence", "cases"}) general.remove(key);
  return overridden(of_case.IsMap() ? merged(general, of_case) : general, overrides);
}

std::vector<YAML::Node> caseNodes(const YamlValue& file, const Overrides& overrides) {
  if (!file.has("cases")) return {caseNode(file.node(), YAML::Node(), overrides)};
  std::vector<YAML::Node> nodes;
  for (const auto& of_case : file.at("cases").list("a list of cases")) {
    of_case.allowOnly(kCaseKeys);
    nodes.push_back(caseNode(file.node(), of_case.node(), overrides));
  }
  return nodes;
}

template <class Labelled>
void checkLabels(const std::vector<Labelled>& all, const YamlValue& where) {
  std::set<std::string> labels;
  for (const auto& one : all) {
    if (labels.insert(one.label).second) continue;
    throw std::invalid_argument(
        "file '" + where.file() + "': label '" + one.label + "' twice among the " +
        (where.key().empty() ? "cases" : where.key()) + ", expected different ones");
  }
}

/// A map of lines, or of landmarks, can be the world itself.
void replaceWorld(const std::string& world, Parameters& parameters) {
  for (const char* key : kMapOptions) {
    const auto option = parameters.values().find(key);
    if (option != parameters.values().end() && toText(option->second) == "world") {
      parameters.set(key, OptionValue(world));
    }
  }
}

std::vector<ExperimentCore> readCores(const YamlValue& value, const std::string& world,
                                      const Overrides& overrides) {
  std::vector<ExperimentCore> cores;
  for (const auto& entry : value.at("cores").list("a list of cores")) {
    cores.push_back(readCore(entry));
    if (value.has("options")) cores.back().parameters.fill(readOptions(value.at("options")));
    addOptions(overrides, cores.back().parameters);
    replaceWorld(world, cores.back().parameters);
  }
  checkLabels(cores, value.at("cores"));
  return cores;
}

void readSeeds(const YamlValue& value, ExperimentCase& result) {
  value.allowOnly({"first", "count"});
  if (value.has("first")) result.first_seed = value.at("first").whole({0, 1e9});
  if (value.has("count")) result.seeds = value.at("count").whole({1, 1e6});
}

ExperimentCase readCase(const YamlValue& value, const Overrides& overrides) {
  ExperimentCase result;
  readWorld(value, result);
  result.label = std::filesystem::path(result.world).parent_path().filename().string();
  if (value.has("label")) result.label = value.at("label").text();
  readDrive(value, result);
  if (value.has("events")) {
    for (const auto& entry : value.at("events").list("a list of events")) {
      result.events.push_back(readEvent(entry));
    }
  }
  if (value.has("success")) result.success = readSuccess(value.at("success"));
  if (value.has("probes")) {
    result.probes = value.at("probes").numbers(0, "a list of moments in seconds");
  }
  if (value.has("bounds")) result.has_bounds = value.at("bounds").truth();
  if (value.has("half_turn")) {
    const auto centre = value.at("half_turn").numbers(2, "a point [x, y] in metres");
    result.half_turn = Pose2{centre[0], centre[1], 0.0};
  }
  result.cores = readCores(value, result.world, overrides);
  if (value.has("seeds")) readSeeds(value.at("seeds"), result);
  result.fingerprint = fingerprint(value, result);
  return result;
}

YAML::Node load(const std::string& yaml_file) {
  try {
    return YAML::LoadFile(yaml_file);
  } catch (const std::exception& error) {
    throw std::invalid_argument("file '" + yaml_file + "': " + error.what());
  }
}

}  // namespace

Experiment loadExperiment(const std::string& yaml_file, const Overrides& overrides) {
  const YamlValue file(load(yaml_file), yaml_file);
  file.allowOnly(with(kCaseKeys, {"name", "sentence", "cases"}));
  Experiment experiment;
  experiment.name = file.at("name").text();
  experiment.sentence = file.at("sentence").text();
  for (const auto& node : caseNodes(file, overrides)) {
    experiment.cases.push_back(readCase(YamlValue(node, yaml_file), overrides));
    experiment.cases.back().experiment = experiment.name;
  }
  checkLabels(experiment.cases, file);
  return experiment;
}

}  // namespace adaptive_localization
