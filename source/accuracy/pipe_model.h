// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "accuracy/bend_models.h"

namespace frictionbeam::accuracy {

/// As what the pipes of a line are to be solved.
struct PipeModel {
  std::string reason;
  double line_error = 0.;                    ///< that beams alone leave
  double error = 0.;                         ///< that the model leaves, if it may leave as much
  double by_bends = 0.;                      ///< of that, by bends that stay beams
  double beyond = 0.;                        ///< that the model leaves, if it may not
  std::vector<std::string> line;             ///< settings of supports that are as walls are
  std::vector<std::string> solid_at;         ///< bends that are
  std::vector<std::string> solid;            ///< settings that make bends solid; empty: beams alone
  std::vector<std::string> judged, left_out; ///< in words
};

/// How much of what is demanded may go where.
struct ModelShares {
  double demanded, of_model, of_walls;
};

/**
 * Bends that beams do not answer for (model_of_pipes()) become solids, with as many cells of degree
 * 3 around as leave no more than their share (flexibility_error()); what these, the joints and the
 * bends that stay beams leave is error. So is what walls change that give way at supports, grow
 * when they are hot and are rubbed on their outside (walls_at_supports()), while it is small; if it
 * is not, supports become as elastic as walls where that leaves less: what remains is how far the
 * formula of their elasticity is off, growth and the edges of patches (with_edges()), which are
 * entries too where that comes nearer. Where all this is too much, bends leave as much less by more
 * of them being solid, if that suffices.
 */
PipeModel choose_pipe_model(const Scene &scene, const ModelShares &shares, const SolveAs &solve);

} // namespace frictionbeam::accuracy
