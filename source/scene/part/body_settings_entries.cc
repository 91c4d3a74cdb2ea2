// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/part/body_parts.h"

namespace frictionbeam::parts {

namespace {

using Refinement = ContinuumSettings::Refinement;
constexpr Word<Refinement> refinements[] = {
    {"adaptive", Refinement::adaptive,
     "the cells with the largest error estimate, and those at the ends of slip zones"},
    {"uniform", Refinement::uniform, "all"},
    {"none", Refinement::none, "the first mesh only"}};

using LinearSolver = ContinuumSettings::LinearSolver;
constexpr Word<LinearSolver> linear_solvers[] = {
    {"auto", LinearSolver::automatic,
     "multigrid from 3,000 unknowns in 3D, where the first mesh has at most 1,000 nodes or its "
     "linear elements a quarter of the unknowns, and no curved cells; else direct, but under "
     "mpirun amg from 60,000 unknowns in 2D, 15,000 in 3D"},
    {"direct", LinearSolver::direct,
     "factorization (with mpirun: Amesos KLU, which works on one process)"},
    {"multigrid", LinearSolver::multigrid,
     "CG or GMRES, matrix-free, with geometric multigrid down to the first mesh"},
    {"amg", LinearSolver::amg, "CG or GMRES with Trilinos ML, needs mpirun"}};

} // namespace

void declare_continuum(ParameterReader &in) {
  in.declare_count("Degree", 3, 1, "Of the elements' polynomials, per direction.", 10);
  in.declare_count("Cells", 2, 1,
                   "Of the first mesh across the height of a generated body; about square.");
  in.declare_number("Tolerance", 1e-3, "-", positive, 1.,
                    "Relative, of every quantity: the mesh is refined until the estimated errors "
                    "are below it.");
  in.declare_choice("Refinement", Refinement::adaptive, refinements, "");
  in.declare_number("Fraction", 0.8, "-", positive, 1.,
                    "Of the squared error estimate that the cells to be refined hold together.");
  in.declare_count("Max refinements", 20, 0, "Of the first mesh.", 100);
  in.declare_count("Max unknowns", 200000, 1, "A mesh that has more is not refined any further.",
                   100000000);
  in.declare_choice("Linear solver", LinearSolver::automatic, linear_solvers, "");
  in.declare_count("Increments", 1, 1,
                   "Of each step. Friction depends on the path: 1 applies a step's loads at once.");
  in.declare_count("Dimension", 2, 2, "Of a body; of a generated slab 3 with its width.", 3);
}

void parse_continuum(const ParameterReader &in, Scene &scene) {
  ContinuumSettings &settings = scene.continuum_settings;
  settings.degree = in.count("Degree");
  if (settings.degree > 12)
    in.fail("Degree", "1 to 12", "2 or 3, with more cells");
  settings.cells = in.count("Cells");
  settings.tolerance = in.number("Tolerance");
  settings.refinement = in.choice("Refinement", refinements);
  settings.fraction = in.number("Fraction");
  settings.max_refinements = in.count("Max refinements");
  settings.max_unknowns = in.count("Max unknowns");
  settings.linear_solver = in.choice("Linear solver", linear_solvers);
  settings.increments = in.count("Increments");
  settings.dimension = in.count("Dimension");
  if (settings.dimension > 3)
    in.fail("Dimension", "2 or 3", "2");
}

void check_model(const ParameterReader &in, const Scene &scene) {
  const bool is_automatic = scene.model == ModelKind::automatic;
  if (scene.model == ModelKind::continuum && !scene.continuum)
    in.fail("Model", "line, solid, both or auto for Scene = " + in.text("Scene"),
            "line; slab, long bar and body are continua");
  if (scene.model == ModelKind::solid && scene.continuum)
    in.fail("Model", "solid for scenes of pipes",
            "continuum, which Scene = " + in.text("Scene") + " is as well");
  if (scene.accuracy > 0. && scene.model == ModelKind::both && scene.continuum)
    in.fail("Accuracy", "Model = line, continuum or auto", "one after the other",
            in.text("Accuracy"));
  if (is_automatic && scene.accuracy == 0.)
    in.fail("Model", "auto together with Accuracy, by which it chooses", "set Accuracy = 1e-2");
  if (scene.model != ModelKind::continuum && !is_automatic && scene.steps.empty())
    in.fail("Model", "continuum or auto for Scene = " + in.text("Scene"), "continuum");
}

bool has_line(const Scene &scene) {
  return scene.model != ModelKind::continuum && !scene.steps.empty();
}

} // namespace frictionbeam::parts
