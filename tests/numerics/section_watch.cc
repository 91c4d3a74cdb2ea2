// SPDX-License-Identifier: LGPL-2.1-or-later
// Histories of sections that yield: of a cantilever bent beyond yield the root is followed, and of
// one that yields at two places both are; where there is too much to keep, instants are forgotten
// evenly, the first and the last are there, and a watch that was put into an archive goes on as if
// nothing had been.
#include "../check.h"
#include "line_from.h"

#include "analysis/sequence/load_sequence.h"
#include "results/inelastic/section_watch.h"

using namespace frictionbeam;

namespace {

/// A tube, clamped at A; its end B is moved, and held against turning or not.
std::string scene(const std::string &motions, const std::string &output) {
  return R"(
subsection Material steel
  set Young's modulus = 2e11
end
subsection Section tube
  set Outer diameter = 0.1
  set Wall = 0.005
  set Law = fibre_pipe
  set Radii = 1
  set Fibres = 15
  set Yield stress = 2e8
end
subsection Pipe tube
  set Route = A 0 0 0; B 4 0 0
end
subsection Mesh
  set Cell length = 0.1
end
subsection Support clamp
  set Kind = anchor
  set At = A
end
subsection Load move
  set Kind = displacement
  set Displacements = B )" +
         motions + R"(
end
subsection Step push
  set Loads = move
  set Increments = 4
end
subsection Output
  )" + output +
         "\nend\n";
}

LineState pushed(const Model &model, SectionWatch &watch) {
  LoadSequence sequence(model);
  CHECK(sequence.run([](const Progress &, const LineState &) {},
                     [&](const Progress &, const LineState &state) { watch.observe(state); }));
  return sequence.state();
}

void check_places() {
  const LineFrom cantilever(scene("uz -0.2", ""));
  SectionWatch watch(cantilever.model);
  const std::vector<SectionHistory> one = watch.histories(pushed(cantilever.model, watch));
  CHECK(one.size() == 1 && one[0].name == "A" && one[0].states.size() >= 5);
  for (std::size_t i = 1; i < one[0].states.size(); ++i)
    CHECK(one[0].states[i].strain[4] > one[0].states[i - 1].strain[4]); // curvature about y

  const LineFrom held(scene("uz -0.2 ry 0", "")); // bent to and fro: hinges at both ends
  SectionWatch of_both(held.model);
  const std::vector<SectionHistory> two = of_both.histories(pushed(held.model, of_both));
  CHECK(two.size() == 2 && two[0].name != two[1].name);
  const SectionState &a = two[0].states.back(), &b = two[1].states.back();
  CHECK(a.plastic_strain > 0.);
  CHECK_NEAR(a.plastic_strain, b.plastic_strain, 1e-9);
  CHECK_NEAR(1. + (a.force[4] + b.force[4]) / a.force[4], 1., 1e-9);

  const LineFrom chosen(scene("uz -0.2", "set Sections = B"));
  SectionWatch of_end(chosen.model);
  const std::vector<SectionHistory> end = of_end.histories(pushed(chosen.model, of_end));
  CHECK(end.size() == 1 && end[0].name == "B" && end[0].states.back().s == 4.);
  CHECK(end[0].states.back().plastic_strain == 0.);
}

void check_forgetting() {
  constexpr unsigned int n = 4003;
  const LineFrom line(scene("uz -0.2", ""));
  SectionWatch first(line.model), whole(line.model);
  SectionWatch ignored(line.model);
  LineState state = pushed(line.model, ignored);
  Archive bytes;
  for (unsigned int i = 0; i < n; ++i) {
    state.time = i;
    whole.observe(state);
    if (i < n / 2)
      first.observe(state);
    if (i + 1 == n / 2)
      first.transfer(bytes);
  }
  SectionWatch resumed(line.model);
  Archive read(bytes.bytes());
  resumed.transfer(read);
  for (unsigned int i = n / 2; i < n; ++i) {
    state.time = i;
    resumed.observe(state);
  }
  const std::vector<SectionHistory> of_whole = whole.histories(state),
                                    of_resumed = resumed.histories(state);
  CHECK(of_whole.size() == 1 && of_resumed.size() == 1);
  const SectionHistory &history = of_whole[0];
  CHECK(history.every > 1 && history.time == of_resumed[0].time);
  CHECK(history.time.front() == 0. && history.time.back() == n - 1.);
  for (std::size_t i = 1; i + 1 < history.time.size(); ++i)
    CHECK(history.time[i] - history.time[i - 1] == history.every);
  CHECK(history.states.size() == history.time.size());
}

} // namespace

int section_watch(int, char **) {
  check_places();
  check_forgetting();
  return check::report();
}
