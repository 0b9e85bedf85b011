// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/eval/calibration.hpp"

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
  const auto shares = calibration.shares();
  ASSERT_EQ(shares.size(), Calibration::kTenths);
  EXPECT_EQ(shares[0], 0.5);
  EXPECT_EQ(shares[1], std::nullopt);
  EXPECT_EQ(shares[5], 0.5);
  EXPECT_EQ(shares[9], 1.0);
}

TEST(Calibration, CountsConfidenceBeyondItsEndsThere) {
  Calibration calibration;
  calibration.note(-1e-9, 0.0);
  calibration.note(1.0 + 1e-9, 0.0);
  EXPECT_EQ(calibration.scans.front(), 1);
  EXPECT_EQ(calibration.scans.back(), 1);
}

TEST(Calibration, OfSeveralRunsIsTheirSum) {
  Calibration one, other;
  one.note(0.95, 0.1);
  other.note(0.95, 0.4);
  other.note(0.25, 0.4);
  one.add(other);
  EXPECT_EQ(one.scans[9], 2);
  EXPECT_EQ(one.near[9], 1);
  EXPECT_EQ(one.scans[2], 1);
}

TEST(Calibration, IsReadBackAsItWasWritten) {
  Calibration calibration;
  calibration.note(0.35, 0.1);
  calibration.note(0.36, 0.5);
  const auto back = nlohmann::json(calibration).get<Calibration>();
  EXPECT_EQ(back.scans, calibration.scans);
  EXPECT_EQ(back.near, calibration.near);
  EXPECT_THROW((nlohmann::json{{"scans", {1, 2}}, {"near", {1, 2}}}.get<Calibration>()),
               nlohmann::json::exception);
}

}  // namespace
}  // namespace adaptive_localization
