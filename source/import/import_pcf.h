// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "import/line/line_plan.h"
#include "import/line/section_plan.h"
#include "import/pcf/import_notes.h"

namespace frictionbeam::import {

/// How a piping component file is read (doc/import.md).
struct ImportOptions {
  std::string file;
  std::string output;              ///< parameter file; empty: the file's name with .prm
  std::string support_map;         ///< as of SupportTable; empty: none
  std::string attributes = "none"; ///< as of AttributeTable
  SectionOptions sections;
  double tolerance = 1.;          ///< within which ends are the same [mm]
  std::string encoding = "utf-8"; ///< or latin-1
  std::string units = "si";       ///< of the parameter file, as of its entry Units
  bool overwrite = false;         ///< a parameter file that is there
};

struct ImportedLine {
  LinePlan plan;
  Notes notes;
  std::size_t n_components = 0;
};

/// @throws UserError for what cannot be understood without guessing: see the functions it is made
/// of
ImportedLine import_pcf(const ImportOptions &options);

/// The parameter file of a line, with what was not understood as comments on top.
std::string prm_text(const ImportedLine &line, const ImportOptions &options);

} // namespace frictionbeam::import
