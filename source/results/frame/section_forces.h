// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/line_state.h"
#include "model/model.h"
#include "results/frame/cell_course.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace frictionbeam {

/**
 * N, Vy, Vz, Mx, My, Mz at all stations of a line in linear kinematics, as FrameBuilder gives them
 * with both sides of each node, for every instant of a motion: what depends on the cells alone is
 * worked out once, and cells that are alike share it. The course of a cell's forces is A u + B a -
 * the sum of the loads' own, a the accelerations (with alpha times the velocities, of mass damping)
 * of its unknowns.
 */
class SectionForces {
public:
  explicit SectionForces(const Model &model);

  unsigned int n_stations() const { return cells.size() * per_cell; }

  /// Between which values the forces of all stations of a cell are.
  struct Bounds {
    std::array<double, 6> low, high;
  };

  /// Call use(i, forces, n) for each cell with the forces of stations i to i + n - 1, six each;
  /// cells of which skip(cell, bounds) is true are left out.
  template <typename Skip, typename Use>
  void evaluate(const LineState &state, const Skip &skip, const Use &use) {
    sum_loads(state.load_factors);
    find_accelerations(state);
    for (unsigned int i = 0; i < cells.size(); ++i) {
      const Kind &kind = kinds[cells[i].kind];
      const CellCourse start = course_now(kind, cells[i], state.dofs);
      if (kind.arc < 0 && skip(i, bounds_of(kind, start)))
        continue;
      use(i * per_cell, forces_of(kind, start), per_cell);
    }
  }
  unsigned int n_cells() const { return cells.size(); }

private:
  using Matrix6x12 = Eigen::Matrix<double, 6, 12>;

  /// Cells of equal length, direction, section and loads. The course of a straight one is in its
  /// local axes, of an arc in t, n, b where the deal.II cell begins.
  struct Kind {
    Matrix6x12 start;              ///< forces there of unit motions
    PipeElement::Matrix12 inertia; ///< courses of unit accelerations
    std::vector<CellCourse> loads; ///< of each load at factor 1
    int arc = -1;                  ///< among those that differ; -1: straight
    double spacing = 0.;           ///< of stations [m]
    CellCourse sum;                ///< of the loads at present
  };
  /// Forces at each station of an arc, in its own axes, of unit courses.
  using ArcStations = std::vector<Matrix6x12>;
  struct Cell {
    unsigned int kind = 0;
    std::array<unsigned int, 12> dofs{};
  };

  Kind make_kind(const Model &model, const unsigned int index);
  /// @param reversed whether the route goes against the deal.II cell
  /// @param turn into t, n, b where the cell begins
  ArcStations stations_of(const ArcBeam &arc, const bool reversed,
                          const Eigen::Matrix3d &turn) const;
  /// Place of those like them among the arcs, to which they are added if there are none.
  int find_arc(const ArcStations &stations);
  void sum_loads(const std::vector<double> &factors);
  /// Empty where nothing moves.
  void find_accelerations(const LineState &state);
  CellCourse course_now(const Kind &kind, const Cell &cell, const Vector &dofs) const {
    CellCourse course = kind.sum;
    for (unsigned int i = 0; i < 12; ++i)
      course.head<6>() += dofs[cell.dofs[i]] * kind.start.col(i);
    if (accelerations.size() > 0)
      for (unsigned int i = 0; i < 12; ++i)
        course += accelerations[cell.dofs[i]] * kind.inertia.col(i);
    return course;
  }
  /// Of a straight cell: forces are linear along it, and moments at most q L^2/8 off the chord.
  Bounds bounds_of(const Kind &kind, const CellCourse &start) const {
    const double L = (per_cell - 1) * kind.spacing;
    Bounds result;
    const auto set = [&](const unsigned int c, const double end, const double arch) {
      result.low[c] = std::min(start[c], end) - arch;
      result.high[c] = std::max(start[c], end) + arch;
    };
    for (unsigned int c = 0; c < 3; ++c)
      set(c, start[c] - L * start[6 + c], 0.);
    set(3, start[3] + L * start[9], 0.);
    set(4, start[4] + L * (start[2] - L / 2. * start[8] + start[10]),
        L * L / 8. * std::abs(start[8]));
    set(5, start[5] - L * (start[1] - L / 2. * start[7] - start[11]),
        L * L / 8. * std::abs(start[7]));
    return result;
  }
  const double *forces_of(const Kind &kind, const CellCourse &start);

  const Model &model;
  const unsigned int per_cell; ///< stations
  std::vector<Kind> kinds;
  std::vector<ArcStations> arcs; ///< that differ: all bends of one radius have a few
  std::vector<Cell> cells;       ///< in the order of the frames' stations
  std::vector<double> buffer;
  Vector accelerations; ///< of all degrees of freedom, a + alpha v
};

bool is_at_rest(const LineState &state);

/// a + alpha v of a degree of freedom of a state in motion, alpha of mass damping: times a mass,
/// the force that it takes [m/s2, rad/s2].
double damped_acceleration(const Model &model, const LineState &state,
                           const dealii::types::global_dof_index dof);

/// Whether forces have inertia in them that is to be told: the line moves, and no rigid stop was
/// struck within the increment, where accelerations are an impulse over the time step.
bool has_inertia(const Model &model, const LineState &state);

/// Whether forces N, Vy, Vz or moments Mx, My, Mz differ by more than rounding does.
bool section_forces_jump(const Motion &before, const Motion &after);

} // namespace frictionbeam
