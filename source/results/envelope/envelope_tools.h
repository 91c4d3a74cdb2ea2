// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/frame/frame_builder.h"
#include "results/frame/section_forces.h"
#include "results/stress/stress_evaluation.h"
#include "results/stress/stresses.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace frictionbeam {

/// What makes numbers of states, for Envelope.
struct EnvelopeTools {
  EnvelopeTools(const Model &model, const Results &results)
      : builder(model, true), line(builder.stations()),
        nozzles(nozzle_sites(model.scene, results)) {
    if (model.cells.is_linear())
      section_forces.emplace(model);
    for (unsigned int i = 0; i < model.contacts.size(); ++i) // whose force can be an impulse
      rigid.push_back(model.contacts[i].law.is_rigid_along_normal() &&
                      model.contacts[i].platen_force == 0.);
    for (unsigned int p = 0; p < model.mesh.pipes.size(); ++p)
      for (unsigned int i = 0; i < model.mesh.pipes[p].vertices.size(); ++i)
        nodes.push_back(
            {{p, model.mesh.pipes[p].s[i]}, dofs_at(model, model.mesh.pipes[p].vertices[i])});
    for (const auto &[name, vertex] : model.mesh.points)
      points.push_back(dofs_at(model, vertex));
  }

  using Dofs = std::array<dealii::types::global_dof_index, 6>;
  static Dofs dofs_at(const Model &model, const unsigned int vertex) {
    Dofs result;
    for (unsigned int c = 0; c < 6; ++c)
      result[c] = model.discretization.vertex_dofs().index(vertex, c);
    return result;
  }
  /// 0 where there is no unknown.
  static double value_at(const LineState &state, const dealii::types::global_dof_index dof) {
    return dof == dealii::numbers::invalid_dof_index ? 0. : state.dofs[dof];
  }

  FrameBuilder builder;
  std::vector<Station> line;                                  ///< at rest
  std::vector<std::pair<unsigned int, unsigned int>> nozzles; ///< and the restraints they are at
  std::optional<SectionForces> section_forces;                ///< of linear kinematics
  std::vector<SectionForces::Bounds> known; ///< what all stations of a cell have met in the step
  std::vector<bool> rigid;                  ///< contacts that can strike
  std::vector<std::pair<StationPlace, Dofs>> nodes; ///< of the pipes
  std::vector<Dofs> points;                         ///< beside Results::points
  bool is_part = false;  ///< whether a combination has the step at hand among its cases
  Eigen::VectorXd kinds; ///< of numbers_at(), of the step at hand
};

/// The formulas of the stress code in a step, by station.
struct EnvelopeStresses {
  struct Case {
    std::vector<StressCode::Formula> formulas;
    std::vector<StressEvaluation::Axes> axes;
    std::vector<Motion> before; ///< section forces that a range counts from

    /// Of a station by its section forces [Pa].
    double operator()(const unsigned int station, const double *const forces) const {
      Motion section;
      for (unsigned int c = 0; c < 6; ++c)
        section[c] = forces[c] - before[station][c];
      return formulas[station](axes[station].forces(section.data()));
    }
    /// What it comes to at most with forces up to these sizes: formulas are convex, so at a corner,
    /// and no force but that along the pipe has a sign there.
    template <typename Reach>
    double bound(const unsigned int station, const Reach &reach) const {
      Motion section;
      for (unsigned int c = 0; c < 6; ++c)
        section[c] = reach(c) + std::abs(before[station][c]);
      StressForces forces = axes[station].forces(section.data());
      forces.in_plane = forces.out_of_plane = std::hypot(section[4], section[5]);
      const double in_tension = formulas[station](forces);
      forces.axial = -forces.axial;
      return std::max(in_tension, formulas[station](forces));
    }
  };
  std::vector<Case> cases; ///< beside StepEnvelope::stresses
};

} // namespace frictionbeam
