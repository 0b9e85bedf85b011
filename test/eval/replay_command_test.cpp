// SPDX-License-Identifier: BSD-3-Clause
#include "eval/replay_command.hpp"

#include <gmock/gmock.h>

#include "eval/start.hpp"
#include "support/temp_folder.hpp"

namespace adaptive_localization {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

ReplayCommand parse(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"--map", "m.yaml", "--log", "a.bag"});
  return parseReplayCommand(arguments);
}

void expectRejected(const std::vector<std::string>& arguments, const std::string& why) {
  EXPECT_THAT([&] { parseReplayCommand(arguments); },
              ThrowsMessage<std::invalid_argument>(HasSubstr(why)));
}

TEST(ReplayCommand, ReadsWhereTheLaserSits) {
  EXPECT_FALSE(parse({}).T_base_laser);
  const Pose2 mount = parse({"--mount", "0.1,-0.2,3"}).T_base_laser.value();
  EXPECT_EQ(mount.x, 0.1);
  EXPECT_EQ(mount.y, -0.2);
  EXPECT_EQ(mount.theta, 3.0);
  EXPECT_THAT(
      [] {
        parse({"--mount", "0.1"});
      },
      ThrowsMessage<std::invalid_argument>("--mount: got '0.1', expected X,Y,YAW in m and rad"));
}

TEST(ReplayCommand, TakesValuesBehindAnEqualsSign) {
  const ReplayCommand command = parse({"--start=-1,2,-3", "--set=a=7", "--json=x=y.json"});
  EXPECT_EQ(command.start, "-1,2,-3");
  EXPECT_EQ(toText(command.parameters.values().at("a")), "7");
  EXPECT_EQ(command.json_file, "x=y.json");
}

TEST(ReplayCommand, ReadsAllItsArguments) {
  const ReplayCommand command =
      parse({"--start", "-1,2,-3", "--begin", "10.5", "--end", "1e3", "--scan-topic", "/s",
             "--odom-topic", "/o", "--truth-topic", "/t", "--trajectory", "o.tum", "--json",
             "o.json", "--report", "o", "--quiet"});
  EXPECT_EQ(command.map, "m.yaml");
  EXPECT_EQ(command.log.file, "a.bag");
  EXPECT_EQ(command.start, "-1,2,-3");
  EXPECT_DOUBLE_EQ(command.log.begin, 10.5);
  EXPECT_DOUBLE_EQ(command.log.end, 1000.0);
  EXPECT_EQ(command.log.scan_topic, "/s");
  EXPECT_EQ(command.log.odom_topic, "/o");
  EXPECT_EQ(command.log.truth_topic, "/t");
  EXPECT_EQ(command.trajectory_file, "o.tum");
  EXPECT_EQ(command.json_file, "o.json");
  EXPECT_EQ(command.report_folder, "o");
  EXPECT_TRUE(command.is_quiet);
  EXPECT_FALSE(command.allows_misfit);
  EXPECT_TRUE(parse({"--allow-misfit"}).allows_misfit);
  EXPECT_EQ(parse({"--truth", "t.tum"}).truth_file, "t.tum");
}

TEST(ReplayCommand, LayersParameters) {
  const TempFolder folder;
  const auto first = folder.write("1.yaml", "a: 1\nb: 1\nc: 1\nseed: 1\n");
  const auto second = folder.write("2.yaml", "b: 2\nc: 2\nseed: 2\n");
  const ReplayCommand command = parse(
      {"--seed", "4", "--set", "c=3", "seed=3", "--params", first, second, "--filter", "kld"});
  const auto value = [&](const char* key) { return toText(command.parameters.values().at(key)); };
  EXPECT_EQ(value("a"), "1");
  EXPECT_EQ(value("b"), "2");
  EXPECT_EQ(value("c"), "3");
  EXPECT_EQ(value("seed"), "4");
  EXPECT_EQ(value("filter"), "kld");
}

TEST(ReplayCommand, RejectsWhatItDoesNotKnow) {
  const std::vector<std::string> given{"--map", "m", "--log", "a"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), given.begin(), given.end());
    return more;
  };
  expectRejected(with({"--speed", "3"}), "unknown argument '--speed'");
  expectRejected(with({"stray"}), "unknown argument 'stray'");
  expectRejected(with({"--quiet=1"}), "--quiet takes no value");
  expectRejected(with({"--plot", "x.png"}), "--plot is no more, expected --report FOLDER");
  expectRejected(with({"--thread", "3"}), "'--thread'; did you mean '--threads'?");
  expectRejected(with({"--qiuet"}), "'--qiuet'; did you mean '--quiet'?");
  expectRejected(with({"--seed"}), "--seed needs a value");
  expectRejected(with({"--start", "--quiet"}), "--start needs a value");
  expectRejected(with({"--seed", "two"}), "--seed: got 'two', expected a number");
  expectRejected(with({"--search", "0"}), "--search: got '0', expected a whole number from 1");
  expectRejected(with({"--begin", "nan"}), "--begin: got 'nan', expected a number");
  expectRejected(with({"--begin", "2", "--end", "1"}), "--begin is later than --end");
  expectRejected(with({"--set", "alpha1"}), "--set: got 'alpha1', expected KEY=VALUE");
  expectRejected(with({"--truth", "a", "--truth-topic", "b"}), "exclude each other");
  expectRejected(with({"--params", "/does/not/exist.yaml"}), "/does/not/exist.yaml");
  expectRejected({"--log", "a"}, "--map is missing");
  expectRejected({"--map", "m"}, "--log is missing");
  expectRejected({}, "--map is missing");
}

TEST(ReplayCommand, ReadsWhatToSpoil) {
  const ReplayCommand command = parse({"--spoil", "thick", "slip:5", "--spoil", "thick:0.1"});
  EXPECT_EQ(toText(command.spoils), "thick:0.2, slip:5, thick:0.1");
  EXPECT_FALSE(command.spoil_seed);
  EXPECT_EQ(parse({"--spoil-seed", "0"}).spoil_seed, 0);
  const auto reject = [](const std::vector<std::string>& arguments, const std::string& why) {
    EXPECT_THAT([&] { parse(arguments); }, ThrowsMessage<std::invalid_argument>(HasSubstr(why)));
  };
  reject({"--spoil"}, "--spoil needs a value");
  reject({"--spoil", "thik"}, "damage: got 'thik', expected one of thick, ");
  reject({"--spoil", "gaps:7"}, "damage 'gaps': got 7, expected 0 to 0.9");
  reject({"--spoil-seed", "1.5"}, "--spoil-seed: got '1.5', expected a whole number from 0");
  reject({"--spoil-seed", "-1"}, "--spoil-seed: got '-1', expected a whole number from 0");
}

TEST(ReplayCommand, HelpNeedsNothingElse) {
  EXPECT_TRUE(parseReplayCommand({"--help"}).wants_help);
  EXPECT_THAT(replayUsage(), HasSubstr("--truth-topic"));
}

Log threeScans() {
  Log log;
  log.scans.resize(3);
  log.scans[1].T_map_base = Pose2{1.0, 2.0, 0.5};
  log.scans[2].T_map_base = Pose2{9.0, 9.0, 0.9};
  return log;
}

TEST(Start, TakesTheFirstReferenceAndDropsTheScansBefore) {
  for (const char* start : {"truth", ""}) {
    Log log = threeScans();
    const auto prior = std::get<Gaussian2>(startPrior(start, {}, log));
    EXPECT_DOUBLE_EQ(prior.mean.x, 1.0);
    EXPECT_DOUBLE_EQ(prior.mean.theta, 0.5);
    EXPECT_NEAR(prior.covariance(0, 0), 0.04, 1e-12);
    EXPECT_NEAR(prior.covariance(2, 2), 0.14 * 0.14, 1e-12);
    EXPECT_EQ(log.scans.size(), 2U);
    EXPECT_THAT(log.warnings, ElementsAre(HasSubstr("1 scans before the reference")));
  }
}

TEST(Start, IsAnywhereWithoutReferenceOrIfAsked) {
  Log log = threeScans();
  EXPECT_TRUE(std::holds_alternative<Anywhere>(startPrior("global", {}, log)));
  EXPECT_EQ(log.scans.size(), 3U);
  log.scans.resize(1);
  EXPECT_TRUE(std::holds_alternative<Anywhere>(startPrior("", {}, log)));
  EXPECT_THAT([&] { startPrior("truth", {}, log); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("no reference at any scan")));
}

const OccupancyGrid kMap(Lattice(20, 10, 0.5, {-1.0, 2.0, 0.0}), std::vector<std::int8_t>(200, 0));

TEST(Start, IsOnTheMapOrRefused) {
  Log log = threeScans();
  for (const char* start : {"-0.9,2.1,0", "8.9,6.9,3", "truth", "global"}) {
    checkStart(start, startPrior(start, {}, log), kMap);
  }
  EXPECT_THAT([&] { checkStart("9.1,3,0.5", startPrior("9.1,3,0.5", {}, log), kMap); },
              ThrowsMessage<std::invalid_argument>(
                  "--start: got a pose at (9.100, 3.000) m, 28.6 deg, expected one on the map: "
                  "x from -1.000 to 9.000 m, y from 2.000 to 7.000 m"));
  log.scans.erase(log.scans.begin());  // the next reference is at (9, 9) m
  EXPECT_THAT([&] { checkStart("", startPrior("", {}, log), kMap); },
              ThrowsMessage<std::invalid_argument>(
                  HasSubstr("--start truth: the reference begins at (9.000, 9.000) m")));
}

TEST(Start, KnowsHowFarATurnedMapGoes) {
  Log log = threeScans();
  const OccupancyGrid turned(Lattice(20, 10, 0.5, {1.0, 0.0, 0.5 * kPi}), kMap.cells());
  checkStart("-3.9,9.9,0", startPrior("-3.9,9.9,0", {}, log), turned);
  EXPECT_THAT([&] { checkStart("1.1,5,0", startPrior("1.1,5,0", {}, log), turned); },
              ThrowsMessage<std::invalid_argument>(
                  HasSubstr("x from -4.000 to 1.000 m, y from 0.000 to 10.000 m")));
}

TEST(Start, IsSaidInWords) {
  Log log = threeScans();
  EXPECT_EQ(startText("global", startPrior("global", {}, log)), "anywhere on the map");
  EXPECT_EQ(startText("1,2,0.5", startPrior("1,2,0.5", {}, log)), "at (1.000, 2.000) m, 28.6 deg");
  EXPECT_EQ(startText("", startPrior("", {}, log)),
            "at (1.000, 2.000) m, 28.6 deg, as the reference says");
}

TEST(Start, ReadsAPose) {
  Log log = threeScans();
  StartOptions options;
  options.initial_cov_yy = 0.25;
  const auto prior = std::get<Gaussian2>(startPrior("-1.5,2e1,4", options, log));
  EXPECT_DOUBLE_EQ(prior.mean.x, -1.5);
  EXPECT_DOUBLE_EQ(prior.mean.y, 20.0);
  EXPECT_DOUBLE_EQ(prior.mean.theta, 4.0 - 2.0 * kPi);
  EXPECT_DOUBLE_EQ(prior.covariance(1, 1), 0.25);
  for (const char* wrong : {"here", "1,2", "1,2,3,4", "1;2;3", "nan,0,0", "1,2,x"}) {
    EXPECT_THAT([&] { startPrior(wrong, options, log); },
                ThrowsMessage<std::invalid_argument>(HasSubstr(wrong)));
  }
}

}  // namespace
}  // namespace adaptive_localization
