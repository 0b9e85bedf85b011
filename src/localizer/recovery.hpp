// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "adaptive_localization/core/observations.hpp"
#include "adaptive_localization/core/options.hpp"
#include "adaptive_localization/localizer/confidence.hpp"
#include "adaptive_localization/localizer/status.hpp"
#include "localizer/doubt.hpp"
#include "localizer/hypotheses.hpp"
#include "localizer/initial_pose.hpp"
#include "localizer/leeway.hpp"
#include "localizer/proof.hpp"
#include "localizer/scan_watch.hpp"
#include "localizer/search_pace.hpp"
#include "localizer/tracking_odds.hpp"
#include "localizer/usual_error.hpp"
#include "map/range_error.hpp"

namespace adaptive_localization {

/// Answers "where else could the robot be?", for all cores alike; nobody else searches the map for
/// a robot that is believed to be somewhere.
///
/// While scans fit where the core believes to be, at most as badly as is usual, there is one place
/// and nothing to do. When one does not, when the core jumps, after a start from anywhere and to
/// verify an initial pose, all places that explain the scan become hypotheses beside the one
/// believed in, which starts with the odds that tracking has earned. The core's belief is moved
/// once the odds rule out its place; "tracking" is said when no other place is left.
class Recovery {
 public:
  Recovery(const ConfidenceOptions& options, Ground ground, Senses senses = noSenses());

  /// Starts anew from a prior.
  void reset(const Prior& prior);

  /// Another one's knowledge, on this one's ground.
  void copyStateOf(const Recovery& other);

  /// What of a scan, taken about a pose, tells a core where the robot is: nothing if nearly all
  /// beams are too short, as something stands before the laser; without obstacles that the map does
  /// not have while tracking, if the map's walls are thin. The laser's whole view stays: places are
  /// looked for by it.
  Scan evidenceOf(const Pose2& T_map_base, const Scan& scan) const;

  /// Whether the laser of a robot about a pose is occluded, and other senses tell where it is.
  bool canReplaceScan(const Pose2& T_map_base, const Observations& observations) const;

  /// A scan tells something, and that of the last update was of a laser that is covered: this one
  /// or another.
  bool seesAgain(const Scan& scan) const;

  /// Whether a scan contradicts the map at a pose, so that it is worth an update; where the robot
  /// stands, or little is known of its place, one that fits far worse than the last one did and
  /// than is usual is, too. One of a covered laser is only after another such: another laser may
  /// see.
  bool isContradicted(const Pose2& T_map_base, const Scan& scan) const;

  /// To be asked of every scan, whether it makes an update or not: whether it shows that the robot
  /// was carried away, so that it is worth one.
  bool seesCarrying(const Pose2& T_odom_base, const Scan& scan);

  /// The robot drove so far since the last update: what is known of it moves along.
  void ride(const Pose2& motion);

  /// Takes note of an update of the core: the motion since the last one, where odometry expected
  /// the robot to be, and what the core made of the observations. ride() comes before.
  void observe(const Pose2& motion, const Pose2& T_map_base_expected, const Estimate& estimate,
               const Observations& observations);

  /// The initial pose awaits its first scan, for which the robot need not move.
  bool isUnverified(const Observations& observations) const;
  void verify(const Estimate& estimate, const Observations& observations);

  /// The core's place is ruled out by the odds and others are left: modes().
  bool mustMove() const { return race_.contradictions >= kContradictions; }

  /// The pose to publish: the estimate if it may replace dead reckoning, else dead reckoning, or
  /// the likely place that it is in.
  Pose2 published(const Pose2& T_map_base_by_odometry, const Estimate& estimate) const;

  /// What the next scan takes to be compared with places, as the work of searches is counted.
  SearchWork work() const { return hypotheses_.work(); }

  /// The places where the robot may be, likeliest first; empty if there is no other than the
  /// core's.
  const std::vector<Mode>& modes() const { return modes_; }

  /// While it is suspected that the place only looks alike, "tracking" is not said; the pose is the
  /// same.
  Status status() const {
    const bool is_doubted = proof_.isSuspect() || isDisputed();
    return status_ == Status::kTracking && is_doubted ? Status::kAmbiguous : status_;
  }

  /// The last scan, whatever other senses say, fits where the robot is tracked.
  bool knowsByScans() const { return scan_fits_ && status() == Status::kTracking; }

  const Confidence& fit() const { return confidence_; }
  const Senses& senses() const { return senses_; }

  /// The mean range error that is usual where the robot is.
  const UsualError& usual() const { return usual_; }

  /// How likely the robot is within 0.3 m of where published() has it, [0, 1]: nothing if that is
  /// away from the core's place and from all others that are left.
  double confidence(const Pose2& T_map_base, const Pose2& T_map_base_of_core) const;

 private:
  static constexpr int kContradictions = 2;  // scans in a row
  static constexpr std::size_t kMany = 10;   // places to choose from
  static constexpr double kExplained = 0.2;  // m, mean range error of a scan that a place explains
  static constexpr double kFoundFit = 0.5;   // above: a scan confirms
  static constexpr double kUnproven = 0.5;   // belief, at the most
  static constexpr double kFarWorse = 2.0;   // than the largest error that is not unusual
  static constexpr double kLost = 0.5;       // confidence, at the most
  static constexpr double kMissed = 0.5;     // of the beams: a view without the walls of the map

  void beCarried(const Pose2& T_map_base);
  void open(const Pose2& T_map_base, const Pose2& back = {});
  void openDoubted(const Observations& observations);
  void settle();
  void learn(double error);
  void learnUsual(double error);
  bool isEarned(double error) const;

  /// Scans alone told the place, and tracking has not earned enough since then.
  bool isNew() const { return proof_.isByScans() && !odds_.isKept(); }

  /// How many places look like a new one counts; a place that was known is kept.
  Hypotheses::Against against() const {
    return isNew() ? Hypotheses::Against::kTogether : Hypotheses::Against::kEach;
  }

  /// There were so many places to choose from in this race that the true one may not be among them.
  bool areMany() const { return race_.most >= kMany; }

  /// A new place that was one of so many.
  bool isOneOfMany() const { return were_many_ && isNew(); }
  bool isAsUsual(double error) const { return error <= Hypotheses::withTolerance(usual_.value()); }

  bool isAtALoss() const { return status_ == Status::kLost && odds_.areSpent(); }
  bool isCoveredAt(const Pose2& T_map_base, const Scan& scan) const;
  Observations withoutCover(const Pose2& T_map_base, const Observations& observations) const;
  bool tells(const Observations& observations) const;
  void seeNothing(const Estimate& estimate, const Observations& observations);
  bool isGarbled(const Pose2& T_map_base, const Scan& scan) const;
  double shareOfWallsMissed(const Pose2& T_map_base, const Scan& scan) const;
  double errorAt(const Pose2& T_map_base, const Observations& observations) const;
  bool canSearch(const Observations& observations) const;
  std::optional<std::vector<Place>> placesFor(const Observations& observations) const;
  void compare(const Pose2& expected, const Pose2& T_map_base, double error,
               const Observations& observations);
  bool isRaceDue(const Pose2& expected, const Pose2& T_map_base, double error,
                 const Observations& observations);
  bool isAnswered(const Observations& observations) const;
  bool isPatient(double error) const;
  bool isCheckDue(const Observations& observations) const;
  bool hasJumped(const Pose2& expected, const Pose2& T_map_base) const;
  bool isSudden(const Pose2& T_map_base, const Scan& scan, double error) const;
  bool isDoubtful(double error, bool is_seen) const;
  void findNothingBetter(double error);
  bool isOutvoted(const Pose2& T_map_base, double error, const Observations& observations);
  void race(const Pose2& T_map_base, double error, const Observations& observations);
  bool searchAgain(const Observations& observations);
  void noteLeader();
  void leave();
  void search(const Observations& observations);
  void updateStatus();
  Status judge() const;
  bool isDisputed() const;
  double shareOf(const Pose2& T_map_base) const {
    const Mode* mode = modeAt(T_map_base, modes_);
    return mode ? mode->mass : is_settled_ ? 1.0 : 0.0;
  }
  const Mode* heldPlace(const Pose2& T_map_base) const;
  void noteLeeway(const Estimate& estimate);
  void keepUp(const Pose2& T_map_core, const Observations& observations);
  bool hasSlipped(const Pose2& T_map_base_by_odometry, const Pose2& T_map_base) const;
  bool isCorrection(const Pose2& T_map_base_by_odometry, const Pose2& T_map_base) const;

  Ground ground_;
  Senses senses_;
  RangeError range_error_;
  Confidence confidence_;
  UsualError usual_;
  Hypotheses hypotheses_;
  std::vector<Mode> modes_;
  Status status_{Status::kUninitialised};

  double error_{0.0};         // of the last scan at the core's place, m
  bool scan_fits_{false};     // there, as well as is usual
  bool is_settled_{true};     // there is one place, the core's,
  Doubt doubt_;               // but others are being searched for,
  bool is_unchecked_{false};  // or it has not been compared with others for too long
  bool from_anywhere_{false};
  bool was_tracking_{false};  // since the reset
  InitialPose initial_pose_;
  TrackingOdds odds_;
  Proof proof_;
  Novelty novelty_;

  /// What a race has shown since it was opened.
  struct Race {
    std::optional<Pose2> leader{};  // of the new places the last that was likely
    bool has_left{false};           // the core's place was ruled out,
    double left_way{0.0};           // so long a way ago, m
    bool searched{false};           // this map,
    bool was_searched{false};       // or one before
    bool explained{false};          // some place explains the last scan
    int alike{0};                   // so many others than the core's fitted a scan as well
    std::size_t most{0};            // places to choose from at a time
    double contradictions{0.0};     // scans in a row for which the odds ruled the core's place out
  };
  Race race_;
  SearchPace pace_;
  bool has_left_leader_{false};  // the last scan is suddenly none of the leader's
  Leeway leeway_;                // of the known place, until it is left
  std::optional<Pose2> left_;  // a place that was known, by odometry, until another one is as well
  bool was_refuted_{false};  // the core's place, by what scans said in the last race, but not left
  bool were_many_{false};    // places to choose from in the last race

  int unexplained_{0};  // scans in a row that fit the core's place worse than is usual,
  int unfit_{0};        // or hardly at all
  int blind_{0};        // scans in a row that told nothing
  ScanWatch watch_;
};

}  // namespace adaptive_localization
