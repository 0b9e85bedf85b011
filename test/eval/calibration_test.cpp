// SPDX-License-Identifier: BSD-3-Clause
#include "eval/calibration.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

namespace adaptive_localization {
namespace {

using testing::ElementsAre;

TEST(Calibration, CountsByTenthsOfConfidence) {
  Calibration calibration;
  calibration.note(0.0, 5.0);
  calibration.note(0.05, 0.1);
  calibration.note(0.55, 0.29);
  calibration.note(0.5, 0.3);
  calibration.note(0.9, 0.0);
  calibration.note(1.0, 0.0);
  EXPECT_THAT(calibration.scans, ElementsAre(2, 0, 0, 0, 0, 2, 0, 0, 0, 2));
  EXPECT_THAT(calibration.near, ElementsAre(1, 0, 0, 0, 0, 1, 0, 0, 0, 2));
}

TEST(Calibration, CountsConfidenceBeyondItsEndsThere) {
  Calibration calibration;
  calibration.note(-1e-9, 0.0);
  calibration.note(1.0 + 1e-9, 0.0);
  EXPECT_EQ(calibration.scans.front(), 1);
  EXPECT_EQ(calibration.scans.back(), 1);
}

TEST(Calibration, IsWrittenWithBothCounts) {
  Calibration calibration;
  calibration.note(0.35, 0.1);
  calibration.note(0.36, 0.5);
  const nlohmann::json json = calibration;
  EXPECT_EQ(json.at("scans").at(3), 2);
  EXPECT_EQ(json.at("near").at(3), 1);
}

}  // namespace
}  // namespace adaptive_localization
