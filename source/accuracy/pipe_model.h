// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "accuracy/bend_models.h"

namespace frictionbeam::accuracy {

/// As what the pipes of a line are to be solved.
struct PipeModel {
  std::string reason;
  double line_error = 0.;                    ///< that beams alone leave
  double error = 0.;                         ///< that the model leaves
  double beyond = 0.;                        ///< error that no such model takes away
  std::vector<std::string> solid;            ///< settings that make bends solid; empty: beams alone
  std::vector<std::string> judged, left_out; ///< in words
};

/// How much of what is demanded may go where.
struct ModelShares {
  double demanded, of_model, of_walls;
};

/// Solves the scene as beams with further settings.
using SolveWith = std::function<Results(const std::vector<std::string> &settings)>;

/**
 * Bends that beams do not answer for (model_of_pipes()) become solids, with as many cells of degree
 * 3 around as leave no more than their share (flexibility_error(), and what a stretch leaves of the
 * oval); what walls change that give way at supports (elastic_supports()) is error too while it is
 * small, and else more than may be left, for solid bends do not know it.
 */
PipeModel choose_pipe_model(const Scene &scene, const ModelShares &shares, const SolveAs &solve_as,
                            const SolveWith &solve_with);

} // namespace frictionbeam::accuracy
