// SPDX-License-Identifier: LGPL-2.1-or-later
#include "command/run_body.h"

#include "analysis/refinement/estimate.h"
#include "base/interruption.h"
#include "base/user_error.h"
#include "results/body_results.h"
#include "results/file/body_vtu.h"
#include "results/file/checkpoint.h"
#include "results/text.h"

#include <deal.II/base/timer.h>

#include <algorithm>
#include <cmath>

namespace frictionbeam {

using namespace dealii;

namespace {

// Of the estimate of a quantity's error from its changes d by one mesh after the other.
constexpr double fastest = 1. / 3., slowest = 0.5; ///< ratios of changes that are believed
constexpr double least_by_chance = 1. / 16.;       ///< of the change before, that d is taken for
constexpr double share_of_first_change = 0.25; ///< of the tolerance, if there is one change only
constexpr double by_energy = 10.;    ///< relative error of a quantity by the squared one in energy
constexpr double least_share = 0.01; ///< of the largest quantity of its kind, that one counts for

/// The solution on one mesh, with what is asked of it.
template <int dim>
struct Solution {
  std::unique_ptr<ContinuumSequence<dim>> sequence;
  bool converged = false;
  std::vector<ContactRow> rows;
  ContinuumLevel level;
};

/// Whether the exact method can judge any contact: by its law's closed form.
bool contacts_are_judged(const ContinuumScene &scene, const LawLibrary &laws) {
  const auto has_closed_form = [&](const ContinuumContact &contact) {
    return BoundLaw(laws.find(contact.law), contact.parameters).has_closed_form();
  };
  return scene.contacts.empty() ||
         std::any_of(scene.contacts.begin(), scene.contacts.end(), has_closed_form);
}

template <int dim>
class AdaptiveRun {
public:
  AdaptiveRun(const Scene &scene, const LawLibrary &laws, Results &results)
      : scene(scene), laws(laws), results(results), mesh(build_continuum_mesh<dim>(scene)),
        body(scene, mesh), checkpoint(body) {
    results.cost.mesh_seconds = wall.wall_time();
    results.remarks.insert(results.remarks.end(), mesh.remarks.begin(), mesh.remarks.end());
  }

  void run();

private:
  /// On the present mesh.
  Solution<dim> solve(const ContinuumGuess *guess);
  /// What the meshes before leave to the present one, and the present one.
  void transfer(Archive &archive);
  /// Go back to the mesh of the checkpoint, if there is one; solve() goes on from its increment.
  void resume();
  /// After an increment: write a checkpoint if it is time, and end if a signal came.
  void pause(ContinuumSequence<dim> &sequence);
  /// Of all processes, put together by the first one.
  void write_checkpoint(ContinuumSequence<dim> &sequence);
  /// Of the cells of the present mesh, and in its row of the table.
  void estimate_errors(const ContinuumSequence<dim> &sequence);
  /// What changes of the quantities are relative to at least: a hundredth of the largest of their
  /// kind at the end of any step, of the ends of zones a hundredth of the body.
  std::vector<double> least_scales() const;
  /// Largest error of a quantity on the last of several meshes, estimated from its changes, which
  /// shall form a geometric series.
  double estimated_error() const;
  /// Status and remarks.
  /// @param limit that the refinement has stopped at, if any @param error as estimated, or nan
  void judge(const Solution<dim> &solution, const std::string &limit, const double error);
  void finish(const Solution<dim> &solution);

  const Scene &scene;
  const LawLibrary &laws;
  Results &results;
  const Timer wall;
  const ContinuumMesh<dim> mesh;
  ContinuumBody<dim> body;
  Checkpoint checkpoint;
  std::optional<Archive> saved; ///< of the sequence that solve() goes on with
  std::vector<ContinuumLevel> levels;
  std::vector<double> sizes;  ///< largest of each quantity at the ends of the steps, on this mesh
  double untouched = 0.;      ///< relative error by cells of the first mesh that are left
  double seconds_before = 0.; ///< of the runs that were cut
  dealii::Vector<float> estimate;
};

template <int dim>
Solution<dim> AdaptiveRun<dim>::solve(const ContinuumGuess *guess) {
  Solution<dim> solution;
  solution.sequence = std::make_unique<ContinuumSequence<dim>>(body, laws);
  ContinuumSequence<dim> &sequence = *solution.sequence;
  if (saved)
    sequence.transfer(*saved);
  saved.reset();
  solution.converged = sequence.run(guess, [&]() { pause(sequence); });
  ContinuumLevel &level = solution.level;
  level.quantities.resize(body.continuum.quantities.size());
  sizes.assign(level.quantities.size(), 0.);
  for (const ContinuumState &state : sequence.ends()) {
    const std::vector<ContactRow> rows = contact_rows(body, sequence.contacts(), state);
    solution.rows.insert(solution.rows.end(), rows.begin(), rows.end());
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      level.quantities[i] = evaluate_quantity(body, state, rows, body.continuum.quantities[i]);
      sizes[i] = std::max(sizes[i], std::abs(level.quantities[i]));
    }
  }
  for (std::size_t i = 0; i < level.quantities.size(); ++i)
    if (!std::isfinite(level.quantities[i]))
      throw UserError("Quantity " + body.continuum.quantities[i].name +
                      " is not a number.\n  read:    " + std::to_string(level.quantities[i]) +
                      "\n  allowed: loads, lengths and moduli whose products are numbers\n  try: "
                      "    looking for a value in the file that is far too large or too small");
  level.cells = body.triangulation->n_global_active_cells();
  level.unknowns = body.dof_handler.n_dofs();
  level.contacts =
      Utilities::MPI::sum(static_cast<unsigned int>(body.nodes.size()), body.communicator);
  for (const StepReport &report : sequence.reports()) {
    level.iterations += report.iterations;
    results.cost.iterations += report.iterations;
    results.cost.factorizations += report.factorizations;
  }
  level.seconds = seconds_before + wall.wall_time();
  return solution;
}

template <int dim>
void AdaptiveRun<dim>::transfer(Archive &archive) {
  double seconds = seconds_before + wall.wall_time();
  archive(body, levels, untouched, seconds, results.cost.iterations, results.cost.factorizations);
  if (archive.reads())
    seconds_before = seconds;
}

template <int dim>
void AdaptiveRun<dim>::resume() {
  std::optional<Archive> all = checkpoint.read();
  if (!all)
    return;
  std::vector<std::string> parts; // by process
  (*all)(parts);
  saved.emplace(parts[this_process(body.communicator)]);
  transfer(*saved);
}

template <int dim>
void AdaptiveRun<dim>::write_checkpoint(ContinuumSequence<dim> &sequence) {
  Archive own;
  transfer(own);
  sequence.transfer(own);
  std::vector<std::string> parts = Utilities::MPI::all_gather(body.communicator, own.bytes());
  Archive all;
  all(parts);
  if (this_process(body.communicator) == 0)
    checkpoint.write(all);
}

template <int dim>
void AdaptiveRun<dim>::pause(ContinuumSequence<dim> &sequence) {
  // Processes hear of signals and look at their clocks at different moments, but go on together.
  const int signal = Utilities::MPI::max(interruption::received(), body.communicator);
  const bool first_is_due = this_process(body.communicator) == 0 && checkpoint.is_due(),
             is_due = Utilities::MPI::max(static_cast<int>(first_is_due), body.communicator) > 0;
  if ((is_due || signal != 0) && scene.accuracy == 0.) // else there are many runs
    write_checkpoint(sequence);
  if (signal != 0)
    throw Interrupted(signal, "Interrupted at time " + rounded_number(sequence.time()) +
                                  " of step " + sequence.reports().back().step + ", on mesh " +
                                  std::to_string(levels.size() + 1) + ".");
}

template <int dim>
void AdaptiveRun<dim>::estimate_errors(const ContinuumSequence<dim> &sequence) {
  estimate = estimate_error(body, sequence.ends().back(), sequence.as_guess().traction);
  double sum = 0.;
  for (const auto &cell : body.triangulation->active_cell_iterators())
    if (cell->is_locally_owned())
      sum += estimate[cell->active_cell_index()];
  sum = Utilities::MPI::sum(sum, body.communicator);
  double stored = 0.;
  for (const StepReport &report : sequence.reports())
    stored += report.energy.stored;
  levels.back().estimate = stored > 0. ? std::sqrt(sum / (2. * stored)) : 0.;
}

template <int dim>
std::vector<double> AdaptiveRun<dim>::least_scales() const {
  const auto &quantities = body.continuum.quantities;
  const auto is_length = [](const ContinuumQuantity &quantity) {
    return row_of(body_quantity_kinds, quantity.kind).is_place;
  };
  double size = 0.;
  for (const Point<dim> &vertex : mesh.vertices)
    size = std::max(size, vertex.distance(mesh.vertices.front()));
  std::vector<double> result;
  for (const ContinuumQuantity &quantity : quantities) {
    double largest = is_length(quantity) ? size : 0.;
    for (std::size_t j = 0; j < quantities.size() && !is_length(quantity); ++j)
      if (unit_of(quantities[j]) == unit_of(quantity) && !is_length(quantities[j]))
        largest = std::max(largest, sizes[j]);
    result.push_back(least_share * largest);
  }
  return result;
}

template <int dim>
double AdaptiveRun<dim>::estimated_error() const {
  const std::size_t n = levels.size() - 1;
  const std::vector<double> least = least_scales();
  const auto change = [&](const std::size_t level, const std::size_t i) {
    const double now = levels[level].quantities[i], before = levels[level - 1].quantities[i];
    return now == before ? 0. : std::abs(now - before) / std::max(std::abs(now), least[i]);
  };
  double largest = 0.;
  for (std::size_t i = 0; i < levels[n].quantities.size(); ++i) {
    double d = change(n, i), ratio = slowest;
    if (n > 1 && d > 1e-11) {
      const double before = change(n - 1, i);
      d = std::max(d, before * least_by_chance);
      ratio = std::clamp(d / before, fastest, slowest);
    }
    const double error = d * ratio / (1. - ratio);
    if (!(error <= largest)) // nan counts as the largest
      largest = error;
  }
  return largest;
}

template <int dim>
void AdaptiveRun<dim>::run() {
  using Refinement = ContinuumSettings::Refinement;
  const ContinuumSettings &settings = scene.continuum_settings;
  if (settings.linear_solver == ContinuumSettings::LinearSolver::amg && !body.is_parallel)
    throw UserError(
        "Algebraic multigrid is Trilinos', and runs under mpirun only.\n  read:    "
        "Continuum/Linear solver = amg, without mpirun\n  allowed: auto, direct or multigrid, or "
        "with mpirun\n  try:     mpirun -np 1 frictionbeam ...");
  body.distribute();
  if (scene.output.resume)
    resume();
  Solution<dim> solution;
  ContinuumGuess guess;
  double error = std::nan("");
  bool reached = settings.refinement == Refinement::none;
  std::string limit;
  for (;;) {
    solution = solve(levels.empty() ? nullptr : &guess);
    levels.push_back(solution.level);
    if (levels.size() > 1) {
      error = std::max(estimated_error(), untouched);
      // Slip zones end where they will: one small change may be chance.
      reached = error <= (levels.size() == 2 ? share_of_first_change : 1.) * settings.tolerance;
    }
    if (!solution.converged || reached)
      break;
    if (levels.size() > settings.max_refinements)
      limit = "Max refinements = " + std::to_string(settings.max_refinements);
    else if (levels.back().unknowns > settings.max_unknowns)
      limit = "Max unknowns = " + std::to_string(settings.max_unknowns);
    if (!limit.empty())
      break;
    guess = solution.sequence->as_guess();
    estimate_errors(*solution.sequence);
    const double by_all = by_energy * *levels.back().estimate * *levels.back().estimate;
    untouched = by_all * refine(body, estimate,
                                settings.refinement == Refinement::uniform ? 1. : settings.fraction,
                                solution.sequence->ends().back(), guess);
  }
  judge(solution, limit, error);
  finish(solution);
  if (!std::isnan(error))
    results.certificate.push_back({"refinement", "-",
                                   "estimated error of the quantities, from their changes by the "
                                   "last refinements, relative",
                                   error});
}

template <int dim>
void AdaptiveRun<dim>::judge(const Solution<dim> &solution, const std::string &limit,
                             const double error) {
  const ContinuumSettings &settings = scene.continuum_settings;
  results.status = solution.converged && limit.empty()                  ? RunStatus::converged
                   : solution.sequence->reports().back().no_equilibrium ? RunStatus::no_equilibrium
                                                                        : RunStatus::failed;
  if (!limit.empty())
    results.remarks.push_back("The refinement stopped at Continuum/" + limit +
                              " before the quantities were known to Continuum/Tolerance = " +
                              rounded_number(settings.tolerance, 3) + ": the estimated error is " +
                              (std::isnan(error) ? "not known" : rounded_number(error, 2)) + ".");
}

template <int dim>
void AdaptiveRun<dim>::finish(const Solution<dim> &solution) {
  results.cost.solve_seconds = wall.wall_time() - results.cost.mesh_seconds;
  const ContinuumSequence<dim> &sequence = *solution.sequence;
  results.steps = sequence.reports();
  for (StepReport &step : results.steps)
    results.cost.steps += step.increments;
  results.certify(scene, contacts_are_judged(*scene.continuum, laws));
  results.cost.unknowns = levels.back().unknowns;
  results.known.time_step = {0., "there is no transient step"};
  results.cost.cells = levels.back().cells;
  results.cost.contacts = levels.back().contacts;
  results.method = std::string(scene.solver.is_exact()
                                   ? "exact: rigid contact and Coulomb friction by a semismooth "
                                     "Newton method"
                                   : "newton: consistent tangent of the return mapping") +
                   ", elements of degree " + std::to_string(body.fe.degree) + ", " +
                   sequence.linear_solver();
  for (unsigned int i = 0; i < body.continuum.quantities.size(); ++i) {
    const ContinuumQuantity &quantity = body.continuum.quantities[i];
    QuantityResult result{quantity.name,      unit_of(quantity),
                          quantity.source,    levels.back().quantities[i],
                          quantity.reference, {}};
    if (quantity.reference) {
      const double difference = std::abs(result.value - *quantity.reference);
      result.error =
          *quantity.reference != 0. ? difference / std::abs(*quantity.reference) : difference;
    }
    results.quantities.push_back(result);
  }
  const std::string &folder = scene.output.directory;
  if (scene.output.vtu)
    write_body_vtu<dim>(
        body, sequence.ends(), "continuum",
        [&](const ContinuumState &) { return stress_of_body(body); }, folder);
  if (scene.output.report)
    estimate_errors(sequence);
  if (this_process(body.communicator) > 0)
    return;
  write_contact_csv(scene, solution.rows, folder);
  write_convergence_csv(scene, levels, folder);
  if (scene.output.report) {
    results.sections.push_back({"refinement", "Refinement", convergence_table(scene, levels)});
    results.sections.push_back({"contact", "Contact", contact_charts(scene, solution.rows)});
  }
}

} // namespace

Results run_continuum(const Scene &scene, const LawLibrary &laws) {
  Results results;
  results.units = scene.units;
  if (scene.continuum->dimension == 2)
    AdaptiveRun<2>(scene, laws, results).run();
  else
    AdaptiveRun<3>(scene, laws, results).run();
  return results;
}

} // namespace frictionbeam
