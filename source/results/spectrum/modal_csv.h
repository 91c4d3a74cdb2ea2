// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/file/output_file.h"
#include "results/results.h"

namespace frictionbeam {

/// All numbers of each mode in each direction as they come: modal_line.csv, modal_supports.csv and
/// modal_reactions.csv. Mode 0 is the missing mass.
class ModalCsv {
public:
  ModalCsv(const Scene &scene, const Results &results, const std::string &folder);
  void append(const unsigned int mode, const unsigned int direction, const Frame &frame);

private:
  const Scene &scene;
  const Results &results;
  OutputFile line, supports, reactions;
};

/// Write spectrum_modes.csv: of each spectrum, direction and mode its participation, spectral
/// acceleration and rigid share; if there is a spectrum.
void write_excitations(const Results &results, const std::string &folder);

/// The same as a table of the report, with the largest first; empty if there is no spectrum.
std::string excitation_table(const Results &results);

} // namespace frictionbeam
