// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "adaptive_localization/core/observations.hpp"
#include "adaptive_localization/core/pose2.hpp"
#include "echo_line.hpp"
#include "match/line_options.hpp"

namespace adaptive_localization {

/// Straight walls as sonars hear them on the way: echoes of the last metres ride along on the
/// odometry, and those whose arcs one line touches are a line of the base now. An echo of range r
/// heard at p within a cone around course c is of a wall whose normal n points along alpha if
///
///     n . p + r = rho,   |alpha - c| <= half the cone.
///
/// A line is looked for through each new echo, at all alpha within its cone (footprint association,
/// Lee and Song 2010), and is the one that most others touch too, to within their noise. Between
/// neighbours on it no robot can pass (Crowley 1989), and fewer echoes came from behind it than
/// from it. Then follow least squares over (rho, alpha),
/// with which all cones have to agree. Cones tell no more of a direction than that: where a wall
/// turns away from one, its side hears the wall as well. So a line whose direction the ranges leave
/// unsure is none yet, and a wall that is driven at squarely is found late. With m_i the estimate's
/// Jacobian by echo i, s_i its deviation, and Q_i the covariance of odometry since,
///
///     C = sum_ij m_i S_ij m_j^T,   S_ij = delta_ij s_i^2 + g_i Q_k g_j^T,   g_i = (n, p_i x n),
///
/// k the younger of i and j: what odometry did since then moved both. The pose that a line corrects
/// was moved by the same odometry; that is left out.
///
/// Units m and rad. Echoes that made a line are used up. Never throws, and nothing that is not
/// finite comes out, whatever goes in.
class SonarLines {
 public:
  explicit SonarLines(const LineOptions& options) : options_(options) {}

  /// Moves on by odometry, motion = T_previous_current with its noise in the previous pose's frame.
  void move(const Pose2& motion, const Eigen::Matrix3d& noise);

  /// Takes note of echoes, from where base is now. A sonar that has not moved since is heard anew.
  void hear(const std::vector<SonarReading>& readings);

  /// The lines that echoes heard since the last call are on, the best first.
  std::vector<ScanLine> takeLines();

  void forget() {
    echoes_.clear();
    heard_ = 0;
  }

  /// Kept for lines to come.
  std::size_t size() const { return echoes_.size(); }

 private:
  struct Guess;

  Guess bestThrough(const SonarEcho& echo) const;
  std::vector<std::size_t> touching(double rho, double alpha) const;
  std::size_t passing(const ScanLine& line) const;
  std::optional<ScanLine> take(double rho, double alpha);

  LineOptions options_;
  std::vector<SonarEcho> echoes_;  // the oldest first
  std::size_t heard_{0};           // of the last, how many are new
};

}  // namespace adaptive_localization
