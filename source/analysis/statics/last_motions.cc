// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/statics/last_motions.h"

#include "analysis/statics/linearized_solver.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

using namespace dealii;

namespace {
constexpr unsigned int most_improvements = 10; // of a mechanism

/// Part of the way of the loads, which grow evenly, that a state has come.
double reached(const LineState &at, const std::vector<double> &begin,
               const std::vector<double> &end) {
  double part = 0., largest = 0.;
  for (unsigned int l = 0; l < end.size(); ++l)
    if (const double way = end[l] - begin[l]; std::abs(way) > largest) {
      largest = std::abs(way);
      part = (at.load_factors[l] - begin[l]) / way;
    }
  return part;
}
} // namespace

/// Of a vertex, among changes of all degrees of freedom [rad].
double largest_turn(const Discretization &discretization, const Vector &dofs) {
  double turn = 0.;
  for (unsigned int v = 0; v < discretization.n_line_vertices(); ++v)
    for (unsigned int c = 3; c < 6; ++c)
      if (const auto dof = discretization.vertex_dofs().index(v, c);
          dof != numbers::invalid_dof_index)
        turn = std::max(turn, std::abs(dofs[dof]));
  return turn;
}

void LastMotions::add_solved(const Vector &moved, const SparseMatrix &tangent) {
  model.space.expand(moved, solved);
  last_tangent = tangent;
}

void LastMotions::add_failure(const Vector &moved, const SparseMatrix &tangent,
                              const Vector &forces, const Vector &gain) {
  model.space.expand(moved, failed);
  softest_at_failure.resize(0);
  softest_before.resize(0);
  if (model.contacts.size() > 0 || forces.size() == 0)
    return; // whose motion contacts would have to allow
  softest_at_failure = soft_motion(tangent, forces);
  if (last_tangent.rows() == forces.size())
    softest_before = soft_motion(last_tangent, gain);
}

std::optional<Collapse> LastMotions::collapse(const LineState &at, const std::vector<double> &begin,
                                              const std::vector<double> &end) const {
  std::optional<Collapse> best;
  Vector mechanism;
  const auto try_motion = [&](const Vector &motion) {
    if (motion.size() == 0 || !motion.allFinite())
      return false;
    const auto found = find_collapse(model, at, motion, begin, end);
    if (!found || std::isnan(found->bound) || (best && found->bound >= best->bound))
      return false;
    best = found;
    mechanism = motion;
    return true;
  };
  const double proved = (1. + open_by_proof) * reached(at, begin, end);
  for (const Vector *const motion : {&solved, &failed, &softest_at_failure, &softest_before})
    if (try_motion(*motion) && best->bound <= proved)
      return best;
  if (best && model.contacts.size() == 0) { // whose motion contacts would have to allow
    const Vector gain = loads_on_unknowns(at, end) - loads_on_unknowns(at, begin);
    for (const double turn : {1e-4, 1e-3, 1e-2})
      for (unsigned int k = 0;
           k < most_improvements && try_motion(softer_motion(at, mechanism, turn, end, gain)); ++k)
        ;
  }
  return best;
}

Vector LastMotions::loads_on_unknowns(const LineState &at,
                                      const std::vector<double> &factors) const {
  LineCells::Balance balance;
  model.cells.evaluate(pose_of(at), factors, balance);
  return model.space.restrict_forces(balance.loads);
}

Vector LastMotions::softer_motion(const LineState &at, const Vector &motion, const double turn,
                                  const std::vector<double> &factors, const Vector &forces) const {
  const double present = largest_turn(model.discretization, motion);
  if (!(present > 0.))
    return {};
  const Pose start = pose_of(at), moved = model.cells.moved(start, turn / present * motion);
  LineCells::Balance balance;
  model.cells.evaluate({moved, moved, moved, moved.dofs, 0., {}, nullptr, &start}, factors,
                       balance);
  return balance.failure ? Vector() : soft_motion(balance.stiffness, forces);
}

Vector LastMotions::soft_motion(SparseMatrix tangent, const Vector &forces) const {
  constexpr double shift = 1e-8; // of the stiffness: below what is elastic, above a mechanism's
  for (int i = 0; i < tangent.rows(); ++i)
    tangent.coeffRef(i, i) += shift * std::abs(tangent.coeff(i, i));
  Vector motion, dofs;
  LinearizedSolver shifted(model);
  if (shifted.solve_without_contacts(tangent, forces, motion))
    model.space.expand(motion, dofs);
  return dofs;
}

void LastMotions::transfer(Archive &archive) {
  int n = last_tangent.rows();
  std::vector<int> outer(last_tangent.outerIndexPtr(),
                         last_tangent.outerIndexPtr() + (n > 0 ? n + 1 : 0)),
      inner(last_tangent.innerIndexPtr(),
            last_tangent.innerIndexPtr() + (n > 0 ? last_tangent.nonZeros() : 0));
  std::vector<double> values(last_tangent.valuePtr(), last_tangent.valuePtr() + inner.size());
  archive(solved, failed, softest_at_failure, softest_before, n, outer, inner, values);
  if (archive.reads())
    last_tangent = n > 0 ? SparseMatrix(Eigen::Map<const SparseMatrix>(
                               n, n, values.size(), outer.data(), inner.data(), values.data()))
                         : SparseMatrix();
}

} // namespace frictionbeam
