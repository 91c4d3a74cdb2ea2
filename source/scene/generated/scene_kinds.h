// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/file/parameter_reader.h"
#include "scene/scene.h"

#include <frictionbeam/law_library.h>

#include <functional>
#include <vector>

namespace frictionbeam {

/// A word of the entry Scene, and all that is to know of it.
struct SceneKind {
  const char *word;
  const char *value; ///< its section in the parameter file; empty: it is made of the parts there
  const char *meaning;
  std::function<void(ParameterReader &, const LawLibrary &)> declare{};
  void (*build)(const ParameterReader &, const LawLibrary &, Scene &) = nullptr;

  /// An entry of the section that Accuracy may make finer, and its coarsest value.
  struct Fineness {
    const char *what, *entry;
    unsigned int coarsest;
  };
  const char *increments = ""; ///< entry of the section for those of its static steps, if any
  std::vector<Fineness> others{};
  bool has_elements = false; ///< of the slab, by Elements and GS together

  bool is_generated() const { return build != nullptr; }
};

/// All of them; the first is the scene that is made of parts.
const std::vector<SceneKind> &scene_kinds();

/// The one that a parameter file asks for.
const SceneKind &scene_kind(const std::string &word);

} // namespace frictionbeam
