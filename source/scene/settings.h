// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/file/choice.h"

#include <array>
#include <string>
#include <utility>
#include <vector>

/**
 * @file
 * How a scene is discretized, solved and written, plain data in SI units. Beside each choice stands
 * its table of words (choice.h), the one place that knows what a choice is called and what there is
 * to know of it before it runs.
 */
namespace frictionbeam {

/// Who divides routes into cells.
enum class Mesher { automatic, gmsh };

struct MeshSettings {
  std::string file;                   ///< .geo or .msh of the user's own; empty: routes
  double cell_length = 0.;            ///< longest cell of a straight run [m]; 0: one cell a run
  unsigned int section_points = 5;    ///< along a cell whose section yields or creeps
  unsigned int cells_per_bend = 8;    ///< in 90 degrees
  unsigned int cells_of_reducer = 10; ///< whose section changes from cell to cell
  unsigned int refinements = 0;       ///< how often each cell of these is halved
  bool arcs = false;                  ///< a bend is one exact arc, not straight cells
  double most_cells = 200000.;        ///< more are refused
  Mesher mesher = Mesher::automatic;
  bool refine_hinges = false; ///< halve cells that yield until that changes little
  /// Nodes that this has added, by the number of their pipe and the way along it [m].
  std::vector<std::pair<unsigned int, double>> hinge_nodes = {};
};

/// For equilibrium with contact.
enum class SolverMethod { elastic, newton, exact };

struct SolverMethodRow {
  const char *word;
  SolverMethod value;
  const char *meaning;
  bool is_exact;        ///< rigid contact and friction; else their return mapping
  bool has_tangent;     ///< that is consistent; else the elastic stiffness is kept
  const char *in_words; ///< for the report
};

inline constexpr SolverMethodRow solver_methods[] = {
    {"elastic", SolverMethod::elastic,
     "the elastic stiffness kept, residual forces sent back, as TEDEL did", false, false,
     "elastic stiffness kept, residual forces sent back"},
    {"newton", SolverMethod::newton,
     "consistent tangent, line search, increments halved where needed", false, true,
     "consistent tangent of the return mapping, line search"},
    {"exact", SolverMethod::exact,
     "Signorini's condition and Coulomb's law without a stiffness to choose, in static steps "
     "(transient ones by Time/Integrator)",
     true, true, "Signorini and Coulomb by a proximal-point semismooth Newton method"}};

struct SolverSettings {
  SolverMethod method = SolverMethod::exact;
  double tolerance = 1e-10;         ///< of the residual, relative to the largest force
  double creep_tolerance = 1e-3;    ///< of stresses of sections that creep, an increment
  double contact_tolerance = 1e-8;  ///< exact: of the contact laws, each contact on its own scale
  unsigned int max_iterations = 50; ///< newton, an increment; elastic: max_elastic_iterations
  unsigned int max_elastic_iterations = 10000;
  unsigned int max_halvings = 10; ///< of an increment

  const SolverMethodRow &row() const { return row_of(solver_methods, method); }
  bool is_exact() const { return row().is_exact; }
  bool has_tangent() const { return row().has_tangent; }
};

/// How transient steps are reduced to contact nodes and modes.
struct ReductionSettings {
  enum class Modes { all, automatic, number } modes = Modes::all; ///< all: nothing is reduced
  unsigned int n_modes = 0;                                       ///< if a number is given
  double tolerance = 1e-3; ///< automatic: of contact forces and monitored motions, relative
};

enum class Integrator { newmark, generalized_alpha, moreau_jean, nonsmooth_alpha, event };

struct IntegratorRow {
  const char *word;
  Integrator value;
  const char *meaning;
  double spectral_radius; ///< at infinity, if the user gives none; of the alpha schemes
  bool is_exact;          ///< its answers do not depend on the time step, and it misses no event
  bool is_for_turning;    ///< with Kinematics = corotational
  std::array<const char *, 2> entries; ///< of Time that are its own
};

inline constexpr std::array<const char *, 2> of_newmark{{"Beta", "Gamma"}},
    of_alpha{{"Spectral radius"}}, of_theta{{"Theta"}}, of_none{};

inline constexpr IntegratorRow integrators[] = {
    {"newmark", Integrator::newmark, "", 1., false, true, of_newmark},
    {"generalized_alpha", Integrator::generalized_alpha, "", 0.8, false, true, of_alpha},
    {"moreau_jean", Integrator::moreau_jean, "", 1., false, true, of_theta},
    {"nonsmooth_alpha", Integrator::nonsmooth_alpha, "", 1., false, true, of_alpha},
    {"event", Integrator::event,
     "exact from one change of a contact's state to the next, with any step", 1., true, false,
     of_none}};

struct TimeSettings {
  Integrator integrator = Integrator::moreau_jean;
  double step = 0.;                ///< [s]; 0: by the mesh
  double output_interval = 0.;     ///< [s]; 0: every step
  double tolerance = 0.;           ///< of displacements in one step [m]; 0: fixed steps
  double beta = 0.25, gamma = 0.5; ///< newmark
  double spectral_radius = 1.;     ///< at infinity, of the alpha schemes
  double theta = 0.5;              ///< moreau_jean
  double mass_damping = 0., stiffness_damping = 0.; ///< C = mass [1/s] M + stiffness [s] K
  double modal_damping = 0.; ///< of the line's own modes; rigid ones have none
  ReductionSettings reduction;

  const IntegratorRow &row() const { return row_of(integrators, integrator); }
  bool is_exact() const { return row().is_exact; }
};

struct OutputSettings {
  std::string directory;
  unsigned int stations = 3; ///< between the nodes of a cell
  /// Points whose sections are followed through all increments; empty: where most yields and
  /// creeps.
  std::vector<std::string> sections = {};
  std::vector<std::string> steps =
      {};                       ///< that the report shows, or cases; empty: as many as can be
  bool every_increment = false; ///< csv rows and vtu at every increment, not only at step ends
  bool vtu = true, report = true;
  unsigned int vtu_frames = 200;    ///< of a transient step, at most; 0: all
  bool contact_problems = false;    ///< FCLIB files of every static increment
  double checkpoint_interval = 60.; ///< of wall time [s]; 0: none
  bool resume = false;              ///< from the checkpoint in the directory, if there is one
  bool quiet = false;               ///< no progress on a terminal
};

/// What a run is judged by besides its solution.
struct CheckSettings {
  double reference_tolerance = 0.01; ///< of quantities with a reference, relative
  bool uplift = true;                ///< rests have to hold the line at the ends of static steps
  bool decide_exit_status = false;   ///< whether a check that fails is an exit status of its own
};

/// How the wall of a pipe is meshed as a solid, and held (section Solid).
struct SolidSettings {
  /// What an anchor holds of its section: everything, or all but that it widens evenly.
  enum class Anchors { held, breathing } anchors = Anchors::held;
  unsigned int degree = 2;                   ///< of the elements and of their geometry
  unsigned int cells_around = 16;            ///< the circumference
  unsigned int cells_through = 1;            ///< the wall
  unsigned int cells_per_bend = 8;           ///< in 90 degrees
  bool pressure_stiffening = true;           ///< the wall's, by the pressure in it
  double first_cell = 0., longest_cell = 0.; ///< of a straight run [m]; 0: by the section
  double most_unknowns = 200000.;            ///< more are refused
  double reach = 2.; ///< of a mixed model's walls beside bends, in r sqrt(r/t)
};

/// Which model of the scene is solved; automatic: the line, if it is good enough for the accuracy.
enum class ModelKind { line, continuum, solid, both, automatic };

inline constexpr Word<ModelKind> model_kinds[] = {
    {"line", ModelKind::line, "beams"},
    {"continuum", ModelKind::continuum, "a plane or solid body, of scenes that are one"},
    {"solid", ModelKind::solid, "the wall of the pipes of routes as a solid, in static steps"},
    {"both", ModelKind::both,
     "the line and the other model of the scene, one after the other, side by side"},
    {"auto", ModelKind::automatic,
     "the line if its modelling error is estimated to be below Accuracy, else the continuum"}};

/// How motions become strains.
enum class Kinematics {
  linear,      ///< small displacements and rotations, on the line as it is built
  corotational ///< each beam cell turns with its ends, by any angle; strains are small
};

inline constexpr Word<Kinematics> kinematics_kinds[] = {
    {"linear", Kinematics::linear, "small displacements"},
    {"corotational", Kinematics::corotational,
     "pipes move and turn by any amount, with small strains, in statics and with every integrator "
     "but event; supports keep their directions"}};

} // namespace frictionbeam
