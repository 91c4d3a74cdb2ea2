// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/contact/exact_method.h"

#include "base/interruption.h"

namespace frictionbeam {

namespace {

contact::Settings settings_of(const SolverSettings &settings) {
  return {settings.tolerance, settings.contact_tolerance, &interruption::end_if_overdue};
}

/// All unknowns of the nodes that contacts touch.
std::vector<int> unknowns_of(const Contacts &contacts) {
  std::vector<int> kept;
  for (unsigned int i = 0; i < contacts.size(); ++i) {
    kept.insert(kept.end(), contacts[i].unknowns.begin(), contacts[i].unknowns.end());
    kept.insert(kept.end(), contacts[i].vertex_unknowns.begin(), contacts[i].vertex_unknowns.end());
  }
  return kept;
}

} // namespace

ExactMethod::ExactMethod(const SolverSettings &settings, const Contacts &contacts,
                         const SparseMatrix &stiffness, contact::PartMemory *const memory)
    : contacts(contacts), solver(settings_of(settings), contacts,
                                 contact::condense_parts(stiffness, unknowns_of(contacts), memory),
                                 stiffness.diagonal()) {}

EquilibriumResult ExactMethod::solve(const EquilibriumProblem &problem,
                                     const ContactState &committed, Vector &unknowns,
                                     ContactResponse &response) {
  contact::ImposedMotion imposed;
  if (problem.imposed.size() > 0) {
    for (unsigned int i = 0; i < contacts.size(); ++i)
      imposed.strain.push_back(contacts[i].strain(problem.imposed));
    imposed.displacement = problem.imposed.lpNorm<Eigen::Infinity>();
  }
  return solver.solve(problem, imposed, committed, unknowns, response);
}

void ExactMethod::transfer(Archive &archive) {
  contact::WarmStart memory = solver.warm_start();
  contact::PredictionMemory &prediction = memory.prediction;
  archive(memory.first_factor, memory.stiffness_factor, memory.centre, memory.friction,
          memory.friction_scale, memory.gap, memory.factored, prediction.status, prediction.motion,
          prediction.failures, prediction.pause);
  if (archive.reads())
    solver.restore(memory);
}

} // namespace frictionbeam
