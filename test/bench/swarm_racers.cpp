// SPDX-License-Identifier: BSD-3-Clause
#include "bench/swarm_racers.hpp"

#include <algorithm>
#include <stdexcept>

namespace adaptive_localization {

std::vector<SwarmRacer> swarmRacers() {
  BatOptions repulsive = printedBats();
  repulsive.bat_repulsive = true;
  BatOptions no_leaps;
  no_leaps.bat_leap_share = 0.0;
  return {{"ba as printed", std::make_shared<BatMove>(repulsive)},
          {"ba, right sign", std::make_shared<BatMove>(printedBats())},
          {"ba improved", std::make_shared<BatMove>(BatOptions{})},
          {"lbba as printed", std::make_shared<BatMove>(printedBats(), printedLeaders())},
          {"lbba improved", std::make_shared<BatMove>(BatOptions{}, LeaderOptions{})},
          {"lbba improved, no leaps", std::make_shared<BatMove>(no_leaps, LeaderOptions{})},
          {"pso", std::make_shared<ParticleSwarmMove>()}};
}

std::vector<std::string> swarmNames() {
  std::vector<std::string> names;
  for (const SwarmRacer& racer : swarmRacers()) names.push_back(racer.name);
  return names;
}

std::vector<SwarmRacer> swarmRacers(const std::vector<std::string>& names) {
  const std::vector<SwarmRacer> all = swarmRacers();
  std::vector<SwarmRacer> chosen;
  for (const std::string& name : names) {
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const SwarmRacer& racer) { return racer.name == name; });
    if (found == all.end()) {
      std::string known;
      for (const SwarmRacer& racer : all) known += (known.empty() ? "" : "; ") + racer.name;
      throw std::invalid_argument("swarm: got '" + name + "', expected one of " + known);
    }
    chosen.push_back(*found);
  }
  return chosen;
}

}  // namespace adaptive_localization
