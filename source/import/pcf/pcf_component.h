// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "import/pcf/component_kinds.h"
#include "import/pcf/import_notes.h"
#include "import/pcf/pcf_file.h"
#include "import/pcf/properties.h"
#include "scene/scene.h"

namespace frictionbeam::import {

/// A place of a component.
struct PcfPoint {
  Point3 position;  ///< [m]
  double bore = 0.; ///< nominal size in the file's unit; 0: not given
  unsigned int line = 0;
};

/// One component of the file, in SI units.
struct PcfComponent {
  std::string keyword;
  unsigned int line = 0;
  Shape shape = Shape::none;
  const ComponentKind *kind = nullptr; ///< null: a word that is not known
  unsigned int pipeline = 0;           ///< which PIPELINE-REFERENCE of the file it stands under
  std::vector<PcfPoint> ends, branches;
  std::optional<PcfPoint> centre, place; ///< CENTRE-POINT, CO-ORDS
  std::string skey, name, item, description;
  std::vector<std::string> words; ///< all that a table of supports may look for
  Properties properties;
  std::optional<double> bend_radius; ///< as the file says it [m]
  std::optional<double> angle;       ///< likewise, by which a bend turns [rad]

  /// The bore of an end; of its other end where that has none.
  double bore(const unsigned int end) const {
    return ends[end].bore > 0. ? ends[end].bore : ends[ends.size() - 1 - end].bore;
  }
  std::string text() const { return "line " + std::to_string(line) + ": " + keyword; }
};

struct PcfLine {
  std::vector<PcfComponent> components;
  std::vector<std::string> pipelines; ///< names, by PcfComponent::pipeline
  bool bores_in_inches = false;
  bool in_inches = false; ///< co-ordinates
};

/**
 * Understand the blocks of a file: units, pipelines, materials, components and their attributes.
 * @param attributes as of AttributeTable
 * @throws UserError for units that are missing or not known, points that are no numbers, components
 *   without the points that they need
 */
PcfLine read_components(const PcfFile &file, const std::string &attributes, Notes &notes);

} // namespace frictionbeam::import
