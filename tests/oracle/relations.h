// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "answer.h"
#include "judge.h"

#include <functional>
#include <optional>

namespace oracle {

/// A scene changed in a way that changes its answer in a known one.
struct Related {
  Scene scene;
  Mapping mapping;
};

/// A metamorphic relation between scenes.
struct Relation {
  std::string name, meaning;
  /// Nothing if the relation says nothing about this scene.
  std::function<std::optional<Related>(const Scene &, Random &)> change;
  double tolerance = 1e-7;            ///< in statics
  double transient_tolerance = 1e-6;  ///< 0: it says nothing about transient steps
  bool elastic = false;               ///< asked of scenes whose contacts all have a stiffness
  bool interrupted = false;           ///< the second run is interrupted and resumed
  void (*prepare)(Scene &) = nullptr; ///< makes a random scene one of which something is said
  double yielding_tolerance = 1e-6;   ///< where sections yield; 0: it says nothing about them
};

const std::vector<Relation> &relations();

// In relations_of_steps.cc: of load sequences rather than of lines.
std::optional<Related> step_split(const Scene &scene, Random &random);
std::optional<Related> detour(const Scene &scene, Random &random);
std::optional<Related> last_step_again(const Scene &scene, Random &random);
std::optional<Related> slowly(const Scene &scene, Random &random);
std::optional<Related> interrupted(const Scene &scene, Random &random);
std::optional<Related> linear_kinematics(const Scene &scene, Random &random);
std::optional<Related> in_ten_increments(const Scene &scene, Random &random);
void unload(Scene &scene);
void make_small_displacements(Scene &scene);
void make_static(Scene &scene);

/// The program against itself: both scenes are solved and compared.
class RelationJudge : public Judge {
public:
  /// @param family of scenes; empty: contacts, and transient steps in some
  RelationJudge(frictionbeam::LawLibrary &laws, const std::string &folder, const Relation &relation,
                const std::string &family)
      : laws(laws), folder(folder), relation(relation), family(family) {}

  Scene make(std::uint64_t seed) const override;
  Verdict judge(const Scene &scene, std::uint64_t seed) override;

private:
  frictionbeam::LawLibrary &laws;
  const std::string folder;
  const Relation &relation;
  const std::string family;
};

} // namespace oracle
