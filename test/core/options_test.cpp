// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/core/options.hpp"

#include <gmock/gmock.h>

#include "support/temp_folder.hpp"

namespace adaptive_localization {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

struct SampleOptions {
  bool truth{false};
  int whole{3};
  double real{0.5};
  std::string choice{"red"};
  std::string text{"any"};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("truth", truth, "A switch.");
    option("whole", whole, Range{1, 10}, "", "A count.");
    option("real", real, kNotNegative, "m", "A length.");
    option("choice", choice, Choices{"red", "green"}, "A colour.");
    option("text", text, Choices{}, "A text.");
  }
};

/// What reading the options says when one of them is given so.
std::string complaint(const std::string& key, const std::string& text) {
  Parameters parameters;
  parameters.set(key, text);
  try {
    parameters.read<SampleOptions>();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no complaint";
}

SampleOptions readFrom(const std::string& yaml, Parameters& parameters) {
  const TempFolder folder;
  parameters.load(folder.write("options.yaml", yaml));
  return parameters.read<SampleOptions>();
}

std::string loadingComplaint(const std::string& yaml) {
  Parameters parameters;
  try {
    readFrom(yaml, parameters);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no complaint";
}

TEST(Parameters, LeaveDefaultsWhereNothingIsGiven) {
  const auto options = Parameters{}.read<SampleOptions>();
  EXPECT_FALSE(options.truth);
  EXPECT_EQ(options.whole, 3);
  EXPECT_EQ(options.real, 0.5);
  EXPECT_EQ(options.choice, "red");
}

TEST(Parameters, ReadEveryTypeFromText) {
  Parameters parameters;
  parameters.set("truth", std::string("true"));
  parameters.set("whole", std::string("7"));
  parameters.set("real", std::string("1.5e-2"));
  parameters.set("choice", std::string("green"));
  parameters.set("text", std::string("a b"));
  const auto options = parameters.read<SampleOptions>();
  EXPECT_TRUE(options.truth);
  EXPECT_EQ(options.whole, 7);
  EXPECT_EQ(options.real, 1.5e-2);
  EXPECT_EQ(options.choice, "green");
  EXPECT_EQ(options.text, "a b");
}

TEST(Parameters, TakeAWholeNumberForARealAndAWholeRealForAWholeNumber) {
  Parameters parameters;
  parameters.set("real", OptionValue{2});
  parameters.set("whole", OptionValue{4.0});
  parameters.set("truth", OptionValue{1});
  const auto options = parameters.read<SampleOptions>();
  EXPECT_EQ(options.real, 2.0);
  EXPECT_EQ(options.whole, 4);
  EXPECT_TRUE(options.truth);
}

TEST(Parameters, TakeANumberForAText) {
  Parameters parameters;
  parameters.set("text", OptionValue{12});
  EXPECT_EQ(parameters.read<SampleOptions>().text, "12");
}

TEST(Parameters, NameKeyValueAndRangeOfWhatTheyReject) {
  EXPECT_THAT(complaint("whole", "11"),
              AllOf(HasSubstr("'whole'"), HasSubstr("'11'"), HasSubstr("[1, 10]")));
  EXPECT_THAT(complaint("real", "-0.1"), AllOf(HasSubstr("'real'"), HasSubstr("-0.1"),
                                               HasSubstr("a number in [0, 1000000] m")));
  EXPECT_THAT(complaint("choice", "blue"),
              AllOf(HasSubstr("'choice'"), HasSubstr("blue"), HasSubstr("red, green")));
  EXPECT_THAT(complaint("truth", "maybe"), AllOf(HasSubstr("'truth'"), HasSubstr("maybe")));
}

TEST(Parameters, RejectWhatIsNoNumberOfTheKind) {
  for (const char* text : {".nan", ".inf", "-.inf", "1.5", "ten", "true", "", "1e12"}) {
    EXPECT_THAT(complaint("whole", text), HasSubstr("'whole'")) << text;
  }
  for (const char* text : {".nan", ".inf", "-.inf", "half", "true", ""}) {
    EXPECT_THAT(complaint("real", text), HasSubstr("'real'")) << text;
  }
  EXPECT_THAT(complaint("truth", "2"), HasSubstr("'truth'"));
}

TEST(Parameters, AcceptBothEndsOfARange) {
  EXPECT_EQ(complaint("whole", "1"), "no complaint");
  EXPECT_EQ(complaint("whole", "10"), "no complaint");
  EXPECT_EQ(complaint("real", "0"), "no complaint");
}

TEST(Parameters, KnowWhichKeysNobodyRead) {
  Parameters parameters;
  parameters.set("whole", OptionValue{2});
  parameters.set("whloe", OptionValue{2});
  parameters.set("other", OptionValue{2});
  EXPECT_THAT(parameters.unknownKeys(), ElementsAre("other", "whloe", "whole"));
  parameters.read<SampleOptions>();
  EXPECT_THAT(parameters.unknownKeys(), ElementsAre("other", "whloe"));
  parameters.acknowledge("other");
  EXPECT_THAT(parameters.unknownKeys(), ElementsAre("whloe"));
}

TEST(Parameters, FillLeavesWhatIsGiven) {
  Parameters given, defaults;
  given.set("whole", OptionValue{2});
  defaults.set("whole", OptionValue{9});
  defaults.set("real", OptionValue{9.0});
  given.fill(defaults);
  EXPECT_EQ(given.read<SampleOptions>().whole, 2);
  EXPECT_EQ(given.read<SampleOptions>().real, 9.0);
}

TEST(ParameterFile, GivesValuesOfAllTypes) {
  Parameters parameters;
  const auto options =
      readFrom("truth: yes\nwhole: 8\nreal: 3\nchoice: green\ntext: '12'\n", parameters);
  EXPECT_TRUE(options.truth);
  EXPECT_EQ(options.whole, 8);
  EXPECT_EQ(options.real, 3.0);
  EXPECT_EQ(options.choice, "green");
  EXPECT_EQ(options.text, "12");
}

TEST(ParameterFile, TakesQuotedTextAsText) {
  Parameters parameters;
  readFrom("text: \"true\"\n", parameters);
  EXPECT_EQ(parameters.values().at("text"), OptionValue{std::string("true")});
  EXPECT_THAT(loadingComplaint("whole: '3'\n"), AllOf(HasSubstr("'whole'"), HasSubstr("'3'")));
}

TEST(ParameterFile, MayBeEmpty) {
  Parameters parameters;
  readFrom("# nothing but a comment\n", parameters);
  EXPECT_THAT(parameters.values(), IsEmpty());
}

TEST(ParameterFile, LaterOneWins) {
  Parameters parameters;
  readFrom("whole: 2\nreal: 7\n", parameters);
  const auto options = readFrom("whole: 5\n", parameters);
  EXPECT_EQ(options.whole, 5);
  EXPECT_EQ(options.real, 7.0);
}

TEST(ParameterFile, ComplainsByName) {
  Parameters parameters;
  try {
    parameters.load("/nowhere/options.yaml");
    FAIL() << "loaded a file that does not exist";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("/nowhere/options.yaml"));
  }
  EXPECT_THAT(loadingComplaint("- 1\n- 2\n"), AllOf(HasSubstr("options.yaml"), HasSubstr("map")));
  EXPECT_THAT(loadingComplaint("whole: [1, 2]\n"), HasSubstr("'whole' is not one value"));
  EXPECT_THAT(loadingComplaint("whole:\n"), HasSubstr("'whole' is not one value"));
  EXPECT_THAT(loadingComplaint("a: b: c\n  d"), HasSubstr("options.yaml"));
  EXPECT_THAT(loadingComplaint("? [a, b]\n: 1\n"), HasSubstr("options.yaml"));
}

TEST(Describe, ListsOptionsInOrderWithTheirDefaults) {
  const auto rows = describe(SampleOptions{});
  ASSERT_EQ(rows.size(), 5u);
  EXPECT_EQ(rows[1].key, "whole");
  EXPECT_EQ(rows[1].value, OptionValue{3});
  EXPECT_EQ(rows[2].unit, "m");
  EXPECT_THAT(rows[3].choices, ElementsAre("red", "green"));
  EXPECT_EQ(rows[4].sentence, "A text.");
}

TEST(ToText, PrintsValuesAsAUserWouldGiveThem) {
  EXPECT_EQ(toText(OptionValue{true}), "true");
  EXPECT_EQ(toText(OptionValue{-3}), "-3");
  EXPECT_EQ(toText(OptionValue{0.1}), "0.1");
  EXPECT_EQ(toText(OptionValue{std::string("text")}), "text");
}

}  // namespace
}  // namespace adaptive_localization
