// SPDX-License-Identifier: BSD-3-Clause
#include "bench/test_functions.hpp"

#include <cmath>

#include "adaptive_localization/core/pose2.hpp"

namespace adaptive_localization {

double TestFunction::operator()(double x, double y) const {
  const double dx = x - centre_.x(), dy = y - centre_.y();
  const double c = std::cos(angle_), s = std::sin(angle_);
  return formula_(c * dx + s * dy, c * dy - s * dx);
}

TestFunction TestFunction::turned(double angle, const Eigen::Vector2d& centre) const {
  TestFunction other = *this;
  other.name_ += " turned";
  other.angle_ = angle;
  other.centre_ = centre;
  return other;
}

void TestFunction::evaluate(const Eigen::ArrayXXd& positions,
                            Eigen::Ref<Eigen::ArrayXd> costs) const {
  for (Eigen::Index i = 0; i < positions.rows(); ++i) {
    costs[i] = (*this)(positions(i, 0), positions(i, 1));
  }
}

SearchSpace TestFunction::space() const {
  SearchSpace space;
  space.low = Eigen::ArrayXd::Constant(2, -half_width_);
  space.high = Eigen::ArrayXd::Constant(2, half_width_);
  space.is_torus = true;
  return space;
}

TestFunction rastrigin() {
  const auto formula = [](double x, double y) {
    return 20.0 + x * x + y * y - 10.0 * std::cos(2.0 * kPi * x) - 10.0 * std::cos(2.0 * kPi * y);
  };
  return {"Rastrigin", formula, 5.12};
}

TestFunction eggcrate() {
  const auto formula = [](double x, double y) {
    return x * x + y * y + 25.0 * (std::sin(x) * std::sin(x) + std::sin(y) * std::sin(y));
  };
  return {"Eggcrate", formula, 2.0 * kPi};
}

TestFunction ackley() {
  const auto formula = [](double x, double y) {
    return -20.0 * std::exp(-0.2 * std::sqrt(0.5 * (x * x + y * y))) -
           std::exp(0.5 * (std::cos(2.0 * kPi * x) + std::cos(2.0 * kPi * y))) + 20.0 +
           std::exp(1.0);
  };
  return {"Ackley", formula, 32.768};
}

std::vector<TestFunction> testFunctions() {
  return {rastrigin(), ackley(), eggcrate()};
}

std::vector<TestFunction> turnedTestFunctions() {
  std::vector<TestFunction> functions;
  for (const TestFunction& function : testFunctions()) {
    const double half_width = 0.5 * function.space().width(0);
    functions.push_back(function.turned(kPi / 6.0, half_width * Eigen::Vector2d(0.3, -0.2)));
  }
  return functions;
}

}  // namespace adaptive_localization
