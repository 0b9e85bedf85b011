// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "swarm/objective.hpp"
#include "swarm/search_space.hpp"

namespace adaptive_localization {

/// A function of the plane with many local minima, by which optimisers are compared. Its least
/// value is 0, at the origin, or, once it is turned and shifted, at its centre.
class TestFunction : public Objective {
 public:
  using Formula = double (*)(double x, double y);
  TestFunction(std::string name, Formula formula, double half_width)
      : name_(std::move(name)), formula_(formula), half_width_(half_width) {}

  const std::string& name() const { return name_; }
  double operator()(double x, double y) const;
  void evaluate(const Eigen::ArrayXXd& positions, Eigen::Ref<Eigen::ArrayXd> costs) const override;

  /// The torus on which it is minimised.
  SearchSpace space() const;

  /// The same with its centre elsewhere and turned about that by so many rad: what is gained by
  /// searches along the axes, or in the middle of the space, is lost.
  TestFunction turned(double angle, const Eigen::Vector2d& centre) const;

 private:
  std::string name_;
  Formula formula_;
  double half_width_;
  double angle_{0.0};
  Eigen::Vector2d centre_{Eigen::Vector2d::Zero()};
};

/// 20 + x^2 + y^2 - 10 cos 2 pi x - 10 cos 2 pi y  on +-5.12
TestFunction rastrigin();

/// x^2 + y^2 + 25 (sin^2 x + sin^2 y)  on +-2 pi
TestFunction eggcrate();

/// -20 exp(-0.2 sqrt((x^2 + y^2) / 2)) - exp((cos 2 pi x + cos 2 pi y) / 2) + 20 + e  on +-32.768
TestFunction ackley();

std::vector<TestFunction> testFunctions();

/// These turned by 30 degrees, their centres at (0.3, -0.2) of the half space.
std::vector<TestFunction> turnedTestFunctions();

}  // namespace adaptive_localization
