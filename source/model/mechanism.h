// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/model.h"

namespace frictionbeam {

/**
 * Check that nothing in a scene with static steps can move as a rigid body: for every connected
 * part of the line, whether restraints, springs and supports (one-way ones counted as if they held
 * both ways) leave a rigid motion free.
 * @throws UserError that names the part and its free motion.
 * @return warnings, one for each part that friction alone holds against some motion, and for each
 * motion that a load imposes, nothing else holds and some steps do not name.
 */
std::vector<std::string> check_mechanisms(const Model &model);

/// A part of the way from the first to the second vertex of a pipe cell: "pipe NAME at s = 1.5 m".
std::string place_in_words(const Model &model, const unsigned int cell, const double part);

} // namespace frictionbeam
