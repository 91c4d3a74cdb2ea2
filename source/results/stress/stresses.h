// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "mesh/line_mesh.h"
#include "results/results.h"

namespace frictionbeam {

/**
 * Stresses of the cases that section Stress names, at every station of their frames: at the end of
 * static steps, the largest over all instants of transient ones, of combinations with transient
 * steps an upper bound, at the corners of what the forces can be. All these frames must have been
 * built with both sides of each node.
 * @param pressure inside a pipe in a step
 */
std::vector<StressCase>
evaluate_stresses(const Scene &scene, const LineMesh &mesh, const Results &results,
                  const std::function<double(const std::string &, const unsigned int)> &pressure);

/// Ask the stress code, which there is, about every node. @throws UserError naming the first that
/// it has nothing for, or where it does what no code may (stress_code_faults())
/// @return a remark on places that it has no factors for (unintensified_places()), or nothing
std::string check_stress_code(const Scene &scene, const LineMesh &mesh,
                              const std::vector<Station> &line);

/// Nozzle limits and the restraints that they are for, as places in Scene::nozzles and
/// Results::restraints.
std::vector<std::pair<unsigned int, unsigned int>> nozzle_sites(const Scene &scene,
                                                                const Results &results);

/// Largest part that a force takes of what a nozzle is allowed.
double utilization(const NozzleLimit &nozzle, const Motion &force);

/// Largest force over allowed force of every nozzle limit in every finished step: at its end, of a
/// transient one over all instants.
std::vector<NozzleUse> evaluate_nozzles(const Scene &scene, const Results &results);

/// A quantity of the stress code: flexibility, sif_in, sif_out at a point, SL and SE at a point in
/// a step, utilization of all or of one step; the largest of the sides and pipes that are asked for
/// at a point. Empty if there is none.
std::optional<double> stress_quantity(const Quantity &quantity, const Scene &scene,
                                      const LineMesh &mesh, const Results &results);

/// As HTML; empty if there are none.
std::string stress_section(const Scene &scene, const Results &results);
std::string nozzle_section(const Results &results);

/// Write stresses.csv and nozzles.csv, where there are any, in the units of the results.
void write_stresses(const Scene &scene, const Results &results, const std::string &folder);

} // namespace frictionbeam
