// SPDX-License-Identifier: BSD-3-Clause
// What an error says that it expected is what would have been taken.
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "adaptive_localization/core/options.hpp"

namespace adaptive_localization {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct OpenOptions {
  int count{7};
  double width{1.0};
  double margin{0.0};
  double offset{0.0};
  double share{0.5};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("count", count, kPositive, "", "A count.");
    option("width", width, kPositive, "m", "A length.");
    option("margin", margin, Range{0.0, kInfinity}, "m", "A length.");
    option("offset", offset, Range{-kInfinity, kInfinity}, "rad", "An angle.");
    option("share", share, Range{1e-6, 1.0}, "", "A share.");
  }
};

std::string complaint(const std::string& key, const std::string& text) {
  Parameters parameters;
  parameters.set(key, text);
  try {
    parameters.read<OpenOptions>();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no complaint";
}

TEST(OptionMessages, OfRangesWithoutEnd) {
  EXPECT_EQ(complaint("margin", ".inf"),
            "option 'margin': got 'inf', expected a finite number >= 0 m");
  EXPECT_EQ(complaint("offset", "-.inf"),
            "option 'offset': got '-inf', expected a finite number, rad");
  EXPECT_EQ(complaint("offset", "-1e300"), "no complaint");
}

TEST(OptionMessages, OfRangesWithEnds) {
  EXPECT_EQ(complaint("share", "0"), "option 'share': got '0', expected a number in [1e-06, 1]");
  for (const std::string text : {"0", "3000000000", "1.5"}) {
    EXPECT_EQ(complaint("count", text),
              "option 'count': got '" + text + "', expected a whole number in [1, 1000000]");
  }
  EXPECT_EQ(complaint("count", "1000000"), "no complaint");
  for (const std::string text : {"inf", "0", "-1", "1e300"}) {
    EXPECT_EQ(complaint("width", (text == "inf" ? "." : "") + text),
              "option 'width': got '" + (text == "1e300" ? "1e+300" : text) +
                  "', expected a number in [1e-06, 1000000] m");
  }
}

}  // namespace
}  // namespace adaptive_localization
