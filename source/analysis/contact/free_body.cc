// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/contact/free_body.h"
#include "analysis/contact/unresisted_motion.h"
#include "base/algebra/dense_algebra.h"

#include "model/body/rigid_motions.h"

#include <algorithm>

namespace frictionbeam {

using namespace dealii;

template <int dim>
void FreeBody<dim>::find_motions() {
  if (motions)
    return;
  motions = rigid_motions(body);
  for (ContinuumVector &motion : *motions)
    body.constraints.set_zero(motion);
}

template <int dim>
typename FreeBody<dim>::Motions
FreeBody<dim>::motions_of(const ContinuumContactNode<dim> &node) const {
  Motions result = Motions::Zero(dim, motions->size());
  for (unsigned int m = 0; m < motions->size(); ++m)
    for (unsigned int a = 0; a < dim; ++a)
      for (unsigned int d = 0; d < dim; ++d)
        result(a, m) += node.frame[a][d] * (*motions)[m](node.dofs[d]);
  return result;
}

template <int dim>
bool FreeBody<dim>::rises_freely(const std::vector<bool> &is_pressed) {
  constexpr double nothing = 1e-12; // of sums of squares of motions of one
  find_motions();
  const unsigned int n = motions->size();
  if (n == 0)
    return false;
  Eigen::MatrixXd resisted = Eigen::MatrixXd::Zero(n, n), rising = resisted;
  for (unsigned int i = 0; i < is_pressed.size(); ++i) {
    const Motions motion = motions_of(body.nodes[i]);
    if (is_pressed[i])
      rising += motion.row(0).transpose() * motion.row(0);
    const unsigned int first = is_pressed[i] ? 1 : 0;
    resisted += motion.bottomRows(dim - first).transpose() * motion.bottomRows(dim - first);
  }
  for (Eigen::MatrixXd *const sum : {&resisted, &rising})
    for (double &entry : sum->reshaped())
      entry = Utilities::MPI::sum(entry, body.communicator);
  const double all = resisted.trace() + rising.trace();
  const SymmetricEigen pairs = symmetric_eigen(resisted);
  for (unsigned int m = 0; m < n; ++m) {
    const Eigen::VectorXd motion = pairs.vectors.col(m);
    if (pairs.values[m] <= nothing * all && motion.dot(rising * motion) > nothing * all)
      return true;
  }
  return false;
}

template <int dim>
bool FreeBody<dim>::is_free(ContinuumVector motion) const {
  constexpr double strained = 1e-10; // of the energy if every node but one stood still
  ContinuumVector stiff;
  body.reinit(stiff);
  system.multiply(motion, stiff);
  body.constraints.set_zero(stiff);
  const double stored = motion * stiff;
  for (const auto dof : body.owned)
    motion(dof) *= std::sqrt(system.diagonal(dof));
  return stored <= strained * (motion * motion);
}

template <int dim>
std::optional<bool>
FreeBody<dim>::is_pushed_away(const ContinuumVector &loads,
                              const std::vector<std::optional<double>> &friction) {
  constexpr double rounding = 1e-9, nothing = 1e-9; // of sums, of a motion of one
  find_motions();
  const unsigned int n = motions->size();
  std::vector<MovedContact> moved(friction.size());
  double pressed = 0.;
  bool known = true;
  for (unsigned int i = 0; i < friction.size(); ++i) {
    known = known && friction[i];
    moved[i].friction = friction[i].value_or(0.);
    moved[i].motion.setZero(3, n);
    moved[i].motion.template topRows<dim>() = motions_of(body.nodes[i]);
    pressed = std::max(pressed, moved[i].motion.row(0).template lpNorm<Eigen::Infinity>());
  }
  if (Utilities::MPI::min(static_cast<unsigned int>(known), body.communicator) == 0 || n == 0 ||
      Utilities::MPI::max(pressed, body.communicator) <= nothing)
    return {};
  Eigen::VectorXd works(n), sizes(n);
  for (unsigned int m = 0; m < n; ++m) {
    works[m] = loads * (*motions)[m];
    ContinuumVector parts = loads;
    parts.scale((*motions)[m]);
    sizes[m] = parts.l1_norm();
  }
  const auto found = unresisted_motion(works, moved, body.communicator);
  if (!found || works.dot(*found) <= rounding * sizes.dot(found->cwiseAbs()))
    return false;
  ContinuumVector motion;
  body.reinit(motion);
  for (unsigned int m = 0; m < n; ++m)
    motion.add((*found)[m], (*motions)[m]);
  return is_free(motion);
}

template class FreeBody<2>;
template class FreeBody<3>;

} // namespace frictionbeam
