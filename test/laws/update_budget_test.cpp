// SPDX-License-Identifier: BSD-3-Clause
// On a large map no update searches for longer than its budget allows, whatever becomes of the
// robot.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>

#include "adaptive_localization/localizer/localizer.hpp"
#include "ser/places.hpp"
#include "support/pose_matchers.hpp"
#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

constexpr int kRooms = 10, kRoom = 12;            // along each side; characters, with one wall
constexpr int kCellsPerCharacter = 10;            // of 5 cm
constexpr double kBudget = 5.0;                   // ms
constexpr SearchWork kStep = 10000;               // of a search, at the most
const double kSide = 0.5 * (kRooms * kRoom + 1);  // m, of a map of 1 200 x 1 200 cells

/// A hundred rooms of 5.5 m, each with other furniture, and doors between all.
std::shared_ptr<const OccupancyGrid> office() {
  constexpr int kSize = kRooms * kRoom + 1;
  Art art(kSize, std::string(kSize, '.'));
  Rng rng(3);
  for (int row = 0; row < kSize; ++row) {
    for (int column = 0; column < kSize; ++column) {
      const bool is_wall = row % kRoom == 0 || column % kRoom == 0;
      const bool is_door = row % kRoom == kRoom / 2 || column % kRoom == kRoom / 2;
      const bool is_rim = row % (kSize - 1) == 0 || column % (kSize - 1) == 0;
      if (is_rim || (is_wall && !is_door)) {
        art[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] = '#';
      }
    }
  }
  for (int room = 0; room < kRooms * kRooms; ++room) {
    for (int n = 0; n < 3; ++n) {  // off the ways from door to door
      const auto at = [&](int first) {
        const int along = 1 + static_cast<int>(rng.below(3)) + (rng.below(2) == 0 ? 0 : 7);
        return static_cast<std::size_t>(first * kRoom + along);
      };
      art[at(room / kRooms)][at(room % kRooms)] = '#';
    }
  }
  return hollow(*toyWorld(art, 0.05, {}, kCellsPerCharacter));
}

class LargeMap : public testing::Test {
 protected:
  LargeMap() {
    map_ = office();
    const auto field = std::make_shared<const DistanceField>(*map_);
    places_ = std::make_shared<Places>(map_, field, EnergyGridOptions{}, GlobalSearchOptions{});
    Parameters parameters;
    parameters.set("filter", std::string("sa_kld"));
    parameters.set("update_budget", kBudget);
    localizer_ = std::make_unique<Localizer>(parameters, Ground(map_, field, places_));
  }

  /// Drives on, with noise on the ranges.
  Localization drive(const Pose2& motion) {
    truth_ = truth_ * motion;
    T_odom_base_ = T_odom_base_ * motion;
    Observations seen = ToyLaser{181, -kPi / 2, kPi / 2, 20.0}.observe(map_, truth_);
    for (Eigen::Index i = 0; i < seen.scan.range.size(); ++i) {
      const auto off = static_cast<float>(rng_.normal(0.0, 0.01));
      seen.scan.range[i] += off;
      seen.scan.x[i] += off * std::cos(seen.scan.bearing[i]);
      seen.scan.y[i] += off * std::sin(seen.scan.bearing[i]);
    }
    seen.stamp = stamp_ += 0.1;
    const Localization answer = localizer_->update(T_odom_base_, seen);
    const SearchWork left = places_->workLeft();
    least_left_ = std::min(least_left_, left);
    if (left <= 0) ++cut_short_;
    return answer;
  }

  bool isRight(const Localization& answer) const {
    return testing::Value(answer.T_map_base, PoseNear(truth_, 0.2, 0.1));
  }

  std::shared_ptr<const OccupancyGrid> map_;
  std::shared_ptr<Places> places_;
  std::unique_ptr<Localizer> localizer_;
  Pose2 truth_, T_odom_base_;
  double stamp_{0.0};
  SearchWork least_left_{std::numeric_limits<SearchWork>::max()};
  int cut_short_{0};  // updates in which there was more to search for than could be done
  Rng rng_{1};
};

TEST_F(LargeMap, IsSearchedInParts) {
  const double middle = 0.5 * (kRoom / 2) + 0.25;  // of a room, m, where its doors are
  const Pose2 step{0.12, 0.0, 0.0};
  truth_ = {middle, middle, 0.0};
  localizer_->reset(Gaussian2{truth_, Eigen::Vector3d(0.01, 0.01, 0.003).asDiagonal()});
  drive({});  // the first scan is compared with the whole map at once
  for (int kidnap = 0; kidnap < 4; ++kidnap) {
    for (int i = 0; i < 60; ++i) drive(step);
    EXPECT_TRUE(isRight(drive(step))) << "before kidnapping " << kidnap;
    const double heading = kidnap % 2 == 0 ? kPi : -kPi / 2;
    truth_ = {kSide - middle - 12.0 * kidnap, kSide - middle, heading};
    int scans = 0;
    while (scans < 100 && !isRight(drive(step))) ++scans;
    EXPECT_LT(scans, 40) << "after kidnapping " << kidnap;
  }
  EXPECT_GE(cut_short_, 8) << "as if the map were small";
  EXPECT_GT(least_left_, -kStep) << cut_short_;
}

}  // namespace
}  // namespace adaptive_localization
