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
  double tolerance = 1e-7;           ///< in statics
  double transient_tolerance = 1e-6; ///< 0: it says nothing about transient steps
};

const std::vector<Relation> &relations();

/// The program against itself: both scenes are solved and compared.
class RelationJudge : public Judge {
public:
  RelationJudge(frictionbeam::LawLibrary &laws, const std::string &folder, const Relation &relation)
      : laws(laws), folder(folder), relation(relation) {}

  Scene make(std::uint64_t seed) const override;
  Verdict judge(const Scene &scene, std::uint64_t seed) override;

private:
  frictionbeam::LawLibrary &laws;
  const std::string folder;
  const Relation &relation;
};

} // namespace oracle
