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
  const Comparison comparison = compare(program, solution);
  if (comparison.unsure)
    return skip("the oracle's contacts have not converged");
  verdict.numbers = comparison.numbers;
  verdict.worst = comparison.worst;
  if (program.kind == Outcome::Kind::stopped) {
    verdict.kind = Verdict::Kind::wrong;
    verdict.text = "not converged: " + program.results.steps.back().remark;
  } else if (comparison.worst >
             std::max(wind_on_bends(scene) ? 1e-3 : tolerance, 50. * comparison.rounding)) {
    verdict.kind = Verdict::Kind::wrong;
    verdict.text = comparison.what;
  }
  if (verdict.kind == Verdict::Kind::wrong)
    verdict.answer = describe(scene, solution);
  return verdict;
}

} // namespace oracle
