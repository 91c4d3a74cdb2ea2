// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/contact/exact_method.h"

#include "base/interruption.h"

namespace frictionbeam {

contact::Settings ExactMethod::settings_of(const SolverSettings &settings) {
  return {settings.tolerance, settings.contact_tolerance, &interruption::end_if_overdue};
}

std::vector<int> ExactMethod::kept_unknowns(const Contacts &contacts) {
  std::vector<int> kept;
  for (unsigned int i = 0; i < contacts.size(); ++i) {
    kept.insert(kept.end(), contacts[i].unknowns.begin(), contacts[i].unknowns.end());
    kept.insert(kept.end(), contacts[i].vertex_unknowns.begin(), contacts[i].vertex_unknowns.end());
  }
  return kept;
}

contact::ImposedMotion ExactMethod::imposed_motion(const Contacts &contacts,
                                                   const Vector &imposed) {
  contact::ImposedMotion motion;
  if (imposed.isZero(0.))
    return motion;
  for (unsigned int i = 0; i < contacts.size(); ++i)
    motion.strain.push_back(contacts[i].strain(imposed));
  motion.displacement = imposed.lpNorm<Eigen::Infinity>();
  return motion;
}

ExactMethod::ExactMethod(const SolverSettings &settings, const Contacts &contacts,
                         const SparseMatrix &stiffness, contact::PartMemory *const memory)
    : contacts(contacts),
      solver(settings_of(settings), contacts,
             contact::condense_parts(stiffness, kept_unknowns(contacts), memory),
             stiffness.diagonal()) {}

EquilibriumResult ExactMethod::solve(const EquilibriumProblem &problem,
                                     const ContactState &committed, Vector &unknowns,
                                     ContactResponse &response) {
  return solver.solve(problem, imposed_motion(contacts, problem.imposed), committed, unknowns,
                      response);
}

void transfer(Archive &archive, contact::WarmStart &memory) {
  contact::PredictionMemory &prediction = memory.prediction;
  archive(memory.first_factor, memory.stiffness_factor, memory.centre, memory.friction,
          memory.friction_scale, memory.gap, memory.factored, prediction.status, prediction.motion,
          prediction.failures, prediction.pause, prediction.further);
}

void ExactMethod::transfer(Archive &archive) {
  contact::WarmStart memory = solver.warm_start();
  frictionbeam::transfer(archive, memory);
  if (archive.reads())
    solver.restore(memory);
}

} // namespace frictionbeam
