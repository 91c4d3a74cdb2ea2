// SPDX-License-Identifier: LGPL-2.1-or-later
// Where the work goes: a mass on a rough floor, held by a spring k, is pulled by F. It slips when
// F > mu N, to u = (F - mu N)/k; work F u/2 + mu N u/2 (the load grows evenly), stored k u^2/2,
// dissipated mu N u. In four increments as in one, for every term is a trapezoid.
#include "../check.h"
#include "line_from.h"

#include "analysis/sequence/load_sequence.h"

using namespace frictionbeam;

namespace {

std::string scene(const unsigned int n_increments) {
  return R"(
subsection Point P
end
subsection Spring k
  set At = P
  set Stiffness = 1000 0 1000
end
subsection Support floor
  set Kind = rest
  set At = P
  set Friction coefficient = 0.5
end
subsection Load down
  set Kind = force
  set Forces = P 0 0 -20
end
subsection Load pull
  set Kind = force
  set Forces = P 15 0 0
end
subsection Step down
  set Loads = down
end
subsection Step pull
  set Loads = down, pull
  set Increments = )" +
         std::to_string(n_increments) + "\nend\n";
}

} // namespace

int energy_account(int, char **) {
  const double F = 15., friction = 0.5 * 20., k = 1000., u = (F - friction) / k;
  for (const unsigned int n : {3u, 12u}) { // slip begins at the end of an increment, at 2/3
    const LineFrom line(scene(n));
    LoadSequence sequence(line.model);
    CHECK(sequence.run([](const Progress &, const LineState &) {}));
    const EnergyAccount energy = sequence.reports()[1].energy;
    CHECK_NEAR(energy.external, (F + friction) / 2. * u, 1e-10);
    CHECK_NEAR(energy.stored, k * u * u / 2., 1e-10);
    CHECK_NEAR(energy.dissipated, friction * u, 1e-10);
    CHECK_NEAR(energy.left_over() / energy.turnover, 0., 1e-12);
    CHECK_NEAR(energy.missed_friction / energy.turnover, 0., 1e-10);
  }
  // In one increment the friction force grows with the slip: half of what slip costs is missed, and
  // said.
  const LineFrom line(scene(1));
  LoadSequence sequence(line.model);
  CHECK(sequence.run([](const Progress &, const LineState &) {}));
  const EnergyAccount energy = sequence.reports()[1].energy;
  CHECK_NEAR(energy.left_over() / energy.turnover, 0., 1e-12);
  CHECK_NEAR(energy.missed_friction, friction * u / 2., 1e-10);
  return check::report();
}
