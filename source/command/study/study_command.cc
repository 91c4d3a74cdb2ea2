// SPDX-License-Identifier: LGPL-2.1-or-later
#include "command/study/study_command.h"

#include "command/run_folder.h"
#include "command/size_hangers.h"
#include "command/study/study_runs.h"

#include "base/file_bytes.h"
#include "base/interruption.h"
#include "base/processes.h"
#include "base/user_error.h"
#include "results/file/summary.h"
#include "results/remarks.h"
#include "results/text.h"
#include "scene/read_scene.h"
#include "scene/solid/mixed_entries.h"
#include "scene/support_pair.h"
#include "study/design.h"
#include "study/study_files.h"
#include "study/study_report.h"

#include <deal.II/base/timer.h>

#include <algorithm>
#include <filesystem>
#include <future>
#include <iostream>
#include <set>
#include <thread>

namespace frictionbeam::study {

namespace {

void check_scene(const Scene &scene) {
  const auto refuse = [](const std::string &read, const std::string &allowed,
                         const std::string &hint) {
    throw UserError("There is no study of this case.\n  read:    " + read +
                    "\n  allowed: " + allowed + "\n  try:     " + hint);
  };
  if (scene.study.variations.empty())
    refuse("no section 'Vary <name>'", "at least one, with an Entry and its Values or Distribution",
           "prm/example/study_rack.prm, which includes a case and says what varies in it");
  if (!solid_places(scene).empty())
    refuse("At in section Solid", "lines without solid parts, which the runs would leave out",
           "removing At, and the Bend flexibility that the solid bend has");
  if (scene.model != ModelKind::line)
    refuse("Model = " + std::string(row_of(model_kinds, scene.model).word), "Model = line",
           "--set \"Model = line\"");
  if (scene.takes_many_runs())
    refuse("Accuracy or Mesh/Refine hinges, which take many runs of the case each time",
           "a mesh, increments and time step that are given",
           "the settings that a run with Accuracy has chosen; its report says them");
  if (!scene.friction_multipliers.empty())
    refuse("Friction multipliers, a study of its own", "sections Vary",
           "a section Vary with Entry = Support */Friction coefficient, Meaning = factor and the "
           "multipliers for its Values");
}

/// Whether the entries of all variables are among these, and all their values are numbers.
template <typename Fits>
bool all_entries(const Variables &variables, const Fits &fits) {
  for (std::size_t i = 0; i < variables.size(); ++i) {
    for (const std::string &value : variables.variation(i).values)
      if (double number = 0.; !to_number(value, number))
        return false;
    for (const VariedEntry &entry : variables[i].entries)
      if (!fits(entry.path.substr(0, entry.path.find(' ')),
                entry.path.substr(entry.path.find('/') + 1)))
        return false;
  }
  return true;
}

const std::set<std::string> contact_numbers = {"Friction coefficient",
                                               "Dynamic friction coefficient", "Gap"};

/// What the runs may share, by the entries that vary.
void find_what_is_shared(const Variables &variables, StudyCase &of) {
  of.varies_laws = all_entries(variables, [](const std::string &kind, const std::string &entry) {
    return kind == "Support" && contact_numbers.count(entry) > 0;
  });
}

/// Number of places of each support with a law, from the names that they have in results.
PlacesOfSupports places_of(const Scene &scene, const Results &results) {
  PlacesOfSupports places;
  for (const FrictionSupport &support : scene.supports) {
    places[part_name(support)] = std::count_if(
        results.supports.begin(), results.supports.end(),
        [&](const SupportInfo &info) { return is_place_of(info.name, support.name); });
  }
  return places;
}

unsigned int threads_of(const StudySettings &settings) {
  if (n_processes() > 1) {
    if (settings.n_threads > 1)
      throw UserError(
          "Under mpirun each process takes one run at a time.\n  read:    Study/Threads "
          "= " +
          std::to_string(settings.n_threads) +
          "\n  allowed: 0 or 1\n  try:     mpirun -np N with as many processes as there "
          "shall be runs at the same time");
    return 1;
  }
  return settings.n_threads > 0 ? settings.n_threads
                                : std::max(1u, std::thread::hardware_concurrency());
}

/// All runs, none of them done.
StudyResults make_runs(const StudyCase &of, const Variables &variables, const Sampling &sampling) {
  StudyResults study;
  study.settings = of.scene.study;
  study.units = of.scene.units;
  study.n_processes = n_processes();
  study.n_threads = threads_of(study.settings);
  study.design = make_design(study.settings, variables, sampling);
  for (std::size_t i = 0; i < variables.size(); ++i) {
    study.variables.push_back(variables[i].name);
    study.described.push_back(in_words(variables.variation(i)));
  }
  study.ranges = morris_ranges(variables);
  for (const std::vector<double> &point : study.design) {
    std::vector<double> &values = study.values.emplace_back();
    std::vector<std::string> &texts = study.texts.emplace_back();
    for (std::size_t i = 0; i < variables.size(); ++i) {
      values.push_back(variables.value(i, point[i]));
      texts.push_back(variables.text(i, point[i]));
    }
  }
  study.runs.resize(study.design.size());
  study.names = of.names;
  return study;
}

/// All that the numbers of a study depend on: files that the parameter file names by what they make
/// of the case as it stands, those among the values that vary by their bytes.
std::string identity_of(const StudyCase &of, const std::vector<double> &nominal) {
  std::string text = program_version() + '\n' + of.scene.input;
  for (const std::string &setting : of.options.overrides)
    text += '\n' + setting;
  for (const double number : nominal)
    text += '\n' + exact_number(number);
  const std::filesystem::path folder =
      std::filesystem::path(of.options.parameter_file).parent_path();
  for (const Variation &variation : of.scene.study.variations)
    for (const std::string &value : variation.values)
      for (const std::string &word : split(value, ' ')) // 'file heat.csv'
        if (std::error_code no_file; std::filesystem::is_regular_file(folder / word, no_file))
          text += '\n' + file_bytes((folder / word).string());
  for (const ResultName &name : of.names)
    text += '\n' + column_name(name);
  return text;
}

void add_remarks(const StudyCase &of, const Variables &variables, StudyResults &study) {
  if (const auto &names = variables.without_friction(); !names.empty())
    study.remarks.push_back(
        "A star gives no friction to supports that have none in the case, as rods, whose Friction "
        "coefficient is 0: " +
        first_of({names.begin(), names.end()}) + ". Named one by one, they may vary.");
  std::string hangers;
  for (const Hanger &hanger : of.scene.hangers)
    if (hanger.cold_load == 0.)
      hangers += (hangers.empty() ? "" : ", ") + hanger.name;
  if (!hangers.empty())
    study.remarks.push_back("Hangers are built once: " + hangers +
                            " has in all runs the loads and stiffness that were chosen for the "
                            "case as it stands.");
  std::vector<std::string> without_value;
  for (const Quantity &quantity : of.scene.quantities)
    if (std::none_of(study.names.begin(), study.names.end(), [&](const ResultName &name) {
          return name.of == ResultName::Of::quantity && name.name == quantity.name;
        }))
      without_value.push_back(quantity.name);
  if (!without_value.empty())
    study.remarks.push_back(
        "Quantities that have no value in the case as it stands are left out: " +
        first_of(without_value) + ". A run of the case says why.");
  const std::size_t n_lost = study.runs.size() - study.count(Outcome::converged);
  if (n_lost > 0)
    study.remarks.push_back(
        std::to_string(n_lost) + " of " + std::to_string(study.runs.size()) +
        " runs have no answer; they are listed below, and in runs.csv. Quantiles and sensitivities "
        "are of the others: where runs fail, the results have no number, and may be anything.");
  if (!study.settings.row().is_a_sample)
    study.remarks.push_back(
        std::string("The runs of Method = ") + study.settings.row().word +
        " are no sample of the variables' distributions: quantiles are those of the runs, and no "
        "probabilities.");
}

void print(const StudyResults &study, const std::string &folder) {
  std::cout << study.runs.size() << " runs of " << study.variables.size()
            << (study.variables.size() == 1 ? " variable in " : " variables in ")
            << rounded_number(study.seconds, 3) << " s";
  if (study.n_resumed > 0)
    std::cout << ", " << study.n_resumed << " of them earlier";
  std::cout << '\n';
  for (const auto &row : outcomes)
    if (const std::size_t n = study.count(row.value); n > 0)
      std::cout << row.word << ": " << n << '\n';
  for (const std::string &remark : study.remarks)
    std::cout << "Note: " << remark << '\n';
  std::cout << "Results are in " << folder << ", the report is report.html\n";
}

/// The case as it stands, which every run is like. @throws UserError if it has no answer
Results solve_nominal(const StudyCase &of, const LawLibrary &laws) {
  Scene scene = of.scene;
  scene.output.directory.clear();
  scene.output.contact_problems = scene.output.resume = scene.output.every_increment = false;
  scene.output.quiet = true;
  Results results = solve_variant(of, scene, laws);
  if (results.status != RunStatus::converged)
    throw UserError("The case has no answer with its entries as they stand.\n  read:    status " +
                    status_word(results.status) + ", " + results.steps.back().remark +
                    "\n  allowed: a case that converges, which the runs of a study are like\n"
                    "  try:     frictionbeam " +
                    of.options.parameter_file + ", and what it says");
  return results;
}

/// Run what is pending, and write the results of all. By the first process: the others only run.
void run_study(const StudyCase &of, const Variables &variables, const Sampling &sampling,
               const Results &nominal, const std::string &work, StudyResults &study) {
  const dealii::Timer wall;
  RunJournal journal(work, identity_of(of, study.nominal));
  if (this_process() == 0 && of.options.resume)
    study.n_resumed = journal.read(study);
  solve_runs(of, variables, journal, study);
  if (this_process() > 0)
    return;
  study.seconds = wall.wall_time();
  add_remarks(of, variables, study);
  const std::vector<Sensitivity> effects = sensitivities(study, sampling);
  write_study_files(study, effects, of.scene.name, work);
  write_study_report(study, effects, of.scene, nominal, work);
  journal.clear();
}

} // namespace

int study_command(const RunOptions &options) {
  LawLibrary laws;
  laws.load_builtin();
  StudyCase of;
  of.options = options;
  of.scene = read_scene(options.parameter_file, options.overrides, laws);
  check_scene(of.scene);
  // Its many libraries are opened while the case is solved, whose own are open by now.
  std::future<const Sampling *> opening =
      std::async(std::launch::async, []() { return &load_sampling(); });
  of.scene = with_sized_hangers(of.scene, laws);
  const Results nominal = solve_nominal(of, laws);
  const Sampling &sampling = *opening.get();
  of.names = names_of(nominal);
  ParameterFile file(options.parameter_file);
  for (const std::string &setting : options.overrides)
    file.apply(setting);
  const Variables variables(of.scene, file, laws, places_of(of.scene, nominal), sampling);
  variables.check(
      [&](const std::vector<std::string> &settings) { read_variant(of, settings, laws); },
      of.scene.study.method);
  find_what_is_shared(variables, of);
  StudyResults study = make_runs(of, variables, sampling);
  study.nominal = numbers_of(nominal);
  for (const Variation &variation : of.scene.study.variations)
    if (const auto *const section = file.find("Vary " + variation.name);
        study.settings.method != StudyMethod::factorial && section && section->find("Levels"))
      study.remarks.push_back("Vary " + variation.name + ": its Levels are of Method = factorial " +
                              "and are not used with " + study.settings.row().word + ".");

  const std::string folder =
      options.output_directory.empty()
          ? "output/" + std::filesystem::path(options.parameter_file).stem().string()
          : options.output_directory;
  std::unique_ptr<RunFolder> run;
  if (this_process() == 0)
    run = std::make_unique<RunFolder>(folder, options.resume);
  if (n_processes() > 1)
    MPI_Barrier(MPI_COMM_WORLD);
  try {
    run_study(of, variables, sampling, nominal, RunFolder::work(folder), study);
  } catch (const Interrupted &interrupted) {
    throw Interrupted(interrupted.signal,
                      interrupted.what() + std::string("\nThe same command with --resume goes "
                                                       "on from there."));
  }
  if (run) {
    run->publish();
    print(study, folder);
  }
  int status = study.count(Outcome::error) > 0                        ? 3
               : study.count(Outcome::converged) == study.runs.size() ? 0
                                                                      : 2;
  if (n_processes() > 1) // the first process knows all runs
    status = dealii::Utilities::MPI::broadcast(MPI_COMM_WORLD, status);
  return status;
}

} // namespace frictionbeam::study
