// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/model.h"
#include "results/results.h"

namespace frictionbeam {

/**
 * The model as tables for other programs, with the unit behind each column's name (doc/results.md):
 * - `nodes.csv`: number, names and place of each node of the pipes;
 * - `elements.csv`: pipe, nodes, section and material of each element between two nodes;
 * - `restraints.csv`: each support, restraint and spring with its node and what it holds.
 * @p results must know its supports and restraints.
 */
void write_model_tables(const Model &model, const Results &results, const std::string &folder);

/**
 * Forces of every step and case at its end, with the unit behind each column's name:
 * - `element_forces.csv`: section forces at both ends of each element, in its local axes;
 * - `restraint_forces.csv`: of each support, restraint and spring on the pipe, in global axes.
 * Empty fields: what a case of amplitudes has no sign for.
 */
void write_force_tables(const Scene &scene, const Results &results, const std::string &folder);

} // namespace frictionbeam
