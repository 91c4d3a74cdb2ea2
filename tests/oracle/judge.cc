// SPDX-License-Identifier: LGPL-2.1-or-later
#include "judge.h"
#include "compare.h"
#include "write_scene.h"

#include <algorithm>

namespace oracle {

namespace {

/// There the program takes the wind across chords of 0.03 rad.
bool wind_on_bends(const Scene &scene) {
  bool wind = false, bends = false;
  for (const Load &load : scene.loads)
    wind = wind || load.kind == "wind";
  for (const Pipe &pipe : scene.pipes)
    for (const Corner &corner : pipe.route)
      bends = bends || corner.bend > 0.;
  return wind && bends && scene.arcs;
}

/// The program's forces of contacts at the ends of its increments.
Starts forces_of(const Outcome &program, const Solution &solution) {
  const frictionbeam::Results &results = program.results;
  Starts starts;
  for (const frictionbeam::Frame &frame : results.frames) {
    if (frame.increment == 0 || frame.step >= solution.steps.size())
      continue;
    std::vector<Vec3> &forces = starts[frame.time];
    forces.clear();
    for (const Contact &contact : solution.steps[frame.step].contacts) {
      Vec force = Vec::Zero();
      for (std::size_t i = 0; i < results.supports.size(); ++i)
        for (int d = 0; d < 3 && results.supports[i].name == contact.name; ++d)
          force[d] = frame.supports[i].fn * results.supports[i].normal[d] +
                     frame.supports[i].ft1 * results.supports[i].t1[d] +
                     frame.supports[i].ft2 * results.supports[i].t2[d];
      forces.emplace_back(force.dot(contact.normal), force.dot(contact.t1), force.dot(contact.t2));
    }
  }
  return starts;
}

} // namespace

Scene OracleJudge::make(const std::uint64_t seed) const { return random_scene(seed, kinds); }

Verdict OracleJudge::judge(const Scene &scene, const std::uint64_t) {
  Verdict verdict;
  write_scene(scene, folder + "/scene.prm", "");
  const Outcome program = run_program(laws, folder + "/scene.prm", folder);
  if (program.kind == Outcome::Kind::refused) {
    verdict.kind = Verdict::Kind::refused;
    verdict.text = program.message;
    return verdict;
  }
  const auto skip = [&](const std::string &why) {
    verdict.kind = Verdict::Kind::skipped;
    verdict.text = why;
    return verdict;
  };
  if (program.several_equilibria())
    return skip("several equilibria");
  if (program.halvings() > 0)
    return skip("increments were cut");
  const Solution solution = solve(scene);
  if (solution.hanger_pushes) {
    verdict.kind = Verdict::Kind::wrong;
    verdict.text = "a hanger that would have to push was sized";
    return verdict;
  }
  if (solution.hangs_on_contacts)
    return skip("something moves freely where no contact holds it");
  const auto is_right = [&](const Comparison &one) {
    return !one.unsure &&
           one.worst <= std::max(wind_on_bends(scene) ? 1e-3 : tolerance, 50. * one.rounding);
  };
  Comparison comparison = compare(program, solution);
  // Where the sweeps have not converged, or end elsewhere, they begin once more at the program's
  // forces: what obeys all laws in this solver too is an equilibrium of these loads.
  if (program.kind != Outcome::Kind::stopped && !is_right(comparison)) {
    const Comparison other = compare(program, solve(scene, forces_of(program, solution)));
    if (is_right(other) && !comparison.unsure)
      return skip("several equilibria, found by the oracle");
    if (is_right(other))
      comparison = other;
  }
  if (comparison.unsure)
    return skip("the oracle's contacts have not converged");
  if (!is_right(comparison))
    comparison = compare(program, solution, true);
  verdict.numbers = comparison.numbers;
  verdict.worst = comparison.worst;
  if (program.kind == Outcome::Kind::stopped) {
    verdict.kind = Verdict::Kind::wrong;
    verdict.text = "not converged: " + program.results.steps.back().remark;
  } else if (!is_right(comparison)) {
    verdict.kind = Verdict::Kind::wrong;
    verdict.text = comparison.what;
  }
  if (verdict.kind == Verdict::Kind::wrong)
    verdict.answer = describe(scene, solution);
  return verdict;
}

} // namespace oracle
