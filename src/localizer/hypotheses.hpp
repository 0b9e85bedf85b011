// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "adaptive_localization/core/belief.hpp"
#include "adaptive_localization/observation/composed_model.hpp"
#include "adaptive_localization/ser/ground.hpp"
#include "localizer/hypothesis.hpp"
#include "localizer/leeway.hpp"
#include "localizer/novelty.hpp"
#include "localizer/tracking_odds.hpp"
#include "map/range_error.hpp"
#include "ser/place.hpp"
#include "ser/search_pose.hpp"

namespace adaptive_localization {

class PlaceRefiner;

/// Places where the robot may be, with log odds. They ride on the odometry, are aligned with each
/// scan, and are judged by their mean range error e against the least of all:
///
///     log odds -= w max(0, e - 1.25 u - t) / s,   u = max(e_min, usual),
///     s = max(s_0, u / 4 max(1, u / u_r))
///
/// w <= 1 is the share of the scan that is new, t what the map is off by, more where its walls are
/// rough, s_0 the error that makes a place e times less likely where the map is good, u_r that from
/// which on errors are the map's, alike for all scans nearby. Where even the best place leaves much
/// unexplained, or much is usual, a little more tells nothing; a scan that fits nowhere as well as
/// is usual may be of something that the map does not have, and says little of any place, least of
/// all of the one where the robot was known to be; if it was not, a place that fits twice as well
/// as another is likelier. Where most of a scan fits such a place, furniture may have been moved:
/// it loses little by little, and least where beams only end before what the map has; while the
/// robot turns on the spot, which shows the same furniture again, hardly anything. If it does not
/// fit, the robot is likelier within a slip of the wheels, up to a metre or 0.9 rad, or some
/// slips, than anywhere else. Unlike the modes of a particle cloud, masses of places that look the
/// same do not drift: only what is seen decides between them.
///
/// What another sense says against a place is bounded where the laser sees: a compass that is
/// disturbed, or a landmark that was moved, stays so, and decides only between places that scans
/// and what was known before leave open.
///
/// Of many places not all are judged by each scan, so that an update takes no longer for a hundred
/// places than for some: the likeliest are, and the others in turn, by all that is new since they
/// were. Those that no scan has judged yet come first; until then they are no modes, and no place
/// has won. As long as one is far likelier than all others, as on poor maps where each scan fits
/// here and there, fewer are judged.
class Hypotheses {
 public:
  /// What the likeliest place is compared with to rule others out: with each of them, so that a
  /// place that was known is kept, however many look like it; or with all of them together, as a
  /// hundred places, each of them unlikely, may be likely as a whole.
  enum class Against { kEach, kTogether };

  /// An error that tells no more than another one, m.
  static double withTolerance(double error) { return 1.25 * error + 0.015; }

  explicit Hypotheses(Ground ground, Senses senses = noSenses())
      : ground_(std::move(ground)), senses_(std::move(senses)) {}

  /// Goes on with another map and other models.
  void standOn(Ground ground, Senses senses) {
    ground_ = std::move(ground);
    senses_ = std::move(senses);
  }

  void clear() {
    all_.clear();
    is_kept_ruled_out_ = false;
    left_out_.reset();
    least_error_ = 0.0;
    slips_sought_ = 0;
  }
  bool isEmpty() const { return all_.empty(); }

  /// One more place, unless it is known, not finite, or one too many.
  void add(const Pose2& T_map_base, double log_odds) {
    add(T_map_base, log_odds, placeCovariance());
  }

  /// The same for one that is known so badly, over (x, y, theta), as by sightings of landmarks.
  void add(const Pose2& T_map_base, double log_odds, const Eigen::Matrix3d& covariance);

  /// Where a core is, with these log odds, or, if wheels can have slipped from the place that was
  /// believed in to there, with those of a slip.
  void addCore(const Pose2& T_map_core, double log_odds);

  /// All that a search found, best first. One that is known may have drifted off: it is aligned
  /// with the next scan from where it was found as well.
  void addFound(const std::vector<Place>& places, double log_odds) {
    addFound(places, log_odds, placeCovariance());
  }
  void addFound(const std::vector<Place>& places, double log_odds,
                const Eigen::Matrix3d& covariance, bool are_aligned = false);

  /// The same for what a search aligned with the next scan: not again.
  void addAligned(const std::vector<Place>& places, double log_odds) {
    addFound(places, log_odds, placeCovariance(), true);
  }

  /// Whether the last search found places for which there was no room, and which those that are
  /// left do not rule out.
  bool lackSome(Against against = Against::kEach) const;

  /// Whether some were not judged by any scan yet.
  bool waitForSome() const;

  /// The place where the robot was told or known to be, with the odds that it has before a scan is
  /// looked at.
  void addKept(const Pose2& T_map_base, const TrackingOdds& odds);

  bool knows(const Pose2& T_map_base) const;

  /// The likeliest place that was known, or that wheels slipped to from there, of those that are
  /// allowed where odometry alone has them; null if there is none.
  Hypothesis* knownWithin(const Leeway& leeway);

  /// Whether wheels can have slipped to one of the places, from where odometry has the robot or by
  /// some slips on the way; to any if there are none.
  bool haveSlipped(const Pose2& T_map_from, const Pose2& T_map_to) const;

  /// Whether the last scan fits where wheels can have slipped to, and far worse where the place
  /// that was believed in is by odometry.
  bool fitOnlySlip(const Pose2& T_map_to) const;

  /// Those that explain what other senses tell, once they are corrected by it: whose misfit is
  /// below the most, m.
  std::vector<Place> explaining(const Observations& observations, double most) const;

  /// Whether a core is in one of the places, or a step away from one, as one of the two drifted
  /// off: unless the last scan, with its mean range error where the core is, contradicts the core
  /// and fits the place far better.
  bool hold(const Pose2& T_map_core, double error, double usual) const;

  /// Log odds of a place that comes later, as if it had fitted as well as the best so far, but for
  /// a malus: a kept place is ruled out by what is seen from then on. Of the odds that it started
  /// with, no more counts than is left of them by now.
  double entry(double malus, const TrackingOdds& odds) const;

  /// Whether somebody's word is for one of the places: later places are no better than those that
  /// explained the first scan as well as it did.
  bool isByWord() const;

  /// What the next scan takes to be compared with them, as the work of searches is counted.
  SearchWork work() const;

  /// The least mean range error of the last scan, m.
  double leastError() const { return least_error_; }

  /// The error of the last scan that judged it at the likeliest place, m; none: truncated.
  double likeliestError() const {
    return all_.empty() ? RangeError::kTruncation : all_.front().error;
  }

  /// The largest error of the last scan that speaks against no place, by the best one alone, m.
  double mostTolerated() const { return tolerated(least_error_); }

  void ride(const Pose2& motion);

  /// Where a core is: its place will be looked for from there, too.
  void note(const Pose2& T_map_core);

  /// The core is beside its place: a step away the last scan fits far better.
  bool isCoreBeside() const { return is_core_beside_; }

  /// By the odds a core is not where it is, and the last scan fits the likeliest place far better.
  bool isOutdone(const Pose2& T_map_core) const;

  /// Aligns all with a scan that is no evidence yet.
  void follow(const Scan& scan, double usual);

  /// Where the kept place is by now, unless it was left out.
  void moveKept(const Pose2& T_map_base);

  /// Aligns all with a scan and takes note of what it and the other senses say of them. Without a
  /// scan each is corrected by the other senses, as a Kalman filter is, and they alone are judges.
  void weigh(const Observations& observations, const News& news, double usual);

  /// How many other places the last scan fits about as well as the best.
  int alike(const Pose2& T_map_base) const;

  /// Leaves out those that became one with a likelier one, and those too unlikely.
  void prune(Against against = Against::kEach);

  /// The kept place if it was left out: where it was at first, and odometry since then.
  std::optional<Pose2> ruledOut() const {
    return is_kept_ruled_out_ ? std::make_optional(T_map_kept_) : std::nullopt;
  }

  /// Whether the likeliest place is one that wheels slipped to.
  bool isBySlip() const { return !all_.empty() && all_.front().has_slipped; }

  /// What the kept place lost to scans that speak for others: most of the scan does not fit there,
  /// so that furniture is no excuse, or it fits another place twice as well. Log odds.
  double refuted() const;

  /// Likeliest first; their masses sum up to 1. Of those that a scan judged, if it judged any.
  std::vector<Mode> modes() const;

 private:
  // Of searches and alignments; and of all, as where the core is there is room beyond that.
  static constexpr std::size_t kMostPlaces = 100, kMostOfAll = kMostPlaces + 20;
  static constexpr double kMargin = TrackingOdds::kMargin;
  static constexpr double kGoodFit = 0.05;  // m, of the best place, at which a scan says all it can
  static constexpr double kFarBetter = 0.5;  // of the error

  /// The number of places that are not too unlikely.
  std::size_t firstUnlikely(Against against) const;
  PlaceRefiner refinerFor(const Scan& scan) const;
  Place alignedCore(const PlaceRefiner& refiner, Hypothesis& hypothesis, const Place& before,
                    double usual);
  Place lookForSlip(const PlaceRefiner& refiner, const Hypothesis& kept, const Place& aligned,
                    double usual);

  bool hasLeader() const;
  std::size_t roomForOthers() const;
  bool keepsOne() const;
  double bestBesidesWord() const;
  void choose(double share);
  double trustInScans() const;
  double loss(double error, double usual) const;
  double tolerated(double level) const;
  void alignDue(const PlaceRefiner& refiner);
  void align(const PlaceRefiner& refiner, double usual, bool looks_for_slips);
  void alignTwins(const PlaceRefiner& refiner, const Pose2& correction, double usual);

  Gaussian2 correctedBySenses(const Hypothesis& hypothesis, const Observations& observations) const;
  void correctBySenses(const Observations& observations);

  double mostLost(const PlaceRefiner& refiner, const Hypothesis& hypothesis, bool fits,
                  double usual, const News& news) const;

  /// Of a scan, but for what other senses say. Log odds.
  double lostBy(const PlaceRefiner& refiner, Hypothesis& hypothesis, bool fits, double usual,
                const News& news) const;

  /// Log likelihood of each, in columns by the senses other than the laser, that of the likeliest
  /// being 0.
  Eigen::ArrayXXd scores(const Observations& observations) const;

  Ground ground_;
  Senses senses_;
  double least_error_{0.0};
  bool is_core_beside_{false};
  int slips_sought_{0};  // by the last scan, for so many places
  std::vector<Hypothesis> all_;
  std::vector<Hypothesis> led_to_;  // by the last alignment: places of their own
  Pose2 T_map_kept_;
  bool is_kept_ruled_out_{false};
  std::optional<double> left_out_;  // log odds of places for which there was no room,
  int left_out_count_{0};           // each of so many
};

/// The first of the modes that is the same place as a pose; null if there is none.
inline const Mode* modeAt(const Pose2& T_map_base, const std::vector<Mode>& modes) {
  for (const Mode& mode : modes) {
    if (areSamePlace(mode.T_map_base, T_map_base)) return &mode;
  }
  return nullptr;
}

}  // namespace adaptive_localization
