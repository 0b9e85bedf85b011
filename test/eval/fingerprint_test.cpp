// SPDX-License-Identifier: BSD-3-Clause
#include "eval/fingerprint.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "toy_experiment.hpp"

namespace adaptive_localization {
namespace {

TEST(Fingerprint, IsAnotherWhereTheImageOfTheMapIs) {
  const ToyExperiment toy;
  const std::string before = toy.load("").cases.front().fingerprint;
  EXPECT_EQ(toy.load("").cases.front().fingerprint, before);
  std::filesystem::resize_file(toy.folder().file("map.pgm"), 100);
  EXPECT_NE(toy.load("").cases.front().fingerprint, before);
}

/// Wherever they are.
TEST(Fingerprint, IsThatOfTheContentsOfTheFilesThatOptionsName) {
  const TempFolder here, there;
  const auto optionsWith = [](const std::string& file) {
    Parameters parameters;
    parameters.set("line_map", OptionValue(file));
    return parameters;
  };
  const std::string before = fingerprint(optionsWith(here.write("walls.yaml", "outline: []\n")));
  EXPECT_EQ(fingerprint(optionsWith(there.write("walls.yaml", "outline: []\n"))), before);
  EXPECT_NE(fingerprint(optionsWith(here.write("walls.yaml", "outline: [[0, 0]]\n"))), before);
}

/// They are refused by who loads them, with better words.
TEST(Fingerprint, TakesMapsThatAreNone) {
  const ToyExperiment toy;
  toy.folder().write("map.yaml", "resolution: 0.05\n");
  EXPECT_NO_THROW(toy.load(""));
  const TempFolder folder;
  Parameters parameters;
  parameters.set("line_map", OptionValue(folder.file("")));
  EXPECT_NO_THROW(fingerprint(parameters));
}

TEST(Fingerprint, IsAnotherForOtherOptions) {
  Parameters parameters;
  parameters.set("seed", 1);
  const std::string before = fingerprint(parameters);
  parameters.set("seed", 2);
  EXPECT_NE(fingerprint(parameters), before);
}

}  // namespace
}  // namespace adaptive_localization
