// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/archive.h"
#include "model/model.h"

#include <optional>
#include <string>

namespace frictionbeam {

/**
 * The path of equilibria of a static step that looks for the largest part of its loads that is
 * carried: how far its next increment goes, and which unknown leads it.
 *
 * The unknown that has moved most in the last increment is taken for the path's parameter, and the
 * load is what comes out (W. C. Rheinboldt, J. V. Burkardt, ACM TOMS 9 (1983) 215-235,
 * doi:10.1145/357456.357460): its arc length in the largest norm. So it goes on over points where
 * the load is stationary. Motions are measured by
 * translations [m]; rotations count with a tenth of the line's extent.
 */
class LimitPath {
public:
  explicit LimitPath(const Model &model);

  /// An increment to try.
  struct Trial {
    double part;                         ///< of the loads at its end; expected if it is led
    std::optional<unsigned int> unknown; ///< that is led; none: the loads are given
    double motion = 0.;                  ///< of the unknown
    double size = 0.;                    ///< of the motion, as expected; 0: not known
    const Vector *before = nullptr;      ///< with an unknown: PathLead::before
  };
  /// @param most of the loads in one increment
  /// @param by_work whether increments are led by the loads' work, not by an unknown
  void begin(const double most, const bool by_work);
  Trial next(const double done) const;

  /// Whether a solution in large displacements is further from what was expected than one increment
  /// may be, so that it may stand on another branch.
  bool strays(const Trial &trial, const Vector &motion, const double done, const double part) const;
  /// An increment of given loads, by how much the line is expected to move in it.
  Trial given(const double part, const double done) const;
  /// Try again with half of the motion. @return whether there is anything left to halve
  bool halve(const Trial &trial, const bool is_passed);
  /// Half of it as often as it takes.
  void halve_again(const Trial &trial) { cut(trial); }
  /// An increment is accepted. @param gain part of the loads in it @param done at its end
  void add(const Vector &motion, const double gain, const double done);

  /// Whether it goes on and on and the loads do not grow.
  bool is_flat() const;
  /// Number of increments, the last ones, in which they have hardly grown.
  unsigned int n_soft_increments() const { return n_soft; }
  /// Whether it has been halved, in all, more often than lines that collapse ask for.
  bool is_lost() const { return n_cuts > most_cuts; }
  void lose() { n_cuts = most_cuts + 1; }
  bool is_passed() const { return n_passed > 0; }
  /// Whether the loads have not moved the line so far.
  bool is_at_rest() const { return measure(motion) == 0.; }
  /// Where the line has moved most in the last increment, in plain words.
  std::string place_of_most_motion() const;
  void transfer(Archive &archive);

private:
  double measure(const Vector &motion) const;
  void cut(const Trial &trial);
  double slope() const { return gain / measure(motion); }
  static constexpr unsigned int most_cuts = 20;

  const Model &model;
  Vector weights;               ///< of the unknowns' motions [m]; empty if no step finds its limit
  double extent;                ///< of the line [m]
  Vector motion;                ///< of the unknowns in the last increment; empty before the first
  double gain = 0.;             ///< part of the loads in it
  double size = 0.;             ///< of the next
  double first = 1., most = 1.; ///< parts of the loads in an increment
  double first_slope = 0.;      ///< gain by motion [1/m]
  unsigned int n_flat = 0, n_halved = 0, n_passed = 0; ///< the first two in a row
  unsigned int n_soft = 0, n_cuts = 0, n_steady = 0;   ///< in a row, in all, to come at one size
  bool by_work = false;
};

} // namespace frictionbeam
