// SPDX-License-Identifier: LGPL-2.1-or-later
#include "command/run_case.h"
#include "accuracy/accuracy_control.h"
#include "accuracy/hinge_refinement.h"
#include "accuracy/pipes/why_walls_differ.h"
#include "accuracy/wall/wall_refinement.h"
#include "command/line/friction_study.h"
#include "command/line/run_line.h"
#include "command/run_body.h"
#include "command/run_folder.h"
#include "command/size_hangers.h"
#include "command/solid/run_solid.h"

#include "base/interruption.h"
#include "base/peak_memory.h"
#include "base/processes.h"
#include "base/user_error.h"
#include "results/combination/governing_cases.h"
#include "results/combination/uplift.h"
#include "results/file/checkpoint.h"
#include "results/file/csv_writer.h"
#include "results/file/envelope_tables.h"
#include "results/file/output_file.h"
#include "results/file/summary.h"
#include "results/finite.h"
#include "results/how_well_known.h"
#include "results/listing/compliance.h"
#include "results/listing/hangers.h"
#include "results/listing/summary_in_words.h"
#include "results/page/both_models.h"
#include "results/page/html.h"
#include "results/report/report.h"
#include "results/report/report_modes.h"
#include "results/report/report_study.h"
#include "results/solid/line_and_solid.h"
#include "results/spectrum/modal_csv.h"
#include "results/stress/stresses.h"
#include "results/stress/wall_stress_table.h"
#include "results/table/model_tables.h"
#include "results/text.h"
#include "results/verdicts.h"
#include "scene/read_scene.h"

#include <deal.II/base/timer.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <iostream>
#include <memory>

namespace frictionbeam {

namespace {

/// Solve the scene as beams, and write everything but summary and report. Of several processes the
/// first one does it alone.
Results run_line(const Scene &scene, const LawLibrary &laws) {
  Results results;
  if (this_process() > 0) {
    results.status = RunStatus::converged;
    return results;
  }
  try {
    results = solve_scene(scene, laws);
  } catch (const UserError &error) {
    throw UserError(with_place(scene, error.what()));
  }
  if (n_processes() > 1)
    results.remarks.push_back("A line is solved by one process: the others have waited, and mpirun "
                              "does not pay.");
  study_friction(scene, laws, results);
  write_stresses(scene, results, scene.output.directory);
  write_compliance(scene, results, scene.output.directory);
  write_wall_stresses(scene, results, scene.output.directory);
  write_hangers(results, scene.output.directory);
  write_section_histories(scene, results, scene.output.directory);
  write_force_tables(scene, results, scene.output.directory);
  write_envelopes(scene, results, scene.output.directory);
  write_governing_cases(scene, results, scene.output.directory);
  write_uplift(scene, results, scene.output.directory);
  write_excitations(results, scene.output.directory);
  write_friction_study(results, scene.output.directory);
  return results;
}

/// For all processes, by one of them.
void prepare_folder(const std::string &folder) {
  if (this_process() == 0)
    prepare_output_folder(folder);
  if (n_processes() > 1)
    MPI_Barrier(MPI_COMM_WORLD);
}

/// Whether Accuracy chooses the load increments, which it does not of bodies.
bool has_chosen_increments(const Scene &scene, const Results &results) {
  return scene.model != ModelKind::continuum &&
         !(results.accuracy &&
           results.accuracy->model == row_of(model_kinds, ModelKind::continuum).word);
}

/// Write summary and report.
void conclude(const Scene &scene, Results &results, const dealii::Timer &wall) {
  refuse_not_finite(results);
  results.cost.peak_memory_mb = peak_memory_mb();
  results.cost.wall_seconds = wall.wall_time();
  if (this_process() > 0)
    return;
  const bool by_accuracy = has_chosen_increments(scene, results);
  include_accuracy(by_accuracy, results);
  if (scene.model != ModelKind::both) // each of which has said it
    add_remarks(results.known, by_accuracy, results);
  if (results.verdicts.empty()) // those of line and continuum together are there
    results.verdicts = verdicts_of(scene, results);
  write_modes(results, scene.output.directory);
  if (scene.output.report)
    write_report(scene, results, scene.output.directory);
  write_summary(scene, results, scene.output.directory); // the last: it says that all is there
}

/// One model of a scene of both.
using SolvePart = std::function<SolvedScene(const Scene &, const ModelKind)>;

/// Solve the scene as beams and as a continuum or solid pipes, each into a folder of its own.
Results run_both(const Scene &scene, const SolvePart &solve_part) {
  Results both, line;
  std::map<std::string, double> rounding; // by unit
  std::string reasons;
  both.status = RunStatus::converged;
  const ModelKind second = scene.is_solid() ? ModelKind::solid : ModelKind::continuum;
  const std::string other = row_of(model_kinds, second).word;
  for (const ModelKind kind : {ModelKind::line, second}) {
    const std::string model = row_of(model_kinds, kind).word;
    Scene part = scene;
    part.output.directory = scene.output.directory + "/" + model;
    prepare_folder(part.output.directory);
    const dealii::Timer wall;
    SolvedScene solved = solve_part(part, kind);
    part = std::move(solved.scene);
    Results results = std::move(solved.results);
    conclude(part, results, wall);
    if (this_process() == 0)
      print_summary(std::cout, part, results);
    include_model(both, results, model);
    if (model == "line")
      line = std::move(results);
    else if (scene.is_solid() && this_process() == 0) {
      both.sections.push_back({"forces", "Forces along the pipes and of supports",
                               line_and_solid(scene, line, results)});
      std::copy_if(results.sections.begin(), results.sections.end(),
                   std::back_inserter(both.sections),
                   [](const auto &section) { return section.id == "wall"; });
      write_line_and_solid(scene, line, results, scene.output.directory);
      rounding = rounding_of_forces(scene, line, results);
      for (const std::string &reason : accuracy::why_walls_differ(scene, line))
        reasons += html_note(reason);
    }
  }
  both.sections.insert(both.sections.begin(), {"models", "Line and " + other,
                                               side_by_side(both, other, rounding) + reasons});
  return both;
}

/// Where runs of a scene may leave checkpoints.
std::vector<std::string> folders_of_runs(const Scene &scene) {
  const std::string &folder = scene.output.directory;
  std::vector<std::string> folders = {folder, folder + "/line", folder + "/continuum",
                                      folder + "/solid"};
  for (const double multiplier : scene.friction_multipliers)
    folders.push_back(study_folder(folder, multiplier));
  return folders;
}

bool may_be_resumed(const Scene &scene) { return !scene.takes_many_runs(); }

void check_resumable(const Scene &scene) {
  if (!may_be_resumed(scene))
    throw UserError(
        "A run cannot be resumed here.\n  read:    --resume with an Accuracy or Refine hinges, "
        "which take many runs\n  allowed: --resume without them\n  try:     the run "
        "without --resume, from its beginning");
}

/// The scene of a file, as it will be solved.
Scene read_case(const RunOptions &options, const std::vector<std::string> &overrides,
                const std::string &folder, LawLibrary &laws) {
  Scene scene = read_scene(options.parameter_file, overrides, laws);
  scene.output.directory = RunFolder::work(folder);
  scene.output.resume = options.resume;
  scene.output.quiet = options.quiet;
  if (!scene.study.variations.empty())
    scene.remarks.push_back("The sections Study and Vary are for 'frictionbeam study', which runs "
                            "the case many times; here its entries are as they stand.");
  if (this_process() > 0)
    return scene; // a line is the first one's
  try {
    return with_sized_hangers(scene, laws);
  } catch (const UserError &error) {
    throw UserError(with_place(scene, error.what()));
  }
}

/// The solution of a scene, its files written into the folder of the scene's output.
SolvedScene solve(const RunOptions &options, LawLibrary &laws, const Scene &scene,
                  const std::string &folder, const dealii::Timer &wall) {
  const auto read = [&](const std::vector<std::string> &settings) {
    std::vector<std::string> overrides = options.overrides;
    overrides.insert(overrides.end(), settings.begin(), settings.end());
    return read_case(options, overrides, folder, laws);
  };
  const auto solve_line = [&](const Scene &line) { return run_line(line, laws); };
  const auto solve_wall = [&](const Scene &one, WallMesh &mesh) {
    return run_solid(one, laws, &mesh);
  };
  const auto solve_as = [&](const Scene &one, const ModelKind model) {
    return one.mesh.refine_hinges && model == ModelKind::line ? refine_hinges(one, solve_line)
           : model == ModelKind::line                         ? run_line(one, laws)
           : model == ModelKind::continuum                    ? run_continuum(one, laws)
                                                              : run_solid(one, laws);
  };
  const auto to_accuracy = [&](const Scene &one, const ReadScene &read_one) {
    return one.model == ModelKind::solid
               ? refine_walls(options, one, read_one, solve_line, solve_wall)
               : solve_to_accuracy(options, one, read_one, [&](const Scene &trial) {
                   return solve_as(trial, trial.model);
                 });
  };
  const auto solve_part = [&](const Scene &part, const ModelKind model) {
    const auto as_part = [&](Scene one) {
      one.model = model;
      one.output.directory = part.output.directory;
      return one;
    };
    const auto read_part = [&](const std::vector<std::string> &settings) {
      return as_part(read(settings));
    };
    return part.accuracy > 0. ? to_accuracy(as_part(part), read_part)
                              : SolvedScene{as_part(part), solve_as(part, model)};
  };
  const auto alone = [&]() { // a long scene is copied when its model is gone
    Results results =
        scene.model == ModelKind::both ? run_both(scene, solve_part) : solve_as(scene, scene.model);
    return SolvedScene{scene, std::move(results)};
  };
  SolvedScene solved =
      scene.model != ModelKind::both && scene.accuracy > 0. ? to_accuracy(scene, read) : alone();
  conclude(solved.scene, solved.results, wall);
  return solved;
}

/// Keep the folder for this run, on the first process.
std::unique_ptr<RunFolder> take_folder(const std::string &folder, const Scene &scene) {
  std::unique_ptr<RunFolder> run;
  if (this_process() == 0) {
    run = std::make_unique<RunFolder>(folder, scene.output.resume);
    const std::vector<std::string> folders = folders_of_runs(scene);
    if (scene.output.resume && std::none_of(folders.begin(), folders.end(), &Checkpoint::is_in))
      std::cout << "There is no checkpoint in " << folder << ": the run begins at its beginning.\n";
  }
  if (n_processes() > 1)
    MPI_Barrier(MPI_COMM_WORLD);
  return run;
}

} // namespace

int run_case(const RunOptions &options) {
  constexpr int checks_fail = 5; // exit status
  const dealii::Timer wall;
  LawLibrary laws;
  laws.load_builtin();
  const auto refuse_doubts = [&](const std::vector<std::string> &doubts, const std::string &when) {
    std::string text = "Hardly meant, " + when + ", and an error with --strict:";
    for (const std::string &doubt : doubts)
      text += "\n  " + doubt;
    if (options.strict && !doubts.empty())
      throw UserError(text);
  };
  const std::string folder =
      options.output_directory.empty()
          ? "output/" + std::filesystem::path(options.parameter_file).stem().string()
          : options.output_directory;
  const Scene scene = read_case(options, options.overrides, folder, laws);
  refuse_doubts(scene.doubts, "by what was read");
  if (options.resume)
    check_resumable(scene);
  const std::unique_ptr<RunFolder> run = take_folder(folder, scene);
  const auto with_what_is_whole = [&](const std::exception &error) {
    return error.what() + (run ? '\n' + run->what_is_whole(may_be_resumed(scene)) : "");
  };
  SolvedScene solved;
  try {
    solved = solve(options, laws, scene, folder, wall);
    if (n_processes() > 1)
      MPI_Barrier(MPI_COMM_WORLD); // all have written
    if (run) {
      for (const std::string &part : folders_of_runs(scene))
        Checkpoint::remove(part);
      run->publish();
    }
  } catch (const UserError &) {
    if (run && !options.resume)
      run->discard();
    throw;
  } catch (const OutputError &error) {
    throw OutputError(with_what_is_whole(error));
  } catch (const Interrupted &interrupted) {
    throw Interrupted(interrupted.signal, with_what_is_whole(interrupted));
  }
  if (this_process() == 0) {
    print_summary(std::cout, solved.scene, solved.results);
    std::cout << "Results are in " << folder
              << (solved.scene.output.report ? ", the report is report.html\n" : "\n");
  }
  if (solved.results.status != RunStatus::converged) {
    if (options.quiet && this_process() == 0)
      std::cerr << why_unsolved(solved.results, folder) << '\n';
    return 2;
  }
  refuse_doubts(solved.results.doubts, "by the results");
  return solved.scene.checks.decide_exit_status && any_fails(solved.results.verdicts) ? checks_fail
                                                                                      : 0;
}

} // namespace frictionbeam
