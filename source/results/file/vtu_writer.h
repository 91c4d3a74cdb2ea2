// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

namespace frictionbeam {

/**
 * Writes frames for ParaView while the analysis runs, by deal.II's DataOutInterface. In the folder:
 *
 * - `results.pvd` and `vtu/line_0000.vtu`, ...: the pipes, with displacement, rotation, the section
 *   forces N, Vy, Vz, Mx, My, Mz, the place s along the pipe and the pipe's number;
 * - `supports.pvd` and `vtu/supports_0000.vtu`, ...: one point for each support, with its force on
 *   the pipe in global axes, fn, friction, status (1 stick, 2 slip, 3 open, 4 closed), gap, slip
 *   and the work of friction;
 * - `cases.pvd` and `vtu/case_0001.vtu`, ..., `case_supports.pvd` and `vtu/case_supports_0001.vtu`,
 * ...: the same of cases made of steps, their numbers in the order of the tables as times, for they
 *   have none of their own. Vectors of forces and slips that cannot be told from sizes are NaN;
 * - `modes.pvd` and `vtu/mode_0001.vtu`, ...: the shapes of the modes, their frequencies as times.
 *
 * In the units of the results. All functions throw UserError if a file
 * cannot be written.
 */
class VtuWriter {
public:
  /// @p results must know its supports and outlive this object. @param n_steps frames beyond are
  /// those of cases
  VtuWriter(const Results &results, const std::string &folder, const unsigned int n_steps);

  /// Write @p frame. The pvd files follow at once while frames are few, then every tenth of them.
  void append(const Frame &frame);

  /// The list of what was written.
  void transfer(Archive &archive) {
    archive(n_frames, next_collection, line_frames, support_frames, line_cases, support_cases);
  }

  /// Write the shapes of the modes, if there are any. To be called once.
  void append_modes() const;

  /// Enter all frames into the pvd files. To be called at the end.
  void finish() const;

private:
  using Collection = std::vector<std::pair<double, std::string>>; ///< time, file

  /// Write a frame into files of these names, and enter it at a time.
  void write_frame(const Frame &frame, const std::string &line, const std::string &supports,
                   const double time, Collection &of_line, Collection &of_supports) const;

  const Results &results;
  std::string folder;
  unsigned int n_steps, n_frames = 0, next_collection = 1;
  Collection line_frames, support_frames, line_cases, support_cases;
};

/// Remove the frames that another run has left in the folder.
void remove_frames(const std::string &folder);

} // namespace frictionbeam
