// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/contact_problem/global_contact_problem.h"
#include "model/load_forces.h"

#include <frictionbeam/contact/line_factorization.h>

#include <cmath>

namespace frictionbeam {

namespace {

constexpr unsigned int dimension = 3;

using Triplets = std::vector<Eigen::Triplet<double>>;

std::string find_obstacle(const Model &model) {
  const Contacts &contacts = model.contacts;
  if (!model.scene.solver.is_exact())
    return "the method is not 'exact'";
  if (model.linear.has_pressed_parts())
    return "pressure stiffens a solid part of the line, whose stiffness changes with it";
  for (unsigned int i = 0; i < contacts.size(); ++i) {
    const std::string support = model.scene.supports[contacts[i].support].name;
    if (!contacts[i].law.has_closed_form())
      return "the law of support " + support +
             " has no threshold in closed form, as FCLIB's format has it";
    if (contacts[i].law.closed_form().torsional_rigidity > 0. && !contacts[i].B.row(3).isZero(0.))
      return "support " + support + " resists torsion, which FCLIB's format does not know";
  }
  return contacts.size() == 0 ? "there are no contacts" : "";
}

/// Whether a motion of the line costs no energy but that of rounding errors.
bool is_singular(const SparseMatrix &matrix, const contact::LineFactorization &factors) {
  const Vector diagonal = matrix.diagonal();
  Vector motion(matrix.rows());
  for (int i = 0; i < motion.size(); ++i)
    motion[i] = std::sin(1. + i) / std::sqrt(diagonal[i]);
  for (unsigned int iteration = 0; iteration < 3; ++iteration) { // inverse iteration
    motion = factors.solve(diagonal.cwiseProduct(motion));
    motion /= std::sqrt(motion.cwiseProduct(diagonal).dot(motion));
  }
  const double energy = motion.dot(matrix * motion);
  const double sum = motion.cwiseAbs().dot(matrix.cwiseAbs() * motion.cwiseAbs());
  return !(energy > 1e-14 * sum);
}

/// Takes contacts into a problem, one by one.
struct ContactRows {
  GlobalContactProblem &problem;
  const unsigned int n_line; ///< unknowns of the line
  Triplets H = {};
  std::vector<double> stiffness = {}, deflection = {}; ///< of elements that are not rigid

  /// @param imposed what the degrees of freedom would be at unknowns zero
  /// @param old_state of the contact's law, before the increment
  void add(const unsigned int i, const Contact &contact, const double *const old_state,
           const LineState &after, const Vector &imposed) {
    const FrictionThreshold &law = contact.law.closed_form();
    const double l = contact.length, share = contact.share();
    const bool slips =
        old_state[law.was_slipping] != 0. || after.contact_status[i] == ContactStatus::slip;
    problem.friction[i] = slips ? law.dynamic_friction : law.static_friction;
    const double offset[dimension] = {law.gap, -l * old_state[law.slip_y],
                                      -l * old_state[law.slip_z]};
    const double rigidity[dimension] = {law.axial_rigidity, law.shear_rigidity_y,
                                        law.shear_rigidity_z};
    const Contact::Strains held = contact.strain(imposed);
    for (unsigned int c = 0; c < dimension; ++c) {
      const unsigned int column = dimension * i + c;
      problem.w[column] = l * held[c] + offset[c];
      problem.reactions[column] = -share * after.contact_stress[i][c];
      for (unsigned int j = 0; j < contact.unknowns.size(); ++j)
        if (const double b = l * contact.B(c, j); b != 0.)
          H.emplace_back(contact.unknowns[j], column, b);
      if (std::isfinite(rigidity[c])) {
        H.emplace_back(n_line + stiffness.size(), column, 1.);
        stiffness.push_back(share * rigidity[c] / l);
        deflection.push_back(problem.reactions[column] / stiffness.back());
      }
    }
  }
};

/// The line's stiffness, followed by that of elements.
SparseMatrix with_elements(const SparseMatrix &K, const std::vector<double> &stiffness) {
  const unsigned int n_line = K.rows(), n_all = n_line + stiffness.size();
  Triplets entries;
  for (int row = 0; row < K.outerSize(); ++row)
    for (SparseMatrix::InnerIterator entry(K, row); entry; ++entry)
      entries.emplace_back(row, entry.col(), entry.value());
  for (unsigned int e = 0; e < stiffness.size(); ++e)
    entries.emplace_back(n_line + e, n_line + e, stiffness[e]);
  SparseMatrix M(n_all, n_all);
  M.setFromTriplets(entries.begin(), entries.end());
  return M;
}

} // namespace

GlobalContactProblem global_contact_problem(const Model &model, const LineState &before,
                                            const LineState &after) {
  GlobalContactProblem result;
  result.obstacle = find_obstacle(model);
  if (!result.obstacle.empty())
    return result;
  const Contacts &contacts = model.contacts;
  const unsigned int n_line = model.space.n_unknowns(), n = contacts.size();
  result.w.resize(dimension * n);
  result.friction.resize(n);
  result.reactions.resize(dimension * n);
  Vector imposed;
  model.space.expand(after.unknowns, imposed);
  imposed = after.dofs - imposed;
  ContactRows rows{result, n_line};
  for (unsigned int i = 0; i < n; ++i)
    rows.add(i, contacts[i], before.contacts.internal.data() + contacts[i].state_offset, after,
             imposed);
  result.M = with_elements(model.linear.stiffness(), rows.stiffness);
  const unsigned int n_all = result.M.rows();
  result.H.resize(n_all, dimension * n);
  result.H.setFromTriplets(rows.H.begin(), rows.H.end());
  result.f = Vector::Zero(n_all);
  result.f.head(n_line) = load_forces(model, after.load_factors);
  result.solution.resize(n_all);
  result.solution << after.unknowns,
      Eigen::Map<const Vector>(rows.deflection.data(), rows.deflection.size());
  return result;
}

std::optional<contact::LocalProblem> condense(const GlobalContactProblem &problem) {
  contact::LineFactorization factors;
  factors.analyze(problem.M);
  if (!factors.factorize(problem.M) || !(factors.least_pivot() > 0.) ||
      is_singular(problem.M, factors))
    return {};
  const unsigned int m = problem.H.cols();
  Eigen::MatrixXd W(m, m);
  for (unsigned int column = 0; column < m; ++column)
    W.col(column) = problem.H.transpose() * factors.solve(problem.H.col(column));
  W = (0.5 * (W + W.transpose())).eval();
  contact::LocalProblem result;
  result.dimension = problem.dimension;
  result.W = W.sparseView();
  result.q = problem.H.transpose() * factors.solve(problem.f) + problem.w;
  result.friction = problem.friction;
  return result;
}

Vector solve_for_motion(const GlobalContactProblem &problem, const Vector &reactions) {
  contact::LineFactorization factors;
  factors.analyze(problem.M);
  factors.factorize(problem.M);
  Vector v = factors.solve(problem.H * reactions + problem.f);
  v -= factors.solve(problem.unbalanced(v, reactions));
  return v;
}

} // namespace frictionbeam
