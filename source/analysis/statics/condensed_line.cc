// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/statics/condensed_line.h"

#include "analysis/contact/exact_method.h"

#include <algorithm>

namespace frictionbeam {

CondensedLine::CondensedLine(const Model &model)
    : model(model), K(model.linear.stiffness()), diagonal(K.diagonal()),
      line(contact::condense_parts(K, ExactMethod::kept_unknowns(model.contacts))),
      S(line->matrix()), values(S.nonZeros()) {
  for (int u = 0; u < line->n_unknowns(); ++u)
    if (line->place(u) >= 0)
      kept.push_back(u);
  condense_stiffness();
  condense_loads();
  for (unsigned int i = 0; i < model.contacts.size(); ++i) {
    contact::Site &site = sites.emplace_back(model.contacts[i]);
    for (int &unknown : site.unknowns)
      unknown = line->place(unknown);
  }
  std::vector<int> all(kept.size());
  for (unsigned int k = 0; k < all.size(); ++k)
    all[k] = k;
  solver = std::make_unique<contact::ExactSolver>(
      ExactMethod::settings_of(model.scene.solver), contact::SiteList(sites),
      contact::condense_parts(S, all), kept_of(diagonal));
  fresh = solver->warm_start();
}

void CondensedLine::begin() {
  for (unsigned int i = 0; i < sites.size(); ++i)
    sites[i].law = model.contacts[i].law;
  solver->restore(fresh);
}

Vector CondensedLine::kept_of(const Vector &unknowns) const {
  Vector result(kept.size());
  for (unsigned int k = 0; k < kept.size(); ++k)
    result[k] = unknowns[kept[k]];
  return result;
}

Vector CondensedLine::expand(const Vector &kept_motions, const Vector &on_unknowns,
                             Vector &low) const {
  constexpr unsigned int n_refinements = 2;
  const Vector none = Vector::Zero(kept.size());
  const Vector motion = line->expand(kept_motions, on_unknowns);
  low = Vector::Zero(motion.size());
  for (unsigned int k = 0; k < n_refinements; ++k)
    low += line->expand(none, contact::unbalanced_forces({K, on_unknowns}, motion, low));
  return motion;
}

std::vector<std::vector<int>> CondensedLine::find_groups() const {
  std::vector<std::vector<int>> groups;
  std::vector<int> group_of(kept.size(), -1);
  std::vector<int> taken_by; // of each group, the unknown that cannot be in it
  for (int j = 0; j < S.rows(); ++j) {
    for (SparseMatrix::InnerIterator row(S, j); row; ++row)
      for (SparseMatrix::InnerIterator other(S, row.col()); other; ++other)
        if (const int group = group_of[other.col()]; group >= 0)
          taken_by[group] = j;
    const auto free = std::find_if(taken_by.begin(), taken_by.end(),
                                   [&](const int unknown) { return unknown != j; });
    group_of[j] = free - taken_by.begin();
    if (free == taken_by.end()) {
      taken_by.push_back(-1);
      groups.emplace_back();
    }
    groups[group_of[j]].push_back(j);
  }
  return groups;
}

void CondensedLine::condense_stiffness() {
  const Vector no_forces = Vector::Zero(K.rows());
  std::vector<bool> is_in_group(kept.size(), false);
  for (const std::vector<int> &group : find_groups()) {
    Vector unit = Vector::Zero(kept.size()), low;
    for (const int j : group) {
      unit[j] = 1.;
      is_in_group[j] = true;
    }
    const Vector motion = expand(unit, no_forces, low);
    for (int row = 0; row < S.rows(); ++row) {
      int p = S.outerIndexPtr()[row];
      const int end = S.outerIndexPtr()[row + 1];
      while (p < end && !is_in_group[S.innerIndexPtr()[p]])
        ++p;
      if (p == end)
        continue;
      for (SparseMatrix::InnerIterator entry(K, kept[row]); entry; ++entry)
        values[p] +=
            entry.value() * (static_cast<long double>(motion[entry.col()]) + low[entry.col()]);
    }
    for (const int j : group)
      is_in_group[j] = false;
  }
  for (int row = 0; row < S.rows(); ++row) {
    first_used.push_back(used.size());
    for (int p = S.outerIndexPtr()[row]; p < S.outerIndexPtr()[row + 1]; ++p)
      if (S.valuePtr()[p] != 0.) { // else directions that have nothing to do with each other
        used.push_back(p);
        S.valuePtr()[p] = static_cast<double>(values[p]);
      }
  }
  first_used.push_back(used.size());
}

void CondensedLine::condense_loads() {
  const Vector none = Vector::Zero(kept.size());
  const auto add = [&](const Vector &on_unknowns) {
    Vector low;
    const Vector motion = expand(none, on_unknowns, low);
    forces.push_back(kept_of(contact::unbalanced_forces({K, on_unknowns}, motion, low)));
    motions.push_back(motion + low);
  };
  add(model.contacts.platen_forces());
  for (unsigned int load = 0; load < model.scene.loads.size(); ++load)
    add(model.linear.forces(load));
}

namespace {

/// The first of them, and the others times factors.
Vector sum_of(const std::vector<Vector> &parts, const std::vector<double> &factors) {
  Vector result = parts[0];
  for (unsigned int load = 0; load < factors.size(); ++load)
    if (factors[load] != 0.)
      result += factors[load] * parts[load + 1];
  return result;
}

} // namespace

EquilibriumResult CondensedLine::solve(const LineState &from, const StaticIncrement &increment,
                                       LineState &to, ContactResponse &response) {
  contact::Problem problem{S, sum_of(forces, increment.factors)};
  increment.describe(model, problem);
  problem.unbalanced = [&](const Vector &unknowns, const Vector &low) {
    Vector left(unknowns.size());
    for (int row = 0; row < S.rows(); ++row) {
      long double sum = problem.right_hand_side[row];
      for (int k = first_used[row]; k < first_used[row + 1]; ++k) {
        const int p = used[k], column = S.innerIndexPtr()[p];
        sum -= values[p] * (static_cast<long double>(unknowns[column]) + low[column]);
      }
      left[row] = static_cast<double>(sum);
    }
    return left;
  };
  const Vector imposed = increment.course.imposed(increment.time);
  Vector unknowns = kept_of(from.unknowns);
  const EquilibriumResult result =
      solver->solve(problem, ExactMethod::imposed_motion(model.contacts, imposed), from.contacts,
                    unknowns, response);
  for (unsigned int k = 0; k < kept.size(); ++k)
    to.unknowns[kept[k]] = unknowns[k];
  to.dofs = imposed;
  return result;
}

bool CondensedLine::complete(LineState &state) const {
  const Vector imposed = state.dofs;
  state.unknowns = line->expand(kept_of(state.unknowns), Vector::Zero(K.rows())) +
                   sum_of(motions, state.load_factors);
  model.space.expand(state.unknowns, state.dofs);
  state.dofs += imposed;
  const contact::Problem problem{K, LoadCourse(model).forces(state.load_factors)};
  const contact::Balance balance(problem, model.contacts);
  ContactResponse response;
  response.stress = state.contact_stress;
  const Vector left = balance.left(state.unknowns, Vector::Zero(K.rows()), response);
  return left.lpNorm<Eigen::Infinity>() <=
         balance.tolerance(model.scene.solver.tolerance, diagonal, state.unknowns, response);
}

void CondensedLine::transfer(Archive &archive) {
  contact::WarmStart memory = solver->warm_start();
  frictionbeam::transfer(archive, memory);
  if (archive.reads())
    solver->restore(memory);
}

} // namespace frictionbeam
