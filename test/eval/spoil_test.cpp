// SPDX-License-Identifier: BSD-3-Clause
#include "eval/spoil.hpp"

#include <gmock/gmock.h>

#include <set>

#include "support/program.hpp"

namespace adaptive_localization {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

void expectRejected(const std::string& text, const std::string& why) {
  EXPECT_THAT([&] { parseSpoil(text); }, ThrowsMessage<std::invalid_argument>(HasSubstr(why)));
}

TEST(Spoil, IsReadWithAndWithoutAnAmount) {
  EXPECT_EQ(toText(parseSpoil("thick")), "thick:0.2");
  EXPECT_EQ(toText(parseSpoil("thick:0.35")), "thick:0.35");
  EXPECT_EQ(toText(parseSpoil("shift:-2e-2")), "shift:-0.02");
  EXPECT_EQ(toText({parseSpoil("slip"), parseSpoil("late:1")}), "slip:7.5, late:1");
  for (const auto& kind : damageKinds()) EXPECT_EQ(parseSpoil(kind.name).amount, kind.amount);
}

TEST(Spoil, RefusesWhatItDoesNotKnow) {
  expectRejected("thik", "got 'thik', expected one of thick, coarse, ");
  expectRejected("thik", ", slip, scale, lost, late, thin, carried; did you mean 'thick'?");
  expectRejected("", "got '', expected one of");
  expectRejected("thick:", "damage 'thick': got '', expected a number");
  expectRejected("thick:0.1m", "damage 'thick': got '0.1m', expected a number");
  expectRejected("thick:-0.1", "damage 'thick': got -0.1, expected 0.001 to 10 m");
  expectRejected("lost:2", "damage 'lost': got 2, expected 0 to 1");
}

TEST(Spoil, UsualAmountsAreInRangeAndNamesAreTaken) {
  std::set<std::string> names;
  for (const auto& kind : damageKinds()) {
    checkAmount(kind, kind.amount);
    EXPECT_TRUE(names.insert(kind.name).second) << kind.name << " is there twice";
    EXPECT_THAT(describeKinds(damageKinds()),
                AllOf(HasSubstr("  " + kind.name + " "), HasSubstr(kind.sentence)));
  }
}

TEST(Spoil, DoesToAMapAndToALogWhatIsMeantForThem) {
  const OccupancyGrid map(Lattice(1, 1, 0.1, {}), {OccupancyGrid::kFree});
  Log log;
  log.scans.resize(2);
  log.scans[1].T_odom_base.x = 1.0;
  const std::vector<Spoil> spoils{parseSpoil("shift:0.5"), parseSpoil("scale:0.5"),
                                  parseSpoil("scale:1"), parseSpoil("shift:0.25")};
  EXPECT_DOUBLE_EQ(spoil(map, spoils, 1).lattice().origin().x, 0.75);
  EXPECT_DOUBLE_EQ(spoil(log, spoils, 1).scans[1].T_odom_base.x, 3.0);
}

TEST(Spoil, EvaluateKnowsAllKinds) {
  const std::string script = readWhole(std::string(SOURCE_DIR) + "/scripts/evaluate");
  for (const auto& kind : damageKinds()) {
    EXPECT_THAT(script, testing::ContainsRegex("(ALL|OTHER)_SPOILS = [^]]*\"" + kind.name));
  }
}

}  // namespace
}  // namespace adaptive_localization
