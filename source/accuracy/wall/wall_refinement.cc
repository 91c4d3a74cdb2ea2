// SPDX-License-Identifier: LGPL-2.1-or-later
#include "accuracy/wall/wall_refinement.h"

#include "accuracy/account_remarks.h"
#include "accuracy/convergence.h"
#include "accuracy/difference.h"
#include "base/processes.h"
#include "base/user_error.h"
#include "mesh/solid/wall_cells.h"
#include "results/file/csv_writer.h"
#include "results/file/vtu_writer.h"
#include "results/text.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace frictionbeam {

namespace {

constexpr unsigned int degree = 3, fewest_along_bend = 3, most_levels = 8;
constexpr double margin = 1.1;       ///< by which an estimate must be below what is demanded
constexpr double first_share = 0.25; ///< of what is demanded, if there is one change only
constexpr double early_share = 0.2;  ///< of what is demanded, for increments
constexpr double most_left = 0.3;    ///< of what is left along the pipe, in layers that are not cut
constexpr double worth_it = 0.2;     ///< of what is left, for one of the directions to be refined
/// Of the last change of a quantity, what is left at least: a mesh leaves no more than half of what
/// the one before left.
constexpr double least_left = 0.5;
/// From mesh to mesh, so that what they leave falls by three or more. Patches of supports end at
/// edges of cells of multiples of 12.
constexpr unsigned int cells_around[] = {8, 12, 16, 24, 32, 48, 64, 96, 128, 192},
                       with_patches[] = {12, 24, 36, 48, 72, 96, 144, 192};

bool counts(const Scene &scene) {
  return scene.quantities.size() > accuracy::left_out(scene).size();
}

class WallRefinement {
public:
  WallRefinement(const Scene &scene, const SolveWall &solve)
      : solve(solve), scene(scene), demanded(scene.accuracy) {
    if (scene.supports.empty())
      around.assign(std::begin(cells_around), std::end(cells_around));
    else
      around.assign(std::begin(with_patches), std::end(with_patches));
  }

  SolvedScene run(const RunOptions &options, const ReadScene &read, const SolveScene &solve_line);

private:
  void begin_coarse();
  /// As many as beams need. @return whether they reach their share
  bool choose_increments(const RunOptions &options, const ReadScene &read,
                         const SolveScene &solve_line);
  /// The coarse wall, and what half the increments change of it.
  Results solve_coarse();
  Results solve_once();
  /// Make the mesh finer where it leaves most. @return whether it may be as fine as that
  bool refine();
  std::vector<std::string> wall_settings() const;
  std::vector<std::string> settings() const;
  /// Settings with the layers of the mesh, and what it leaves.
  std::string of_mesh(const std::vector<std::string> &settings) const;
  double unknowns(const std::size_t n_layers, const unsigned int n_around) const;

  const SolveWall &solve;
  Scene scene;
  const double demanded;
  std::vector<unsigned int> around; ///< cells, from mesh to mesh
  std::size_t level = 0;            ///< of them
  WallMesh mesh;
  bool has_refined = false;        ///< in both directions, before either is believed
  double untouched = 0.;           ///< relative error by the direction that was not refined
  std::vector<std::string> chosen; ///< increments
  double of_increments = 0.;       ///< their error
  std::string limit;
  AccuracyAccount account;
};

void WallRefinement::begin_coarse() {
  SolidSettings &solid = scene.solid;
  const Section &section = scene.sections[scene.pipes.front().section];
  const double r_over_t = section.outer_radius / section.wall - 0.5;
  solid.degree = degree;
  solid.cells_per_bend = fewest_along_bend;
  if (solid.first_cell == 0.)
    solid.first_cell = 2. * section.wall * std::sqrt(r_over_t);
  const unsigned int enough = scene.has_bend() ? cells_around_for(demanded, r_over_t) : 0;
  while (level + 3 < around.size() && around[level + 2] < enough)
    ++level;
  solid.cells_around = around[level];
}

std::vector<std::string> WallRefinement::wall_settings() const {
  const SolidSettings &solid = scene.solid;
  return {"Solid/Degree = " + std::to_string(solid.degree),
          "Solid/Cells around = " + std::to_string(solid.cells_around),
          "Solid/Cells per bend = " + std::to_string(solid.cells_per_bend),
          "Solid/First cell = " + rounded_number(solid.first_cell / scene.units.factor("m"), 6)};
}

std::vector<std::string> WallRefinement::settings() const {
  std::vector<std::string> result = chosen;
  for (const std::string &setting : wall_settings())
    result.push_back(setting);
  return result;
}

std::string WallRefinement::of_mesh(const std::vector<std::string> &settings) const {
  return accuracy::settings_in_words(settings) + "; " + std::to_string(mesh.left.middles.size()) +
         " layers; left in energy: along " + rounded_number(mesh.left.all_along(), 2) +
         ", around " + rounded_number(mesh.left.around, 2);
}

Results WallRefinement::solve_once() {
  if (this_process() == 0)
    remove_frames(scene.output.directory); // of coarser meshes
  Results results = solve(scene, mesh);
  account.runs.push_back(
      {of_mesh(settings()), results.cost.seconds(), {}, results.status == RunStatus::converged});
  return results;
}

bool WallRefinement::choose_increments(const RunOptions &options, const ReadScene &read,
                                       const SolveScene &solve_line) {
  const auto as_line = [&](std::vector<std::string> settings) {
    settings.push_back("Model = line");
    Scene line = read(settings);
    line.model = ModelKind::line;
    line.accuracy = early_share * demanded;
    return line;
  };
  const AccuracyAccount line =
      *solve_to_accuracy(options, as_line({}), as_line, solve_line).results.accuracy;
  if (this_process() == 0)
    remove_line_tables(scene.output.directory);
  for (const std::string &setting : line.chosen)
    if (setting.rfind("Step ", 0) == 0)
      chosen.push_back(setting);
  const SolidSettings solid = scene.solid;
  scene = read(chosen);
  scene.solid = solid;
  of_increments = line.estimate;
  return line.reached;
}

Results WallRefinement::solve_coarse() {
  Scene half = scene;
  for (LoadStep &step : half.steps)
    step.n_increments = std::max(1u, step.n_increments / 2);
  const bool can_be_halved =
      std::any_of(scene.steps.begin(), scene.steps.end(),
                  [](const LoadStep &step) { return step.n_increments > 1; });
  if (scene.supports.empty() || !can_be_halved)
    return solve_once();
  const Results before = solve(half, mesh);
  Results results = solve_once();
  results.cost.add_work(before.cost);
  if (before.status == RunStatus::converged && results.status == RunStatus::converged) {
    const double change = accuracy::largest(accuracy::differences(scene, before, results)).value;
    account.runs.back().change = change;
    of_increments = std::max(of_increments, change); // of first order
  }
  return results;
}

double WallRefinement::unknowns(const std::size_t n_layers, const unsigned int n_around) const {
  const double p = degree, through = scene.solid.cells_through;
  return 3. * n_around * p * (through * p + 1.) * (n_layers * p + 1.);
}

bool WallRefinement::refine() {
  const double along = mesh.left.all_along(), of_around = mesh.left.around, all = along + of_around;
  untouched = 0.;
  std::vector<double> halved;
  if (along >= worth_it * all || !has_refined) {
    std::vector<std::size_t> order(mesh.left.along.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](const std::size_t i, const std::size_t j) {
      return mesh.left.along[i] > mesh.left.along[j];
    });
    double left = along;
    for (const std::size_t k : order) {
      if (left <= most_left * along)
        break;
      left -= mesh.left.along[k];
      halved.push_back(mesh.left.middles[k]);
    }
  } else
    untouched += along;
  std::size_t next = level;
  if (of_around >= worth_it * all || !has_refined)
    ++next;
  else
    untouched += of_around;
  if (next == around.size()) {
    limit = std::to_string(around.back()) + " cells around";
    return false;
  }
  const double wanted = unknowns(mesh.left.middles.size() + halved.size(), around[next]);
  if (wanted > scene.solid.most_unknowns) {
    limit = "Solid/Most unknowns = " + rounded_number(scene.solid.most_unknowns, 9) +
            ", for the next mesh would have " + rounded_number(wanted, 9);
    return false;
  }
  has_refined = true;
  mesh.halved.insert(mesh.halved.end(), halved.begin(), halved.end());
  level = next;
  scene.solid.cells_around = around[level];
  return true;
}

SolvedScene WallRefinement::run(const RunOptions &options, const ReadScene &read,
                                const SolveScene &solve_line) {
  begin_coarse();
  const bool increments_are_known =
      scene.supports.empty() || choose_increments(options, read, solve_line);
  Results results = solve_coarse();
  accuracy::Convergence convergence(scene.supports.empty() ? accuracy::Convergence::Order::regular
                                                           : accuracy::Convergence::Order::unknown);
  account.demanded = demanded;
  account.estimate = std::nan("");
  account.reached = false;
  for (unsigned int n = 1; results.status == RunStatus::converged && increments_are_known &&
                           !account.reached && n <= most_levels && refine();
       ++n) {
    Results finer = solve_once();
    finer.cost.add_work(results.cost);
    if (finer.status == RunStatus::converged) {
      const auto differences = accuracy::differences(scene, results, finer);
      const double change = accuracy::largest(differences).value;
      account.runs.back().change = change;
      convergence.add(n - 1, n, differences);
      account.estimate =
          of_increments + untouched + std::max(least_left * change, convergence.estimate());
      account.reached = margin * account.estimate <=
                        (convergence.knows_orders() ? demanded : first_share * demanded);
    }
    results = std::move(finer);
  }
  account.left_out = accuracy::left_out(scene);
  account.left_out.push_back(accuracy::left_out_of_walls());
  account.chosen = settings();
  account.chosen.push_back(std::to_string(mesh.left.middles.size()) + " layers along the pipes");
  if (!limit.empty())
    results.remarks.push_back("Cells were made finer up to " + limit + ".");
  if (!account.reached && results.status == RunStatus::converged)
    results.status = RunStatus::failed;
  accuracy::add_remarks({account, margin, false, "", {}}, results);
  results.accuracy = account;
  scene.accuracy = demanded;
  return {std::move(scene), std::move(results)};
}

} // namespace

SolvedScene refine_walls(const RunOptions &options, const Scene &scene, const ReadScene &read,
                         const SolveScene &solve_line, const SolveWall &solve) {
  if (!counts(scene))
    throw UserError(
        "A wall is refined until the quantities are known.\n  read:    Accuracy without "
        "Quantities that have an error\n  allowed: one or more with Model = solid\n  "
        "try:     set u = uz at a point, in section Quantities");
  return WallRefinement(scene, solve).run(options, read, solve_line);
}

} // namespace frictionbeam
