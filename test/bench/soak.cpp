// SPDX-License-Identifier: BSD-3-Clause
// Hours of a robot's life as fast as the processor goes: whether memory, latency or errors grow.
#include <array>
#include <cstdio>
#include <limits>
#include <stdexcept>

#include "adaptive_localization/localizer/localizer.hpp"
#include "adaptive_localization/map/map_io.hpp"
#include "eval/arguments.hpp"
#include "eval/experiment_drive.hpp"
#include "eval/program.hpp"
#include "eval/start.hpp"
#include "eval/statistics.hpp"
#include "eval/stopwatch.hpp"
#include "support/resident_memory.hpp"

namespace adaptive_localization {
namespace {

constexpr char kUsage[] =
    "usage: soak [options]\n\n"
    "A simulated robot drives for hours in an office with five people. It is carried away every\n"
    "5 minutes, the map changes every 11 minutes (with desks moved, and back), an option every 7.\n"
    "With --every it is carried away, the map changes, an option does, and the whole map is\n"
    "searched, in turn. Prints a row for each hour. Ends with 1 if tracking is reported of a wrong "
    "place for more\n"
    "than 5 s, memory grows by more than 2 % after the first hour, or latency by half.\n\n"
    "  --filter NAME  the core (default sa_kld)\n"
    "  --hours N      of the drive (default 10)\n"
    "  --every N      seconds from one of these events to the next\n"
    "  --seed N       of all that is random (default 1)\n"
    "  --help         print this\n";
constexpr double kHour = 3600.0;                            // s
constexpr double kFar = 0.5, kTurned = 20.0 * kPi / 180.0;  // of a wrong pose, m and rad
constexpr double kMostGrowth = 1.02, kMostDelay = 1.5, kMostMistaken = 5.0;  // the last in s
constexpr double kBrief = 1.0;                                               // s

/// What happens now and then: for the first time, and every so many seconds from then on.
struct Happening {
  double next{std::numeric_limits<double>::infinity()};
  double every{std::numeric_limits<double>::infinity()};

  bool isDue(double stamp) {
    if (stamp < next) return false;
    next += every;
    return true;
  }
};

struct Schedule {
  Happening kidnap{300.0, 300.0}, map{660.0, 660.0}, option{420.0, 420.0}, search{};
};

Schedule inTurn(double every) {
  const double all = 4.0 * every;
  return {{every, all}, {2.0 * every, all}, {3.0 * every, all}, {all, all}};
}

struct Command {
  std::string filter{"sa_kld"};
  int hours{10};
  Schedule schedule;
  int seed{1};
  bool wants_help{false};
};

Command parse(const std::vector<std::string>& arguments) {
  Command command;
  ArgumentParser parser;
  parser.text("--filter", command.filter);
  parser.option("--hours", [&](const auto& v) { command.hours = toCount("--hours", v, 1000); });
  parser.option("--every",
                [&](const auto& v) { command.schedule = inTurn(toCount("--every", v, 3600)); });
  parser.option("--seed", [&](const auto& v) { command.seed = toSeed("--seed", v); });
  command.wants_help = !parser.parse(arguments);
  return command;
}

ExperimentCase lifeOf(const Command& command) {
  ExperimentCase life;
  life.world = SOURCE_DIR "/maps/office/world.yaml";
  life.map = SOURCE_DIR "/maps/office/map.yaml";
  life.route.emplace();  // at random
  life.simulation.set("drive", true);
  life.simulation.set("people", 5);
  life.duration = command.hours * kHour;
  ExperimentEvent kidnap;
  kidnap.at = command.schedule.kidnap.next;
  kidnap.every = command.schedule.kidnap.every;
  kidnap.to.farther_than = 3.0;
  life.events = {kidnap};
  return life;
}

/// What an hour was like.
struct Hour {
  double median_ms{0.0}, p99_ms{0.0}, most_ms{0.0};  // of an update
  int scans{0}, tracking{0}, wrong{0};               // of all; those that said tracking; wrongly
  int mistakes{0};                                   // times that it was for more than kBrief,
  double longest_s{0.0};                             // and for how long at the most
  double megabytes{0.0};
};

class Soak {
 public:
  explicit Soak(const Command& command)
      : command_(command),
        life_(lifeOf(command)),
        schedule_(command.schedule),
        site_(loadSite(life_)),
        drive_(site_, life_, command.seed) {
    parameters_.set("filter", command.filter);
    parameters_.set("threads", 1);
    maps_ = {site_.ground.map, std::make_shared<const OccupancyGrid>(
                                   loadMap(SOURCE_DIR "/maps/office_moved/map.yaml"))};
    localizer_ = std::make_unique<Localizer>(parameters_, site_.ground);
    localizer_->reset(StartOptions().around(drive_.told()));
  }

  std::vector<Hour> run() {
    std::vector<Hour> hours;
    for (int i = 1; i <= command_.hours; ++i) {
      hours.push_back(live(i * kHour));
      print(i, hours.back());
    }
    return hours;
  }

 private:
  Hour live(double until) {
    Hour hour;
    std::vector<double> ms;  // of each update
    while (const auto seen = drive_.next()) {
      change(seen->scan.stamp);
      update(*seen, hour, ms);
      if (seen->scan.stamp >= until) break;
    }
    hour.median_ms = quantile(ms, 0.5);
    hour.p99_ms = quantile(ms, 0.99);
    hour.most_ms = largest(ms);
    hour.megabytes = residentMegabytes();
    return hour;
  }

  /// The map, an option, or what is known.
  void change(double stamp) {
    if (schedule_.map.isDue(stamp)) {
      localizer_->setMap(Ground(maps_[static_cast<std::size_t>(++map_changes_ % 2)]));
    }
    if (schedule_.option.isDue(stamp)) {
      parameters_.set("laser_max_beams", ++option_changes_ % 2 == 0 ? 60 : 45);
      localizer_->configure(parameters_);
    }
    if (schedule_.search.isDue(stamp)) localizer_->reset(Anywhere{});
  }

  void update(const DriveScan& seen, Hour& hour, std::vector<double>& ms) {
    const Stopwatch watch(CLOCK_THREAD_CPUTIME_ID);
    Observations observations;
    observations.stamp = seen.scan.stamp;
    observations.scan = toScan(seen.scan, LaserMount::level(drive_.laserMounts().front()),
                               localizer_->scanOptions(), seen.velocity);
    const Localization answer = localizer_->update(seen.T_odom_base, observations);
    if (answer.updated) ms.push_back(watch.milliseconds());
    localizer_->searchOn();
    ++hour.scans;
    const bool is_tracking = answer.status == Status::kTracking;
    const Pose2 error = between(*seen.T_map_base, answer.T_map_base);
    const bool is_wrong =
        is_tracking && (std::hypot(error.x, error.y) > kFar || std::abs(error.theta) > kTurned);
    hour.tracking += is_tracking ? 1 : 0;
    hour.wrong += is_wrong ? 1 : 0;
    judge(is_wrong, seen.scan.stamp, hour);
  }

  void judge(bool is_wrong, double stamp, Hour& hour) {
    if (!is_wrong) return wrong_since_.reset();
    if (!wrong_since_) {
      wrong_since_ = stamp;
      is_counted_ = false;
    }
    const double seconds = stamp - *wrong_since_;
    hour.longest_s = std::max(hour.longest_s, seconds);
    if (seconds <= kBrief || is_counted_) return;
    is_counted_ = true;
    ++hour.mistakes;
  }

  void print(int number, const Hour& hour) const {
    const double scans = hour.scans;
    std::printf("| %s | %d | %.1f | %.2f | %.2f | %.1f | %.1f | %.3f | %d | %.1f |\n",
                command_.filter.c_str(), number, hour.megabytes, hour.median_ms, hour.p99_ms,
                hour.most_ms, 100.0 * hour.tracking / scans, 100.0 * hour.wrong / scans,
                hour.mistakes, hour.longest_s);
    std::fflush(stdout);
  }

  Command command_;
  ExperimentCase life_;
  Schedule schedule_;
  ExperimentSite site_;
  ExperimentDrive drive_;
  Parameters parameters_;
  std::array<std::shared_ptr<const OccupancyGrid>, 2> maps_;
  std::unique_ptr<Localizer> localizer_;
  int map_changes_{0}, option_changes_{0};
  std::optional<double> wrong_since_;
  bool is_counted_{false};  // as a mistake
};

void run(const Command& command) {
  std::puts(
      "| core | hour | memory, MB | ms per update: median | 99 % | most | tracking, % of the scans "
      "|"
      " and wrong, % | for more than 1 s, times | longest, s |\n"
      "|---|---|---|---|---|---|---|---|---|---|");
  const std::vector<Hour> hours = Soak(command).run();
  for (const Hour& hour : hours) {
    if (hour.longest_s > kMostMistaken) {
      throw std::runtime_error("tracking was reported of a wrong place for " +
                               std::to_string(hour.longest_s) + " s");
    }
    if (hour.megabytes > kMostGrowth * hours.front().megabytes) {
      throw std::runtime_error("memory grows: " + std::to_string(hours.front().megabytes) +
                               " MB after an hour, " + std::to_string(hour.megabytes) + " later");
    }
    if (hour.median_ms > kMostDelay * hours.front().median_ms) {
      throw std::runtime_error("latency grows: " + std::to_string(hours.front().median_ms) +
                               " ms in the first hour, " + std::to_string(hour.median_ms) +
                               " later");
    }
  }
}

}  // namespace
}  // namespace adaptive_localization

int main(int argc, char** argv) {
  namespace al = adaptive_localization;
  return al::runProgram("soak", al::kUsage, al::parse, al::run, {argv + 1, argv + argc});
}
