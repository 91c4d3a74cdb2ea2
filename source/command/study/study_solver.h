// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/run_options.h"
#include "study/study_results.h"

#include <memory>
#include <mutex>

namespace frictionbeam::study {

/// The case of a study, as it stands in its file, and what its runs have in common.
struct StudyCase {
  RunOptions options;
  Scene scene; ///< its hangers sized: they are built once, whatever varies
  std::vector<ResultName> names;
  bool varies_laws = false;   ///< nothing but friction and gaps of supports varies
  mutable std::mutex meshing; ///< gmsh does one mesh at a time
};

/// The scene of a case with further options of --set, writing no files.
Scene read_variant(const StudyCase &of, const std::vector<std::string> &settings, LawLibrary &laws);

/// Solve a scene that writes no files, with all that a report says. @throws UserError
Results solve_variant(const StudyCase &of, const Scene &scene, const LawLibrary &laws);

/**
 * Solves runs of a study one after the other, each as if it were alone: what the varied entries
 * leave alone is kept from run to run, but nothing that depends on the runs before. Where friction
 * and gaps alone vary, that is the line with the factors of its stiffness, and its numbers are made
 * by QuickLine.
 */
class StudySolver {
public:
  explicit StudySolver(const StudyCase &of);
  ~StudySolver();

  /// @param settings options of --set of this run
  Run solve(const std::vector<std::string> &settings);

private:
  class SharedLine;

  Run solve(const Scene &scene);
  /// The supports of the case with these settings; none where they mean more than numbers of laws.
  std::optional<std::vector<FrictionSupport>>
  supports_with(const std::vector<std::string> &settings) const;

  const StudyCase &of;
  LawLibrary laws;
  std::unique_ptr<SharedLine> shared; ///< null before the first run that shares
};

} // namespace frictionbeam::study
