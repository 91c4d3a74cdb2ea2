// SPDX-License-Identifier: LGPL-2.1-or-later
// Cells answer for themselves, so that analyses take any: the methods for cells that move far,
// given linear ones (straight, arcs, joints), solve statics and motion as the linear methods do,
// which never ask a cell.
#include "../check.h"
#include "line_from.h"

#include "analysis/statics/linear_statics.h"
#include "analysis/statics/nonlinear_statics.h"
#include "analysis/time/moreau_jean.h"
#include "analysis/time/nonlinear_motion.h"

using namespace frictionbeam;

namespace {

const char *const scene = R"(
subsection Material steel
  set Density = 7850
end
subsection Material light
  set Density = 0
end
subsection Section DN100
  set Outer diameter = 0.1143
  set Wall = 0.006
end
subsection Pipe line
  set Section = DN100
  set Material = steel
  set Route = A 0 0 0; B 2 0 0; corner 4 0 0 bend 0.5; C 4 3 0
end
subsection Section tail
  set Outer diameter = 0.1143
  set Wall = 0.006
  set Law = global_plastic
  set Yield stress = 1e15
end
subsection Pipe tail
  set Section = tail
  set Material = light
  set Route = E 0 9 0; F 1 9 0
end
subsection Joint hinge
  set Pipe = line
  set At = B
  set Bending = 1e5
end
subsection Support clamp
  set Kind = anchor
  set At = A, E, F
end
subsection Support shoe
  set Kind = rest
  set At = B
  set Friction coefficient = 0.3
end
subsection Spring hung
  set At = C
  set Stiffness = 1e3 0 1e5
  set Damping = 50 0 20
end
subsection Load weight
end
subsection Load heat
  set Kind = temperature
  set Pipes = line
  set Temperature = 100
end
subsection Load move
  set Kind = displacement
  set Displacements = A ux 0.01
  set History = t^2
end
subsection Step go
  set Loads = weight, heat, move
  set Analysis = transient
  set Duration = 1
end
subsection Time
  set Step = 1e-2
  set Mass damping = 0.7
  set Stiffness damping = 1e-3
end
)";

LineState at_rest(const Model &model) {
  LineState state;
  state.unknowns = state.velocity = state.acceleration = state.auxiliary =
      Vector::Zero(model.space.n_unknowns());
  state.dofs = Vector::Zero(model.space.n_dofs());
  state.contacts = model.contacts.initial_state(state.dofs);
  state.contact_stress.assign(model.contacts.size(), Contact::Strains::Zero());
  state.contact_status.assign(model.contacts.size(), ContactStatus::open);
  state.load_factors.assign(model.scene.loads.size(), 0.);
  state.sections = model.cells.pipe_sections().at_rest();
  return state;
}

double apart(const Vector &one, const Vector &two) {
  return (one - two).lpNorm<Eigen::Infinity>() / two.lpNorm<Eigen::Infinity>();
}

void check_equal(const EnergyAccount &one, const EnergyAccount &two) {
  const double size = two.turnover;
  CHECK_NEAR(one.external / size, two.external / size, 1e-8);
  CHECK_NEAR(one.stored / size, two.stored / size, 1e-8);
  CHECK_NEAR(one.kinetic / size, two.kinetic / size, 1e-8);
  CHECK_NEAR(one.damping / size, two.damping / size, 1e-8);
  CHECK_NEAR(one.left_over() / size, 0., 1e-8);
}

} // namespace

int line_cells(int, char **) {
  const LineFrom line(scene);
  const Model &model = line.model;
  CHECK(!model.cells.is_linear()); // its tail has a law, so that there are places for tangents
  const std::vector<double> none(3, 0.), all(3, 1.);
  LoadCourse course(model);
  course.begin_step(0, none, all, 0., 0.);

  LinearStatics linear(model);
  NonlinearStatics nonlinear(model);
  const LineState rest = at_rest(model);
  LineState by_linear = rest, by_nonlinear = rest;
  ContactResponse response;
  const std::vector<double> factors = course.factors(0.5);
  const StaticIncrement increment{course, 0.5, factors, 0., 0., 1000};
  CHECK(linear.solve(rest, increment, by_linear, response).converged);
  const EquilibriumResult result = nonlinear.solve(rest, increment, by_nonlinear, response);
  CHECK(result.converged && result.iterations <= 2);
  CHECK_NEAR(apart(by_nonlinear.dofs, by_linear.dofs), 0., 1e-9);

  MoreauJean moreau_jean(model);
  NonlinearMotion motion(model);
  LineState one = rest, two = rest, next;
  for (LineState *const state : {&one, &two}) {
    state->load_factors = course.factors_after(0.);
    course.set_rates(*state, LoadCourse::Side::after);
  }
  moreau_jean.start(one, course);
  motion.start(two, course);
  EnergyAccount of_one, of_two;
  for (int i = 1; i <= 20; ++i) {
    const TimeStep step = moreau_jean.advance(one, course, 0.01 * i, next);
    CHECK(step.result.converged);
    of_one += step.energy;
    one = next;
    const TimeStep other = motion.advance(two, course, 0.01 * i, next);
    CHECK(other.result.converged);
    of_two += other.energy;
    two = next;
  }
  CHECK_NEAR(apart(two.dofs, one.dofs), 0., 1e-8);
  CHECK_NEAR(apart(two.velocity, one.velocity), 0., 1e-7);
  check_equal(of_two, of_one);
  return check::report();
}
