// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/statics/nonlinear_statics.h"
#include "analysis/statics/slope_search.h"

#include "base/interruption.h"
#include "base/number_text.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace frictionbeam {

using namespace dealii;

namespace {

constexpr double most_turn = 0.5;              // of a vertex in one iteration [rad]
constexpr unsigned int most_improvements = 10; // of a mechanism
constexpr double rounding_of_pivots = 1e-12;   // of the largest stiffness

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

} // namespace

NonlinearStatics::NonlinearStatics(const Model &model) : model(model), linearized(model) {
  if (!model.cells.pipe_sections().any() || model.cells.turns_far())
    return;
  const Pose rest = model.cells.at_rest();
  LineCells::Balance elastic;
  model.cells.evaluate({rest, rest, rest, rest.dofs, 0., {}, nullptr, &rest, true},
                       std::vector<double>(model.scene.loads.size(), 0.), elastic);
  linearized.keep(elastic.stiffness);
}

NonlinearStatics::Approach NonlinearStatics::begin(const LineState &from,
                                                   const StaticIncrement &increment) {
  const Pose pose = pose_of(from);
  LineCells::Balance &balance = balance_at_hand;
  model.cells.evaluate({pose, pose, pose, pose.dofs, 0., {}, nullptr, &pose, true},
                       from.load_factors, balance);
  const double largest_before =
      std::max(increment.least_force, balance.largest); // a line may lose all its forces
  const Vector imposed =
      increment.course.imposed(increment.time) - increment.course.imposed(from.time);
  return {model.cells.moved(pose, imposed),
          Vector::Zero(from.unknowns.size()),
          increment.factors,
          {increment.course.time_of_laws(increment.time), increment.time - from.time},
          pose,
          largest_before,
          balance};
}

void NonlinearStatics::evaluate(Approach &at, const bool is_trial) const {
  LineCells::Step step{at.pose,  at.pose, at.pose,   at.pose.dofs, 0.,
                       at.clock, nullptr, &at.start, is_trial};
  step.is_near_last = at.is_answered;
  model.cells.evaluate(step, at.factors, at.balance);
  at.is_answered = !is_trial && !at.balance.failed;
  at.forces = at.balance.forces + model.contacts.platen_forces();
  at.largest = std::max(at.largest_before, at.balance.largest);
}

bool NonlinearStatics::is_solved(Approach &at, const ContactResponse &response,
                                 EquilibriumResult &result) const {
  Vector of_contacts = Vector::Zero(at.forces.size());
  model.contacts.add_forces(response, of_contacts);
  at.largest = std::max(at.largest, largest_contact_force(model.contacts, response));
  const Vector left = at.forces - of_contacts;
  const double size = left.size() > 0 ? left.lpNorm<Eigen::Infinity>() : 0.; // 0: all is held
  const double scale = std::max(at.largest, at.balance.free);
  result.residual = scale > 0. ? size / scale : size;
  const auto rounding = [&]() {
    LineCells::Balance beside;
    const Pose pose = with_other_digits(model, at.pose);
    model.cells.evaluate({pose, pose, pose, pose.dofs, 0., at.clock, nullptr, &at.start},
                         at.factors, beside);
    return (beside.forces - at.balance.forces).lpNorm<Eigen::Infinity>();
  };
  return is_balanced(model, at.balance.stiffness, size, at.largest, at.pose, rounding, scale);
}

bool NonlinearStatics::follows_creep(const Approach &at, EquilibriumResult &result) {
  const double allowed = model.scene.solver.creep_tolerance;
  too_long = at.balance.section_error > allowed;
  if (!too_long)
    return true;
  result.remark = "the increment is too long for creep: a stress would be off by " +
                  rounded_number(at.balance.section_error, 2) + " of itself, Creep tolerance is " +
                  rounded_number(allowed, 2);
  return false;
}

bool NonlinearStatics::move(const Vector &change, Approach &at) const {
  Vector dofs;
  model.space.expand(change, dofs);
  const double turn =
      model.cells.turns_far() ? largest_turn(model.discretization, dofs) : 0.; // small ones add up
  const double part = turn > most_turn ? most_turn / turn : 1.;
  at.moved += part * change;
  at.pose = model.cells.moved(at.pose, part * dofs);
  return part == 1.;
}

bool NonlinearStatics::search(const Pose &from, const Vector &moved, const Vector &change,
                              const Vector &before, const Vector &of_contacts, Approach &at) const {
  const double slope = -(before - of_contacts).dot(change);
  if (model.cells.turns_far() && slope >= 0.) { // where the potential is not convex
    evaluate(at, false);
    return true;
  }
  Vector dofs;
  model.space.expand(change, dofs);
  const auto slope_at = [&](const double length) {
    at.moved = moved + length * change;
    at.pose = model.cells.moved(from, length * dofs);
    evaluate(at, false);
    return at.balance.failed ? std::numeric_limits<double>::max()
                             : -(at.forces - of_contacts).dot(change);
  };
  return search_slope(slope, slope_at) == 1.;
}

namespace {
/// Whether the forces left over have hardly changed in several steps, the last of which began with
/// @p before.
bool gives_way(const Vector &before, const NonlinearStatics::Approach &at, unsigned int &in_vain) {
  constexpr double hardly = 0.05;
  constexpr unsigned int several = 6;
  const bool is_same =
      (at.forces - before).lpNorm<Eigen::Infinity>() <= hardly * before.lpNorm<Eigen::Infinity>();
  in_vain = is_same ? in_vain + 1 : 0;
  return in_vain == several;
}
} // namespace

EquilibriumResult NonlinearStatics::solve(const LineState &from, const StaticIncrement &increment,
                                          LineState &to, ContactResponse &response) {
  Approach at = begin(from, increment);
  too_long = false;
  EquilibriumResult result;
  Vector change;
  bool judged = false; // whether the contacts' forces are those at the pose
  const bool may_search =
      model.cells.pipe_sections().any() && !(model.cells.turns_far() && increment.finds_limit);
  bool is_searched = false;
  unsigned int steps_in_vain = 0;
  std::vector<Contact::Strains> contact_forces = from.contact_stress;
  for (;;) {
    interruption::end_if_overdue();
    // Sections that yield begin with what they would do elastically, whatever they did before.
    if (!is_searched)
      evaluate(at, result.iterations == 0);
    if (at.balance.failed || !at.forces.allFinite()) {
      result.remark = at.balance.failed ? "a section that yields or creeps has no answer"
                                        : "the iteration diverges";
      remember_failure(at, from, increment);
      return result;
    }
    if (judged && is_solved(at, response, result)) {
      if (!follows_creep(at, result))
        return result;
      result.converged = true;
      to.sections.swap(at.balance.sections);
      if (model.cells.pipe_sections().any())
        last_tangent = at.balance.stiffness;
      to.unknowns = from.unknowns + at.moved;
      model.space.expand(at.moved, last_motion);
      set_pose(model, at.pose, to);
      return result;
    }
    const auto solve_at_pose = [&]() {
      EquilibriumProblem problem{{at.balance.stiffness, at.forces}, at.pose.dofs};
      problem.increment = {at.clock.time, 0., model.contacts.temperatures(increment.factors)};
      problem.largest_force = at.largest;
      problem.force_so_far = std::max(increment.force_so_far, at.balance.free);
      problem.forces_before = &contact_forces;
      return linearized.solve(problem, from.contacts, change, response);
    };
    if (!iterate(model.scene.solver.max_iterations, solve_at_pose, result)) {
      remember_failure(at, from, increment);
      return result;
    }
    contact_forces = response.stress;
    const Vector forces = at.forces, moved = at.moved;
    const Pose pose = at.pose;
    judged = move(change, at);
    // Beyond the limit of supports that slip nothing helps: far motions show the mechanism then.
    is_searched =
        judged && result.iterations > 1 && may_search &&
        (model.contacts.size() == 0 || 2 * result.iterations < model.scene.solver.max_iterations);
    if (is_searched) {
      Vector of_contacts = Vector::Zero(forces.size());
      model.contacts.add_forces(response, of_contacts);
      judged = search(pose, moved, change, forces, of_contacts, at) || model.contacts.size() == 0;
    }
    if (is_searched && model.contacts.size() == 0 && gives_way(forces, at, steps_in_vain)) {
      result.remark = "the line gives way: it moves on and on without coming nearer to equilibrium";
      remember_failure(at, from, increment);
      return result;
    }
  }
}

std::optional<Collapse> NonlinearStatics::collapse(const LineState &at,
                                                   const std::vector<double> &begin,
                                                   const std::vector<double> &end) const {
  if (!model.cells.pipe_sections().any())
    return {};
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
  for (const Vector *const motion :
       {&last_motion, &failed_motion, &softest_at_failure, &softest_before})
    try_motion(*motion);
  if (best && model.contacts.size() == 0) { // whose motion contacts would have to allow
    const Vector gain = loads_on_unknowns(at, end) - loads_on_unknowns(at, begin);
    for (const double turn : {1e-4, 1e-3, 1e-2})
      for (unsigned int k = 0;
           k < most_improvements && try_motion(softer_motion(at, mechanism, turn, end, gain)); ++k)
        ;
  }
  return best;
}

Vector NonlinearStatics::loads_on_unknowns(const LineState &at,
                                           const std::vector<double> &factors) const {
  LineCells::Balance balance;
  model.cells.evaluate(pose_of(at), factors, balance);
  return model.space.restrict_forces(balance.loads);
}

Vector NonlinearStatics::softer_motion(const LineState &at, const Vector &motion, const double turn,
                                       const std::vector<double> &factors,
                                       const Vector &forces) const {
  const double present = largest_turn(model.discretization, motion);
  if (!(present > 0.))
    return {};
  const Pose start = pose_of(at), moved = model.cells.moved(start, turn / present * motion);
  LineCells::Balance balance;
  model.cells.evaluate({moved, moved, moved, moved.dofs, 0., {}, nullptr, &start}, factors,
                       balance);
  return balance.failed ? Vector() : soft_motion(balance.stiffness, forces);
}

void NonlinearStatics::remember_failure(const Approach &at, const LineState &from,
                                        const StaticIncrement &increment) {
  if (!model.cells.pipe_sections().any())
    return;
  model.space.expand(at.moved, failed_motion);
  softest_at_failure.resize(0);
  softest_before.resize(0);
  if (model.contacts.size() > 0 || at.forces.size() == 0)
    return; // whose motion contacts would have to allow
  softest_at_failure = soft_motion(at.balance.stiffness, at.forces);
  if (last_tangent.rows() == at.forces.size())
    softest_before = soft_motion(last_tangent, increment.course.forces(increment.factors) -
                                                   increment.course.forces(from.load_factors));
}

Vector NonlinearStatics::soft_motion(SparseMatrix tangent, const Vector &forces) const {
  constexpr double shift = 1e-8; // of the stiffness: below what is elastic, above a mechanism's
  for (int i = 0; i < tangent.rows(); ++i)
    tangent.coeffRef(i, i) += shift * std::abs(tangent.coeff(i, i));
  Vector motion, dofs;
  LinearizedSolver shifted(model);
  if (shifted.solve_without_contacts(tangent, forces, motion))
    model.space.expand(motion, dofs);
  return dofs;
}

void NonlinearStatics::transfer(Archive &archive) {
  linearized.transfer(archive);
  int n = last_tangent.rows();
  std::vector<int> outer(last_tangent.outerIndexPtr(),
                         last_tangent.outerIndexPtr() + (n > 0 ? n + 1 : 0)),
      inner(last_tangent.innerIndexPtr(),
            last_tangent.innerIndexPtr() + (n > 0 ? last_tangent.nonZeros() : 0));
  std::vector<double> values(last_tangent.valuePtr(), last_tangent.valuePtr() + inner.size());
  archive(last_motion, failed_motion, softest_at_failure, softest_before, n, outer, inner, values);
  if (archive.reads())
    last_tangent = n > 0 ? SparseMatrix(Eigen::Map<const SparseMatrix>(
                               n, n, values.size(), outer.data(), inner.data(), values.data()))
                         : SparseMatrix();
}

Vector NonlinearStatics::forces_on_contacts(const LineState &state, const LoadCourse &) const {
  LineCells::Balance balance;
  model.cells.evaluate(pose_of(state), state.load_factors, balance);
  return balance.forces + model.contacts.platen_forces();
}

bool NonlinearStatics::is_unstable(const LineState &state) const {
  constexpr double same = 1e-9, stiff = 1e3; // parts of the stiffest
  if (!model.cells.turns_far() || state.unknowns.size() == 0)
    return false;
  LineCells::Balance balance;
  model.cells.evaluate(pose_of(state), state.load_factors, balance);
  const SparseMatrix symmetric = symmetric_part(balance.stiffness);
  const double largest = symmetric.diagonal().cwiseAbs().maxCoeff();
  if ((balance.stiffness - symmetric).norm() > same * symmetric.norm())
    return false; // loads that follow the line have no potential, nor signs that would tell
  std::vector<Eigen::Triplet<double>> of_contacts;
  for (unsigned int i = 0; i < model.contacts.size(); ++i) {
    const Contact &contact = model.contacts[i];
    if (state.contact_status[i] == ContactStatus::open)
      continue;
    const auto B = contact.B.topRows<3>();
    const Eigen::MatrixXd block =
        stiff * largest * contact.length * contact.length * B.transpose() * B;
    for (unsigned int a = 0; a < contact.unknowns.size(); ++a)
      for (unsigned int b = 0; b < contact.unknowns.size(); ++b)
        of_contacts.emplace_back(contact.unknowns[a], contact.unknowns[b], block(a, b));
  }
  SparseMatrix held(symmetric.rows(), symmetric.cols());
  held.setFromTriplets(of_contacts.begin(), of_contacts.end());
  const SparseMatrix tangent = symmetric + held;
  contact::LineFactorization factors;
  factors.analyze(tangent);
  return factors.factorize(tangent) && factors.least_pivot() < -rounding_of_pivots * largest;
}

EnergyAccount NonlinearStatics::account(const LineState &before, const LineState &after,
                                        const LoadCourse &course, const Vector &unbalanced) const {
  EnergyAccount account = account_cells(model, before, after, before.load_factors,
                                        course.imposed(after.time) - course.imposed(before.time));
  account += account_contacts(model, before, after, {});
  account.external -= unbalanced.dot(after.unknowns - before.unknowns) / 2.;
  return account;
}

} // namespace frictionbeam
