// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/sequence/load_sequence.h"

#include "analysis/increment/contact_watch.h"
#include "analysis/increment/time_step.h"
#include "analysis/march/integrator_library.h"
#include "analysis/time/moreau_jean.h"
#include "base/algebra/dense_algebra.h"
#include "base/user_error.h"
#include "scene/in_units.h"

#include <algorithm>
#include <map>
#include <set>

namespace frictionbeam {

using namespace dealii;

namespace {

/// Set the unknowns of a vertex to the motion that is nearest to @p motion of those that nothing
/// there holds.
void set_motion(const Motion &motion, const unsigned int vertex, const VertexDofs &dofs,
                const ReducedSpace &space, Vector &unknowns) {
  std::vector<int> columns; // unknowns
  Eigen::Matrix<double, 6, 6> motions = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 1> wanted;
  for (unsigned int c = 0; c < 6; ++c) {
    wanted[c] = motion[c];
    if (const auto dof = dofs.index(vertex, c); dof != numbers::invalid_dof_index)
      for (const auto &term : space.terms(dof)) {
        const auto found = std::find(columns.begin(), columns.end(), term.unknown);
        const auto column = found - columns.begin();
        if (found == columns.end())
          columns.push_back(term.unknown);
        motions(c, column) = term.weight;
      }
  }
  if (columns.empty())
    return;
  const Vector nearest = LeastSquares(motions.leftCols(columns.size())).solve(wanted);
  for (unsigned int i = 0; i < columns.size(); ++i)
    unknowns[columns[i]] = nearest[i];
}

} // namespace

void LoadSequence::set_initial_motion(const bool displaced) {
  const auto set = [&](Motion InitialCondition::*const part, Vector &unknowns) {
    std::map<unsigned int, Motion> motions; // by vertex; those of several sections add up
    for (const InitialCondition &initial : model.scene.initial) {
      std::set<unsigned int> vertices;
      for (const std::string &point : initial.points)
        vertices.insert(model.mesh.points.at(point));
      for (unsigned int p = 0; p < model.mesh.pipes.size(); ++p)
        if (std::count(initial.pipes.begin(), initial.pipes.end(), model.scene.pipes[p].name) > 0)
          vertices.insert(model.mesh.pipes[p].vertices.begin(), model.mesh.pipes[p].vertices.end());
      const Motion &given = initial.*part;
      for (const unsigned int vertex : vertices) {
        Motion &sum = motions.try_emplace(vertex, Motion{}).first->second;
        for (unsigned int c = 0; c < 6; ++c)
          sum[c] += given[c];
        if (initial.about.empty())
          continue;
        const Vector3 arm =
            model.mesh.vertices[vertex] - model.mesh.vertices[model.mesh.points.at(initial.about)];
        const Vector3 turned = cross_product_3d(Vector3({given[3], given[4], given[5]}), arm);
        for (unsigned int d = 0; d < 3; ++d)
          sum[d] += turned[d];
      }
    }
    for (const auto &[vertex, motion] : motions)
      set_motion(motion, vertex, model.discretization.vertex_dofs(), model.space, unknowns);
  };
  if (displaced)
    set(&InitialCondition::displacement, current.unknowns);
  const auto &steps = model.scene.steps;
  if (!displaced || (!steps.empty() && steps.front().transient))
    set(&InitialCondition::velocity, current.velocity);
}

void LoadSequence::check_initial_gaps() const {
  constexpr double rounding = 1e-9; // of the displacements
  const double least = rounding * current.dofs.lpNorm<Eigen::Infinity>();
  for (unsigned int i = 0; i < model.contacts.size(); ++i) {
    const Contact &contact = model.contacts[i];
    const FrictionSupport &support = model.scene.supports[contact.support];
    // as the support is given: return mapping makes a rigid one elastic
    const BoundLaw law(contact.law.description(), support.parameters);
    if (!law.is_rigid_along_normal() || !law.has_closed_form() || contact.platen_force != 0.)
      continue;
    const double opens = contact.length * contact.strain_by_unknowns(current.unknowns)[0],
                 gap = contact.length * current.contacts.strain[i][0] + law.closed_form().gap;
    if (opens < -least && gap < -least)
      throw UserError("Support " + support.name + ": the displacements of Initial put " +
                      in_units(model.scene.units, model.mesh.vertices[contact.vertices[0]]) + " " +
                      in_units(model.scene.units, -gap, "m") +
                      " into it, and nothing gets into a rigid support. Try another displacement, "
                      "a larger Gap, or give the support an Axial rigidity.");
  }
}

void LoadSequence::press_at_start() {
  constexpr double instant = 1e-3, touches = 1e-12; // of a time step; of the contact's length
  if (model.scene.steps.empty())
    return;
  const LoadStep &first = model.scene.steps.front();
  const Integrator by = model.scene.time.integrator;
  const bool by_impulses = model.scene.solver.is_exact() ||
                           (by != Integrator::newmark && by != Integrator::generalized_alpha);
  if (!first.transient || !by_impulses)
    return;
  course.begin_step(0, declared, target_of(first), 0., first.ramp);
  LineState before = current, after;
  before.load_factors = course.factors_after(0.);
  course.set_rates(before, LoadCourse::Side::after);
  std::vector<unsigned int> touching;
  for (unsigned int i = 0; i < model.contacts.size(); ++i) {
    const Contact &contact = model.contacts[i];
    if (!is_rigid_stop(model, contact))
      continue;
    if (contact.length * before.contacts.strain[i][0] + contact.law.closed_form().gap >
        touches * contact.length)
      continue;
    if (contact.strain_by_unknowns(before.velocity)[0] < 0.)
      return; // an impact, whose force is no number
    touching.push_back(i);
  }
  if (touching.empty())
    return;
  std::unique_ptr<TimeIntegrator> integrator;
  if (by == Integrator::event)
    integrator = std::make_unique<MoreauJean>(model);
  else
    integrator = make_time_integrator(model, {});
  integrator->start(before, course);
  if (!integrator->advance(before, course, instant * time_step(model), after).result.converged)
    return;
  for (const unsigned int i : touching) {
    const FrictionThreshold law = model.contacts[i].law.closed_form();
    const auto elastic_shear = current.contact_stress[i].tail<3>().eval(); // as is: it takes time
    current.contact_stress[i] = after.contact_stress[i];
    current.contact_status[i] = after.contact_status[i];
    if (std::isfinite(law.shear_rigidity_y) && law.static_friction > 0.) {
      current.contact_stress[i].tail<3>() = elastic_shear;
      if (current.contact_status[i] == ContactStatus::slip && law.dynamic_friction > 0.)
        current.contact_status[i] = ContactStatus::stick;
    }
    if (after.contact_status[i] != before.contact_status[i])
      current.events.push_back({0., i, after.contact_status[i]});
  }
}

} // namespace frictionbeam
