// SPDX-License-Identifier: BSD-3-Clause
#include "localizer/proof.hpp"

#include <gtest/gtest.h>

#include <utility>

namespace adaptive_localization {
namespace {

constexpr double kRough = 0.075;  // m
constexpr bool kFits = true, kFitsBadly = false;
constexpr Pose2 kMetre{1.0, 0.0, 0.0};

/// So many metres until it is given, 100 if it never is.
int metresUntilGiven(Proof proof) {
  int metres = 0;
  for (; metres < 100 && !proof.isGiven(); ++metres) proof.drive(kMetre, kFits);
  return metres;
}

TEST(Proof, IsDemandedOfNoPlaceThatSomebodyTold) {
  Proof proof(kRough);
  EXPECT_TRUE(proof.isGiven());
  proof.demand();
  EXPECT_FALSE(proof.isGiven());
  proof.waive();
  EXPECT_TRUE(proof.isGiven());
}

TEST(Proof, TakesAWayThatGrowsWithTheSquareOfTheRoughness) {
  for (const auto& [roughness, metres] : {std::pair{0.0, 0}, {kRough, 7}, {2.0 * kRough, 28}}) {
    Proof proof(roughness);
    proof.demand();
    EXPECT_EQ(metresUntilGiven(proof), metres) << roughness;
  }
}

TEST(Proof, TakesAsMuchMoreWayForEachPlaceThatGaveWay) {
  Proof proof(0.0);
  proof.demand();
  proof.refute();
  proof.refute();
  EXPECT_EQ(metresUntilGiven(proof), 3);
  EXPECT_TRUE(proof.isEnoughForTheMap());
  Proof on_another_map(kRough);
  on_another_map.copyStateOf(proof);
  EXPECT_EQ(metresUntilGiven(on_another_map), 10);
  proof.forgetRefuted();
  EXPECT_EQ(metresUntilGiven(proof), 0);
}

TEST(Proof, IsNotGivenByTurningOnTheSpot) {
  Proof proof(kRough);
  proof.demand();
  for (int i = 0; i < 1000; ++i) proof.drive({0.0, 0.0, 0.5}, kFits);
  EXPECT_EQ(metresUntilGiven(proof), 7);
}

TEST(Proof, StartsAgainWhereScansUsuallyFitBadly) {
  Proof proof(kRough);
  proof.demand();
  for (int i = 0; i < 10; ++i) proof.drive(kMetre, kFits);
  EXPECT_TRUE(proof.isGiven());
  proof.drive(kMetre, kFitsBadly);
  EXPECT_EQ(metresUntilGiven(proof), 7);
}

TEST(Proof, OnAnotherMapKeepsTheWayDriven) {
  Proof before(kRough), after(2.0 * kRough);
  before.demand();
  for (int i = 0; i < 10; ++i) before.drive(kMetre, kFits);
  after.copyStateOf(before);
  EXPECT_EQ(metresUntilGiven(after), 18);
}

TEST(Proof, SuspectsAPlaceForFiveMetresOfFittingScansOrUntilItIsTrusted) {
  Proof proof;
  EXPECT_FALSE(proof.isSuspect());
  proof.suspect();
  Proof other;
  other.copyStateOf(proof);
  for (int metre = 0; metre < 5; ++metre) {
    EXPECT_TRUE(proof.isSuspect());
    proof.drive(kMetre, kFitsBadly);
    proof.drive(kMetre, kFits);
  }
  EXPECT_FALSE(proof.isSuspect());
  EXPECT_TRUE(other.isSuspect());
  other.trust();
  EXPECT_FALSE(other.isSuspect());
}

}  // namespace
}  // namespace adaptive_localization
