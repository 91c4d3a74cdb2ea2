// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"
#include "scene/scene.h"
#include <frictionbeam/law_library.h>

#include <string>

namespace oracle {

/// What the program says about a parameter file.
struct Outcome {
  enum class Kind { converged, stopped, refused } kind = Kind::refused;
  std::string message; ///< of a refused file
  frictionbeam::Scene scene;
  frictionbeam::Results results;

  unsigned int halvings() const;   ///< of increments and time steps
  bool several_equilibria() const; ///< beyond the limit of uniqueness, says the program
};

/// Read the file and solve it as the program does, in this process. Its results go to @p folder,
/// which exists.
Outcome run_program(frictionbeam::LawLibrary &laws, const std::string &file,
                    const std::string &folder);

/// As run_program(), but a signal ends the run after every increment or time step, @p times times,
/// and each time it is resumed from its checkpoint in a process of its own.
Outcome run_interrupted(frictionbeam::LawLibrary &laws, const std::string &file,
                        const std::string &folder, int times);

} // namespace oracle
