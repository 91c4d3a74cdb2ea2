// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/cell/line_cells.h"
#include "model/model.h"

namespace frictionbeam {

/**
 * A scene's line, ready to be analysed: owns its parts in the order in which each is made from
 * those before it. The scene and the laws must outlive it.
 */
class LineModel {
public:
  /// Meshes the scene's pipes. @throws UserError for what cannot be meshed or assembled
  LineModel(const Scene &scene, const LawLibrary &laws);
  /// On a mesh of the scene's pipes. @param parts of them that are solid, in place of their cells
  LineModel(const Scene &scene, LineMesh mesh, const LawLibrary &laws,
            std::vector<SolidPart> parts = {});
  LineModel(const LineModel &) = delete; // its parts know each other
  LineModel &operator=(const LineModel &) = delete;

  const Model &model() const { return whole; }

  /// Take friction, gaps and whatever else the laws of supports say from another scene, which
  /// differs in nothing else.
  void take_laws_of(const Scene &other);

private:
  const LineMesh mesh;
  const Discretization discretization;
  const ReducedSpace space;
  Contacts contacts;
  LinearPart linear;
  const std::unique_ptr<const LineCells> cells;
  const Model whole;
};

/// Whether the scene has a step in which mass counts.
bool has_transient_step(const Scene &scene);

} // namespace frictionbeam
