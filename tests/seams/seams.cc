// At a bend, a tee, a reducer and a rigid part, at their ends and in their middles, every kind of
// support shall hold the line as anywhere else, in statics, modes and transient steps: supports
// that never touch, with three and with six unknowns at every place, change nothing, and bends of
// many straight pieces, which need no arcs, give the same to their own error. The references are
// these other scenes. SPDX-License-Identifier: LGPL-2.1-or-later
//
// check_seams [all]: with `all` every kind of Rotations and Torsion at every place, else each kind
// of support at every place in one of these ways.
#include "command/line/run_line.h"

#include "base/user_error.h"
#include "results/file/output_file.h"
#include "scene/read_scene.h"

#include "../check.h"
#include "command/size_hangers.h"
#include "seam_scenes.h"

#include <deal.II/base/multithread_info.h>

#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

using namespace frictionbeam;
using namespace seams;

namespace {

class Solver {
public:
  Solver() {
    laws.load_builtin();
    folder = std::filesystem::temp_directory_path() / ("seams-" + std::to_string(getpid()));
    prepare_output_folder(folder);
  }
  ~Solver() { std::filesystem::remove_all(folder); }

  Results operator()(const std::string &text, const std::vector<std::string> &options = {}) {
    const std::string file = (folder / "scene.prm").string();
    std::ofstream(file) << text;
    Scene scene = read_scene(file, options, laws);
    scene.output.directory = folder;
    scene = with_sized_hangers(scene, laws);
    return solve_scene(scene, laws);
  }

private:
  LawLibrary laws;
  std::filesystem::path folder;
};

/// Every quantity as in the other run, within a part of the largest of its unit and step.
void compare(const std::string &what, const Results &a, const Results &b, const double tolerance,
             const double tolerance_of_kick, const bool sections = true) {
  CHECK(a.status == b.status);
  if (a.status != b.status) {
    for (const Results *results : {&a, &b})
      for (const StepReport &step : results->steps)
        std::cerr << what << ": step " << step.step << ": " << step.remark << '\n';
    return;
  }
  const auto group = [](const QuantityResult &q) {
    const auto last = q.name.rfind('_');
    return q.unit + (q.unit == "Hz" ? "" : q.name.substr(last)) +
           (q.unit == "Hz" ? q.name : std::string());
  };
  std::map<std::string, double> largest;
  for (const QuantityResult &q : a.quantities)
    largest[group(q)] = std::max(largest[group(q)], std::abs(q.value));
  double worst = 0.;
  std::string where;
  for (unsigned int i = 0; i < a.quantities.size(); ++i) {
    const QuantityResult &q = a.quantities[i];
    if (!sections && q.name.find("section_") == 0)
      continue; // in the axes of a cell, which is not the arc's
    const bool kick = q.name.find("_kick") != std::string::npos;
    const double error = std::abs(q.value - b.quantities[i].value) /
                         std::max(1e-300, largest[group(q)]) /
                         (kick ? tolerance_of_kick : tolerance);
    if (!(error <= worst)) {
      worst = error;
      std::ostringstream text;
      text << q.name << " = " << q.value << ", and " << b.quantities[i].value;
      where = text.str();
    }
  }
  ++check::n_checks;
  if (!(worst <= 1.)) {
    ++check::n_failures;
    std::cerr << what << ": " << worst << " times the tolerance: " << where << '\n';
  }
}

/// A stop with a stiffness is a spring, of whichever of its halves the force is: in a line at rest,
/// where both touch, and in a loaded one.
void stop_is_a_spring(Solver &solve, const Place &place, const std::string &ends) {
  const std::array<std::array<const char *, 2>, 3> directions = {
      {{{"1 0 0", "1e6 0 0"}}, {{"0 1 0", "0 1e6 0"}}, {{"0 0 1", "0 0 1e6"}}}};
  const std::string rest = "subsection Step still\nend\n";
  for (const auto &direction : directions)
    for (const char *step : {"still", "warm"}) {
      const auto run = [&](const std::string &holder) {
        return solve(line + held(place, {"", false, holder}, "") + rest + ends,
                     {std::string("Modes/Step = ") + step});
      };
      compare(std::string("stop along ") + direction[0] + " at " + place.point + ", modes of " +
                  step,
              run(std::string("subsection Spring held\n  set At = POINT\n  set Stiffness = ") +
                  direction[1] + "\nend\n"),
              run(support("held", std::string("  set Kind = stop\n  set Normal = ") + direction[0] +
                                      "\n  set Axial rigidity = 1e6\n")),
              1e-8, 1e-6);
    }
}

} // namespace

int main(int argc, char **argv) {
  const bool all = argc > 1 && std::string(argv[1]) == "all";
  const std::string only = argc > 2 ? argv[2] : "";
  dealii::MultithreadInfo::set_thread_limit(1);
  Solver solve;
  const std::string idle = idle_supports(), ends = loads + analyses + quantities();
  unsigned int turn = 0;
  for (const Holder &holder : holders)
    for (const Place &place : places) {
      if (holder.name == "nothing" && place.point != "P")
        continue;
      ++turn;
      for (unsigned int w = 0; w < (holder.is_element ? ways.size() : 1); ++w) {
        if (holder.is_element && !all && w != turn % ways.size())
          continue;
        const std::string what = holder.name + " at " + place.point + ", way " + std::to_string(w);
        if (!only.empty() && what.find(only) == std::string::npos)
          continue;
        const std::string text = line + held(place, holder, ways[w]);
        try {
          const Results run = solve(text + ends);
          CHECK(run.status == RunStatus::converged);
          compare(what + ", with idle supports", run, solve(text + idle + ends), holder.tolerance,
                  std::max(1e-6, holder.tolerance));
          compare(what + ", with bends of 40 pieces", run,
                  solve(text + ends, {"Mesh/Cells per bend = 40"}), 5e-3, 2e-2, false);
        } catch (const std::exception &error) {
          ++check::n_checks;
          ++check::n_failures;
          std::cerr << what << ": " << error.what() << '\n';
          if (!only.empty())
            std::cerr << text + ends;
        }
      }
    }
  for (const Place &place : places)
    if (only.empty() || only == "stop")
      stop_is_a_spring(solve, place, ends);
  return check::report();
}
