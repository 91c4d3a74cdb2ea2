// SPDX-License-Identifier: LGPL-2.1-or-later
#include "relations.h"
#include "writer.h"

#include <algorithm>

namespace oracle {

namespace {

bool is_transient(const Scene &scene) {
  return std::any_of(scene.steps.begin(), scene.steps.end(),
                     [](const Step &step) { return step.transient; });
}

/// Whether pipes yielded in the last step.
bool yields_at_last(const Outcome &outcome) {
  const frictionbeam::EnergyAccount &account = outcome.results.steps.back().energy;
  return account.inelastic > 1e-12 * account.turnover;
}

/// What a line of sections with laws that is called converged says against itself.
std::string uncertain(const Outcome &outcome) {
  if (outcome.kind != Outcome::Kind::converged)
    return "";
  const bool is_static = outcome.results.energy && outcome.results.energy->at_hand == 0. &&
                         outcome.scene.kinematics == frictionbeam::Kinematics::linear;
  for (const frictionbeam::Check &check : outcome.results.certificate) {
    const bool is_asked = check.name == "yield_violation" || check.name == "cell_equilibrium" ||
                          (check.name == "energy" && is_static);
    if (is_asked && !(check.value <= 1e-9))
      return "certificate: " + check.name + " is " + text(check.value);
  }
  return "";
}

} // namespace

Scene RelationJudge::make(const std::uint64_t seed) const {
  Random random(seed + 77);
  Kinds kinds;
  if (family.empty()) {
    kinds.contacts = random.chance(0.7);
    kinds.transient = random.chance(0.3);
  } else
    kinds = kinds_of(family, random);
  kinds.transient = kinds.transient && relation.transient_tolerance > 0.;
  kinds.moving = kinds.moving && kinds.transient;
  kinds.elastic = relation.elastic;
  kinds.contacts = kinds.contacts || kinds.elastic;
  kinds.large = kinds.large || (kinds.yielding && relation.prepare == &make_small_displacements);
  // Large displacements know no modes and spectra.
  kinds.response = kinds.response && relation.prepare != &make_small_displacements;
  Scene scene = random_scene(seed, kinds);
  if (relation.prepare != nullptr)
    relation.prepare(scene);
  return scene;
}

Verdict RelationJudge::judge(const Scene &scene, const std::uint64_t seed) {
  Verdict verdict;
  const auto skip = [&](const std::string &why) {
    verdict.kind = Verdict::Kind::skipped;
    verdict.text = why;
    return verdict;
  };
  Random random(seed + 99);
  const std::optional<Related> related = relation.change(scene, random);
  if (!related)
    return skip("the relation says nothing here");
  write_scene(scene, folder + "/scene.prm", "");
  const Outcome first = run_program(laws, folder + "/scene.prm", folder);
  if (first.kind == Outcome::Kind::refused) {
    verdict.kind = Verdict::Kind::refused;
    verdict.text = first.message;
    return verdict;
  }
  if (first.several_equilibria())
    return skip("several equilibria");
  write_scene(related->scene, folder + "/related.prm", "");
  const Outcome second = relation.interrupted ? run_interrupted(laws, folder + "/related.prm",
                                                                folder, random.whole(1, 6))
                                              : run_program(laws, folder + "/related.prm", folder);
  // Where an increment was cut, the path that friction follows is another one.
  const bool cut_alike = scene.has_laws() && first.halvings() == second.halvings();
  if (!cut_alike && (first.halvings() > 0 || second.halvings() > 0))
    return skip("increments were cut");
  if (relation.prepare == &unload && yields_at_last(first))
    return skip("it yields the other way");
  if (first.kind == Outcome::Kind::stopped && second.kind == Outcome::Kind::stopped &&
      !related->mapping.steps.empty())
    return skip("neither converges, in steps that are not the same");
  if (first.kind != second.kind) {
    verdict.kind = Verdict::Kind::wrong;
    verdict.worst = 1.;
    verdict.text = std::string("one of the two ") +
                   (second.kind == Outcome::Kind::refused   ? "is refused: " + second.message
                    : second.kind == Outcome::Kind::stopped ? "does not converge (changed)"
                                                            : "does not converge (original)");
  } else {
    const double tolerance = related->mapping.accuracy > 0. ? related->mapping.accuracy
                             : scene.has_laws()             ? relation.yielding_tolerance
                             : is_transient(scene)          ? relation.transient_tolerance
                                                            : relation.tolerance;
    verdict.worst =
        largest_difference(Answer(scene, first), related->mapping, Answer(related->scene, second),
                           verdict.text, verdict.numbers);
    if (verdict.worst > tolerance)
      verdict.kind = Verdict::Kind::wrong;
    for (const Outcome *outcome : {&first, &second})
      if (const std::string fault = scene.has_laws() ? uncertain(*outcome) : ""; !fault.empty()) {
        verdict.kind = Verdict::Kind::wrong;
        verdict.worst = 1.;
        verdict.text = fault;
      }
  }
  if (verdict.kind == Verdict::Kind::wrong) {
    std::map<std::string, std::string> tables;
    verdict.answer = "Relation '" + relation.name + "': " + relation.meaning +
                     ". The related scene:\n" + parameter_file(related->scene, tables);
  }
  return verdict;
}

} // namespace oracle
