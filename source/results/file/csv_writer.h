// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/file/output_file.h"
#include "results/results.h"

#include <memory>

namespace frictionbeam {

/**
 * Writes the csv files of a run frame by frame while the analysis runs, and hands each frame to the
 * system at once, so that nothing is lost if the run dies:
 *
 * - `supports.csv`: support, step, increment, time, status, fn, ft1, ft2, gap, slip1, slip2,
 *   work_friction, of every frame;
 * - `reactions.csv`: restraint, step, increment, time, fx, fy, fz, mx, my, mz, of every frame;
 * - `line.csv`: step, pipe, s, x, y, z, ux, uy, uz, rx, ry, rz, N, Vy, Vz, Mx, My, Mz, M_in, M_out
 * (of bends; 0 elsewhere), at the ends of the steps only, since its rows carry no time;
 * - `sections.csv`: step, pipe, s, eps, gamma_y, gamma_z, chi, kappa_y, kappa_z, N, Vy, Vz, Mx, My,
 * Mz, utilization, plastic_strain, creep_strain, dissipation, likewise, of pipes that yield or
 * creep, if there are any;
 * - `history_POINT.csv`: time, ux, uy, uz, rx, ry, rz, for each monitored point.
 *
 * In the units of the scene, radians; each number is the shortest text that reads back as the same
 * number. Names are quoted where RFC 4180 asks for it; lines end with a line feed. A character of a
 * point's name that is no letter, digit, dot or minus is _ in the name of its file.
 *
 * All functions throw UserError if a file cannot be written.
 */
class CsvWriter {
public:
  /// Create the files in @p folder and write their headers. @p results must know its supports,
  /// restraints and histories; both objects must outlive this one. @p keep: the files are there,
  /// and transfer() will say how far they are good.
  CsvWriter(const Scene &scene, const Results &results, const std::string &folder,
            const bool keep = false);

  /// The lengths of the files; reading, they are cut to these.
  void transfer(Archive &archive);

  /// Add the rows of @p frame, and what the histories have gained.
  void append(const Frame &frame);

  /// Add what the histories have gained since the last frame. To be called at the end.
  void finish();

private:
  void append_supports(const Frame &frame);
  void append_reactions(const Frame &frame);
  void append_line(const Frame &frame);
  void append_sections(const Frame &frame);

  const Scene &scene;
  const Results &results;
  OutputFile supports, line, reactions;
  std::unique_ptr<OutputFile> sections; ///< null if no pipe yields
  std::vector<std::unique_ptr<OutputFile>> histories;
  std::vector<std::size_t> n_written; ///< rows of each history
};

/// Write section_history.csv, if there are any: section, pipe, s, time, and the columns of
/// sections.csv behind s, at every increment that was kept.
void write_section_histories(const Scene &scene, const Results &results, const std::string &folder);

/// Remove the tables of a line from a folder, whose answer is to be another one's.
void remove_line_tables(const std::string &folder);

/// @p text as one field of a csv file, in double quotes where RFC 4180 asks for them.
std::string csv_field(const std::string &text);

} // namespace frictionbeam
