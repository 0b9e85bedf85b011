// SPDX-License-Identifier: BSD-3-Clause
#include "ros/reconfigure_messages.hpp"

#include <gmock/gmock.h>

#include <limits>

#include "ros/reconfigure_fields.hpp"

namespace adaptive_localization {
namespace {

using testing::HasSubstr;

struct Sample {
  bool on{true};
  int beams{30};
  double noise{0.2};
  std::string kind{"b-c"};
  std::string name{"x"};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("on", on, "A switch.");
    option("beams", beams, Range{2, 1e12}, "", "A number.");
    option("noise", noise, kNotNegative, "m", "A length.");
    option("kind", kind, Choices{"a", "b-c"}, "A word.");
    option("name", name, Choices{}, "Any text.");
  }
};

TEST(ReconfigureMessages, CarryValues) {
  const Values expected{{"on", true},
                        {"beams", 30},
                        {"noise", 0.2},
                        {"kind", std::string("b-c")},
                        {"name", std::string("x")}};
  EXPECT_EQ(valuesOf(toConfig(describe(Sample{}))), expected);
}

TEST(ReconfigureMessages, DescribeTypesRangesAndChoices) {
  const auto description = toDescription(describe(Sample{}));
  ASSERT_EQ(description.groups.size(), 2u);
  EXPECT_THAT(description.groups[0].parameters, testing::IsEmpty()) << "none is for users";
  const auto& fields = description.groups[1].parameters;
  ASSERT_EQ(fields.size(), 5u);
  const std::vector<std::string> types{"bool", "int", "double", "str", "str"};
  for (std::size_t i = 0; i < types.size(); ++i) EXPECT_EQ(fields[i].type, types[i]);
  EXPECT_EQ(fields[2].description, "A length. [m]");
  EXPECT_THAT(fields[3].edit_method, HasSubstr("'value': 'b-c'"));
  EXPECT_EQ(fields[4].edit_method, "");
  const Values low = valuesOf(description.min), high = valuesOf(description.max);
  EXPECT_EQ(low.at("beams"), OptionValue{2});
  EXPECT_EQ(high.at("beams"), OptionValue{std::numeric_limits<int>::max()});
  EXPECT_EQ(high.at("noise"), OptionValue{kNotNegative.high});
  EXPECT_EQ(valuesOf(description.dflt), valuesOf(toConfig(describe(Sample{}))));
}

TEST(ReconfigureMessages, KeepOptionsForExpertsApart) {
  const auto description = toDescription(fieldsOf(allOptions({}), {}));
  const auto has = [&](int group, const std::string& key) {
    const auto& fields = description.groups.at(static_cast<std::size_t>(group)).parameters;
    return std::any_of(fields.begin(), fields.end(),
                       [&](const auto& field) { return field.name == key; });
  };
  EXPECT_TRUE(has(0, "filter") && has(0, "odom_alpha1"));
  EXPECT_TRUE(has(1, "search_margin"));
  EXPECT_FALSE(has(1, "filter") || has(0, "search_margin"));
  EXPECT_EQ(description.groups[1].type, "collapse");
  EXPECT_LE(description.groups[0].parameters.size(), 100u);
}

TEST(ReconfigureFields, LeaveWhereTheRobotStartsToTheStart) {
  NodeOptions now;
  now.odom_frame_id = "odom_of_robot";
  Parameters parameters;
  parameters.set("odom_frame_id", OptionValue{std::string("other")});
  parameters.set("transform_tolerance", OptionValue{0.7});
  const NodeOptions live = liveOptions(parameters, now);
  EXPECT_EQ(live.odom_frame_id, "odom_of_robot");
  EXPECT_DOUBLE_EQ(live.transform_tolerance, 0.7);
  for (const auto& field : fieldsOf(allOptions(parameters), {})) {
    EXPECT_NE(field.key.rfind("initial_", 0), 0u) << field.key;
  }
}

}  // namespace
}  // namespace adaptive_localization
