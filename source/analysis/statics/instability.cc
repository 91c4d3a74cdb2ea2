// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/statics/nonlinear_statics.h"

#include "analysis/contact/opposed_contacts.h"

#include <frictionbeam/contact/line_factorization.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace frictionbeam {

using namespace dealii;

namespace {
/// Not those that follow a vertex that may turn, nor moments that keep their axis where both other
/// axes are free: no signs of the stiffness tell then whether a pose is stable.
bool loads_have_potential(const Model &model, const std::vector<double> &factors) {
  const auto free_axes = [&](const unsigned int vertex) {
    std::array<bool, 3> free{};
    for (unsigned int d = 0; d < 3; ++d)
      if (const auto dof = model.discretization.vertex_dofs().index(vertex, 3 + d);
          dof != numbers::invalid_dof_index) {
        const ReducedSpace::Terms terms = model.space.terms(dof);
        free[d] = terms.first != terms.last;
      }
    return free;
  };
  for (unsigned int l = 0; l < factors.size(); ++l) {
    if (factors[l] == 0.)
      continue;
    for (const auto &[vertex, load] : model.linear.nodal(l)) {
      const std::array<bool, 3> free = free_axes(vertex);
      if (model.scene.loads[l].follows && (free[0] || free[1] || free[2]))
        return false;
      for (unsigned int d = 0; d < 3; ++d)
        if (load[3 + d] != 0. && free[(d + 1) % 3] && free[(d + 2) % 3])
          return false;
    }
  }
  return true;
}

/// What closed contacts hold by their stiffness, those that are rigid as much more than the line.
void add_contacts(const Model &model, const LineState &state, const std::vector<bool> &idle,
                  const double rigid_stiffness, std::vector<Eigen::Triplet<double>> &entries) {
  for (unsigned int i = 0; i < model.contacts.size(); ++i) {
    const Contact &contact = model.contacts[i];
    if (state.contact_status[i] == ContactStatus::open || idle[i])
      continue;
    const bool is_known = contact.law.has_closed_form();
    const FrictionThreshold &law = contact.law.closed_form();
    const bool rubs = !is_known || law.static_friction > 0.; // else it holds along its normal alone
    const double rigid = rigid_stiffness * contact.length * contact.length;
    const auto stiffness = [&](const double rigidity) {
      return is_known && std::isfinite(rigidity) ? std::min(rigid, rigidity * contact.weight)
                                                 : rigid;
    };
    const Eigen::Vector3d hold(stiffness(law.axial_rigidity),
                               rubs ? stiffness(law.shear_rigidity_y) : 0.,
                               rubs ? stiffness(law.shear_rigidity_z) : 0.);
    const Eigen::MatrixXd B = contact.B.topRows(3), block = B.transpose() * hold.asDiagonal() * B;
    for (unsigned int a = 0; a < contact.unknowns.size(); ++a)
      for (unsigned int b = 0; b < contact.unknowns.size(); ++b)
        entries.emplace_back(contact.unknowns[a], contact.unknowns[b], block(a, b));
  }
}

/// Cells that are bent and twisted are symmetric but for squares of their deformations: a part of
/// as much may be missing of the symmetric part, and a pose that is neutral is not unstable.
void add_missing(const SparseMatrix &antisymmetric, std::vector<Eigen::Triplet<double>> &entries) {
  constexpr double part = 0.1; // Michell's ring of 32 cells is seen 4 % late, without this 3 %
  for (int i = 0; i < antisymmetric.outerSize(); ++i) {
    double sum = 0.;
    for (SparseMatrix::InnerIterator entry(antisymmetric, i); entry; ++entry)
      sum += std::abs(entry.value());
    entries.emplace_back(i, i, part * sum);
  }
}

} // namespace

bool NonlinearStatics::is_unstable(const LineState &state) const {
  constexpr double same = 1e-9, stiff = 1e3, rounding_of_pivots = 1e-12; // parts of the stiffest
  constexpr double no_force = 1e-9;                                      // of the largest
  if (!model.cells.turns_far() || state.unknowns.size() == 0 ||
      !loads_have_potential(model, state.load_factors))
    return false;
  LineCells::Balance balance;
  model.cells.evaluate(pose_of(state), state.load_factors, balance);
  const SparseMatrix symmetric = symmetric_part(balance.stiffness),
                     antisymmetric = balance.stiffness - symmetric;
  const double largest = symmetric.diagonal().cwiseAbs().maxCoeff();
  if (model.cells.pipe_sections().any() && antisymmetric.norm() > same * symmetric.norm())
    return false; // by a law whose tangent is not
  std::vector<Eigen::Triplet<double>> entries;
  add_contacts(model, state,
               contacts_that_do_not_hold(model.contacts, state, no_force * balance.largest),
               stiff * largest, entries);
  add_missing(antisymmetric, entries);
  SparseMatrix held(symmetric.rows(), symmetric.cols());
  held.setFromTriplets(entries.begin(), entries.end());
  const SparseMatrix tangent = symmetric + held;
  contact::LineFactorization factors;
  factors.analyze(tangent);
  return factors.factorize(tangent) && factors.least_pivot() < -rounding_of_pivots * largest;
}

} // namespace frictionbeam
