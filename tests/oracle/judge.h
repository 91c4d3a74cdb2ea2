// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "random_scene.h"

#include <frictionbeam/law_library.h>

#include <string>

namespace oracle {

/// What became of a scene: the program was right, or wrong and how; or nothing could be asked.
struct Verdict {
  enum class Kind { right, wrong, refused, skipped } kind = Kind::right;
  std::string text;   ///< of a wrong one: how; of a skipped or refused one: why
  std::string answer; ///< of a wrong one: what is right
  int numbers = 0;    ///< that were compared
  double worst = 0.;  ///< largest relative difference
};

/// How scenes are made and judged. Files go to a folder of the process.
class Judge {
public:
  virtual ~Judge() = default;
  virtual Scene make(std::uint64_t seed) const = 0;
  virtual Verdict judge(const Scene &scene, std::uint64_t seed) = 0;
};

/// The program against the dense solver, to @p tolerance.
class OracleJudge : public Judge {
public:
  OracleJudge(frictionbeam::LawLibrary &laws, const std::string &folder, const Kinds &kinds,
              const double tolerance)
      : laws(laws), folder(folder), kinds(kinds), tolerance(tolerance) {}

  Scene make(std::uint64_t seed) const override;
  Verdict judge(const Scene &scene, std::uint64_t seed) override;

private:
  frictionbeam::LawLibrary &laws;
  const std::string folder;
  const Kinds kinds;
  const double tolerance;
};

/// The scene with all left out that the judge does not need to find it wrong.
Scene made_small(Scene scene, Judge &judge, std::uint64_t seed);

} // namespace oracle
