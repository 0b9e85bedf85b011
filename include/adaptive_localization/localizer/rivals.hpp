// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "adaptive_localization/core/belief.hpp"
#include "adaptive_localization/core/observations.hpp"
#include "adaptive_localization/core/options.hpp"
#include "adaptive_localization/map/distance_field.hpp"
#include "adaptive_localization/ser/places.hpp"

namespace adaptive_localization {

class PlaceRefiner;

struct RivalsOptions {
  double rival_margin{6.0};
  double rival_scale{0.1};
  double rival_tolerance{0.015};
  double rival_tolerance_share{0.25};
  double rival_beams{15.0};
  double rival_distance{0.3};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("rival_margin", rival_margin, kPositive, "",
           "How much better than all other places one must explain the scans to be the only one: "
           "natural logarithm of the ratio of likelihoods.");
    option("rival_scale", rival_scale, kPositive, "m",
           "Mean range error per beam that makes a place e times less likely, per independent "
           "beam.");
    option("rival_tolerance", rival_tolerance, kNotNegative, "m",
           "Differences of the mean range error below this tell nothing: maps are no better.");
    option("rival_tolerance_share", rival_tolerance_share, kNotNegative, "",
           "The tolerance grows by this share of the least error: where even the best place leaves "
           "much unexplained, a little more tells nothing.");
    option("rival_beams", rival_beams, kPositive, "",
           "How many independent beams a scan is worth when places are compared.");
    option("rival_distance", rival_distance, kPositive, "m",
           "Way (or turn, in rad) after which a scan is new evidence about places.");
  }
};

/// What a scan says of a place; unknown as long as nobody can tell: without a grid, or blinded.
enum class Verdict { kUnknown, kWrong, kPossible, kRight };

/// Keeps account of all places where the robot may be, for as long as there is more than one, so
/// that nobody claims to know where it is before the others are ruled out.
///
/// The places come from the global search. Each is moved with the odometry, aligned with each scan,
/// and judged by its mean truncated range error e against the least of all:
///
///     log likelihood -= w beams max(0, e - (1 + share) e_min - tolerance) / scale
///
/// w <= 1 is the share of the scan that is new: the way travelled since the last one over
/// rival_distance. Unlike the modes of a particle cloud, masses of places that look the same do not
/// drift: only what can be seen decides between them.
class Rivals {
 public:
  Rivals(const RivalsOptions& options, std::shared_ptr<const OccupancyGrid> map,
         std::shared_ptr<const DistanceField> field, std::shared_ptr<Places> places);

  /// The robot may be anywhere from now on; most likely, if that is given, where it was thought to
  /// be.
  void open(const std::optional<Pose2>& T_map_base = std::nullopt);

  /// Somebody says where the robot is: there are no rivals.
  void close();

  /// Whether a robot can be at, or right beside, a pose: not if some other place explains a scan so
  /// much better, surely if no other one does.
  Verdict judge(const Pose2& T_map_base, const Observations& observations) const;

  /// Goes on with what another one knows.
  void goOnFrom(const Rivals& other);

  /// Takes note of a scan, of the motion since the last one, and of where the filter believes to
  /// be.
  void observe(const Pose2& motion, const Pose2& T_map_base, const Observations& observations);

  /// Scans in a row that ruled out the place that the filter believes in, while another explains
  /// them.
  int contradictions() const { return contradictions_; }

  /// Mean range error, m, of the last scan at the place that explains it best.
  double leastError() const { return least_error_; }

  /// No other place than the one believed in explains what was seen.
  bool isSettled() const { return settled_; }

  /// The mass of the place around a pose; 1 if there are no rivals at all.
  double shareOf(const Pose2& T_map_base) const;

  /// The places left, most likely first, with their masses; empty once settled.
  const std::vector<Mode>& modes() const { return modes_; }

 private:
  struct Hypothesis {
    Pose2 T_map_base;
    double log_likelihood{0.0};
    double error{0.0};
    bool is_new{true};  // not judged yet: the scan counts in full
  };

  void align(const PlaceRefiner& refiner, Hypothesis& hypothesis) const;
  void believe(const PlaceRefiner& refiner, const Pose2& T_map_base);
  bool knows(const Pose2& T_map_base) const;
  double best() const;
  double loss(double error, double least) const;
  bool searchIsDue();
  void search(const Observations& observations);
  void weigh(double share);
  void conclude(const Pose2& T_map_base);

  RivalsOptions options_;
  std::shared_ptr<const OccupancyGrid> map_;
  std::shared_ptr<const DistanceField> field_;
  std::shared_ptr<Places> places_;
  bool settled_{true};
  bool searched_{false};  // and something was found
  int contradictions_{0};
  double least_error_{0.0};
  bool explained_{false};  // some place explains the last scan
  int scans_until_search_{0};
  int pause_{0};     // scans between searches that find nothing
  double way_{0.0};  // since the last scan that counted
  double way_since_search_{0.0};
  std::vector<Hypothesis> hypotheses_;
  std::vector<Mode> modes_;
};

}  // namespace adaptive_localization
