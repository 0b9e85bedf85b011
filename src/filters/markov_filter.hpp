// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "adaptive_localization/core/options.hpp"
#include "adaptive_localization/core/rng.hpp"
#include "adaptive_localization/filters/filter.hpp"
#include "adaptive_localization/motion/motion_model.hpp"
#include "adaptive_localization/observation/observation_model.hpp"
#include "pending_motion.hpp"
#include "pose_histogram.hpp"

namespace adaptive_localization {

struct MarkovOptions {
  double markov_cell{0.1};
  int markov_headings{90};
  double markov_anywhere{0.0};
  int cloud_particles{500};
  double markov_max_memory{1000.0};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("markov_cell", markov_cell, Range{0.02, 10}, "m",
           "Side of a cell of the belief; smaller values are raised to the side of the map's cells "
           "(markov).");
    option("markov_headings", markov_headings, Range{8, 720}, "",
           "Headings in each cell of the belief (markov).");
    option("markov_anywhere", markov_anywhere, Range{0, 1}, "",
           "Probability at each update that the robot was carried elsewhere; 0: only cells that "
           "may hold it are updated.");
    option("cloud_particles", cloud_particles, Range{1, 100000}, "",
           "Particles drawn from the belief of ekf_icp or markov, published and used where the "
           "belief has no simpler form.");
    option("markov_max_memory", markov_max_memory, Range{1, 1e6}, "MB",
           "Memory limit of the belief; maps that need more are refused.");
  }
};

struct MarkovParts {
  std::unique_ptr<MotionModel> motion;
  std::unique_ptr<ObservationModel> observation;
  std::shared_ptr<const OccupancyGrid> map;
};

/// Markov localization on a grid (Burgard, Fox, Hennig, Schmidt, AAAI 1996; Fox, Burgard, Thrun,
/// JAIR 11, 1999): the belief is a histogram over all poses,
///
///     predict   Bel(x)  <-  sum_x' p(x | x', odometry) Bel(x')
///     correct   Bel(x)  <-  eta p(z | x) Bel(x)
///
/// with the same models as particle filters, and nothing left to chance: what it believes is what
/// those approach with ever more particles, as far as cells are small. Only cells that hold a
/// millionth of the fullest one are weighed (selective update). Hits get the deviation in addition
/// that a pose has within its cell.
class MarkovFilter : public Filter {
 public:
  MarkovFilter(const MarkovOptions& options, MarkovParts parts, std::uint64_t seed);

  void reset(const Prior& prior) override;
  Estimate update(const Pose2& motion, const Observations& observations) override;
  Estimate estimate() const override { return estimate_; }
  const Particles& hypotheses() const override { return cloud_; }

 private:
  void move(const Pose2& motion);
  void weigh(const Observations& observations);
  void summarizeBelief();

  MarkovOptions options_;
  MarkovParts parts_;
  PoseHistogram belief_;
  Estimate estimate_;
  Particles cloud_;
  PendingMotion pending_;
  Rng rng_;
};

/// What laser_sigma_hit, m, is for hits seen from anywhere within a cell and heading: variances of
/// uniform deviations in addition, at a middling range.
double sigmaInCells(double sigma_hit, const MarkovOptions& options);

/// Throws std::invalid_argument naming options and price if the belief takes more memory than it
/// may, or one look at all cells would hold up a robot for seconds.
void checkPriceOfCells(const MarkovOptions& options, const OccupancyGrid& map, int beams,
                       double price_of_beam);

}  // namespace adaptive_localization
