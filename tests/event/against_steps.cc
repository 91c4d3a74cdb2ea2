// SPDX-License-Identifier: LGPL-2.1-or-later
// Random moving scenes with friction on rigid rests, tilted ones among them, and on elastic
// supports: what moreau_jean finds with steps of h and h/8 shall come nearer to what event finds,
// to less than half of the difference, and near it; event's account of energy shall close to 1e-8,
// its slip along curves shall not be handed over, and its answer shall not depend on its step.
// With --moved, scenes whose ground and points are moved, and the work of friction as well: nearer
// by a factor of six or to 5e-3, and 1e-6 by the step.
//   against_steps PROGRAM FIRST NUMBER [--moved] [--show | --write] [OPEN SEED]...
// --write only writes the scenes, as SEED.prm.
#include "../cases/run_program.h"
#include "../check.h"
#include "random.h"

#include <algorithm>

namespace {

struct Scene {
  std::string text;
  std::vector<std::string> displacements, others; ///< quantities
};

void add_quantities(Scene &scene, const std::vector<std::string> &points,
                    const std::vector<std::string> &supports) {
  std::ostringstream out;
  out << "subsection Quantities\n";
  for (const std::string &point : points)
    for (const char *const component : {"ux", "uy", "uz"}) {
      scene.displacements.push_back(component + point);
      out << "  set " << component << point << " = " << component << " at " << point << '\n';
    }
  for (const std::string &support : supports) {
    scene.others.push_back("work" + support);
    out << "  set work" << support << " = work at " << support << '\n';
  }
  out << "end\n";
  scene.text += out.str();
}

void add_friction(std::ostringstream &out, Random &random, const bool lifts = true) {
  const double friction = random.number(0.1, 0.5);
  out << "  set Friction coefficient = " << friction << '\n';
  if (!random.chance(0.35))
    return;
  if (lifts)
    out << "  set Axial rigidity = " << random.number(2e3, 2e4) << '\n';
  out << "  set Shear rigidity = " << random.number(1e3, 1e4) << '\n';
}

/// The i-th point, with a mass. @return its name
std::string add_mass(std::ostringstream &out, Random &random, const int i) {
  const std::string number = std::to_string(i), at = "P" + number;
  out << "subsection Point " << at << "\n  set Position = " << i << " 0 0\nend\nsubsection Mass m"
      << number << "\n  set At = " << at << "\n  set Mass = " << random.number(0.5, 2.)
      << "\nend\n";
  return at;
}

/// Masses on springs, pressed onto rests.
Scene masses(Random &random) {
  Scene scene;
  std::ostringstream out;
  out << "set Free motions = ux, uy, uz\n";
  std::vector<std::string> points, supports;
  const int n = random.whole(1, 3);
  for (int i = 0; i < n; ++i) {
    const std::string number = std::to_string(i), at = add_mass(out, random, i);
    points.push_back(at);
    out << "subsection Spring k" << number << "\n  set At = " << at
        << "\n  set Stiffness = " << random.number(2., 12.) << ' ' << random.number(2., 12.) << ' '
        << random.number(5., 30.) << "\nend\n";
    if (i > 0)
      out << "subsection Spring between" << number << "\n  set At = " << at << "\n  set To = P"
          << i - 1 << "\n  set Stiffness = " << random.number(2., 8.) << ' '
          << random.number(2., 8.) << " 0\nend\n";
    if (i == 0 || random.chance(0.6)) {
      supports.push_back("c" + number);
      out << "subsection Support c" << number << "\n  set Kind = friction\n  set At = " << at
          << '\n';
      if (random.chance(0.5))
        out << "  set Normal = " << random.number(-0.3, 0.3) << ' ' << random.number(-0.3, 0.3)
            << " 1\n";
      add_friction(out, random);
      out << "end\n";
    }
    out << "subsection Initial i" << number << "\n  set At = " << at
        << "\n  set Velocity = " << random.number(-1.5, 1.5) << ' ' << random.number(-1.5, 1.5)
        << " 0\nend\nsubsection Load press" << number
        << "\n  set Kind = force\n  set Forces = " << at << " 0 0 " << -random.number(8., 16.)
        << "\nend\nsubsection Load pull" << number << "\n  set Kind = force\n  set Forces = " << at
        << ' ' << random.number(-4., 4.) << ' ' << random.number(-4., 4.) << ' '
        << random.number(-2., 2.) << "\n  set History = cos(" << random.number(0.5, 5.) << "*t + "
        << random.number(0., 3.) << ")\nend\n";
  }
  out << "subsection Step run\n  set Analysis = transient\n  set Duration = 1.5\n  set Loads = ";
  for (int i = 0; i < n; ++i)
    out << (i > 0 ? ", " : "") << "press" << i << ", pull" << i;
  out << "\nend\nsubsection Time\n  set Step = 0.004\nend\n";
  scene.text = out.str();
  add_quantities(scene, points, supports);
  return scene;
}

/// A pipe, clamped at one end, on rests, pulled about: normal forces depend on friction.
Scene pipe(Random &random) {
  Scene scene;
  std::ostringstream out;
  out << "subsection Material m\n  set Young's modulus = 2e11\n  set Density = 7850\nend\n"
         "subsection Section s\n  set Outer diameter = 0.06\n  set Wall = 0.003\nend\n"
         "subsection Pipe line\n  set Route = A 0 0 0; B 2 0 0; C 3.5 "
      << random.number(-1., 1.) << " 0\nend\nsubsection Mesh\n  set Cell length = 2\nend\n"
      << "subsection Support anchor\n  set Kind = anchor\n  set At = A\nend\n"
         "subsection Support rest\n  set Kind = rest\n  set At = "
      << (random.chance(0.5) ? "B" : "C") << '\n';
  add_friction(out, random);
  out << "end\nsubsection Load weight\n  set Kind = weight\nend\nsubsection Load pull\n"
         "  set Kind = force\n  set Forces = C "
      << random.number(-30., 30.) << ' ' << random.number(-60., 60.) << ' '
      << random.number(-20., 0.) << "\n  set History = sin(" << random.number(10., 40.)
      << "*t)\nend\nsubsection Step carry\n  set Loads = weight\n  set Increments = 1\nend\n"
         "subsection Step run\n  set Analysis = transient\n  set Duration = 0.15\n"
         "  set Loads = weight, pull\nend\nsubsection Time\n  set Step = 4e-4\nend\n";
  scene.text = out.str();
  add_quantities(scene, {"B", "C"}, {"rest"});
  return scene;
}

std::string history(Random &random) {
  std::ostringstream out;
  const double a = random.number(-0.5, 0.5), w = random.number(2., 12.);
  switch (random.whole(0, 4)) {
  case 0:
    out << a << "*sin(" << w << "*t)";
    break;
  case 1:
    out << a << "*(1 - cos(" << w << "*t))";
    break;
  case 2:
    out << a << "*t^2";
    break;
  case 3:
    out << a << "*t^3";
    break;
  default: // corners, and stops
    double t = 0., x = 0.;
    out << "table 0 0";
    while (t < 1.) {
      t += random.number(0.1, 0.4);
      x += random.chance(0.3) ? 0. : random.number(-0.3, 0.3);
      out << ", " << t << ' ' << x;
    }
  }
  return out.str();
}

/// Masses on rests whose ground moves, on plates that are moved, and moved themselves: in all
/// directions, in some, or pressed between two that move apart.
Scene moved(Random &random) {
  Scene scene;
  std::ostringstream out;
  out << "set Free motions = ux, uy, uz\n";
  std::vector<std::string> points, supports, loads;
  const int n = random.whole(1, 2);
  for (int i = 0; i < n; ++i) {
    const std::string number = std::to_string(i), at = add_mass(out, random, i);
    points.push_back(at);
    if (i > 0)
      out << "subsection Spring between" << number << "\n  set At = " << at << "\n  set To = P"
          << i - 1 << "\n  set Stiffness = " << random.number(20., 80.) << ' '
          << random.number(20., 80.) << " 0\nend\n";
    if (random.chance(0.5))
      out << "subsection Spring k" << number << "\n  set At = " << at
          << "\n  set Stiffness = " << random.number(2., 50.) << ' ' << random.number(2., 50.)
          << " 0\nend\n";
    const bool on_plate = random.chance(0.4);
    if (on_plate) {
      out << "subsection Point Q" << number << "\n  set Position = " << i
          << " 0 -1\nend\nsubsection Load plate" << number
          << "\n  set Kind = displacement\n  set Displacements = Q" << number << " ux "
          << random.number(-1., 1.) << "; Q" << number << " uy "
          << (random.chance(0.5) ? 0. : random.number(-1., 1.)) << "; Q" << number
          << " uz 0\n  set History = " << history(random) << "\nend\n";
      loads.push_back("plate" + number);
    }
    supports.push_back("c" + number);
    out << "subsection Support c" << number << "\n  set Kind = friction\n  set At = " << at << '\n';
    if (on_plate)
      out << "  set Ground = Q" << number << '\n';
    else if (random.chance(0.4))
      out << "  set Ground motion = " << history(random) << "; "
          << (random.chance(0.5) ? "0" : history(random)) << "; 0\n";
    add_friction(out, random, false);
    out << "end\n";
    if (random.chance(0.4)) {
      supports.push_back("d" + number);
      out << "subsection Support d" << number << "\n  set Kind = friction\n  set At = " << at
          << "\n  set Normal force = " << random.number(2., 10.) << '\n';
      add_friction(out, random, false);
      out << "end\n";
    }
    out << "subsection Load press" << number << "\n  set Kind = force\n  set Forces = " << at
        << " 0 0 " << -random.number(12., 20.) << "\nend\n";
    loads.push_back("press" + number);
    if (random.chance(0.5)) {
      out << "subsection Load push" << number << "\n  set Kind = force\n  set Forces = " << at
          << ' ' << random.number(-6., 6.) << ' ' << random.number(-6., 6.)
          << " 0\n  set History = " << history(random) << "\nend\n";
      loads.push_back("push" + number);
    }
    if (random.chance(0.5)) {
      out << "subsection Load move" << number
          << "\n  set Kind = displacement\n  set Displacements = " << at << " ux "
          << random.number(0.5, 1.);
      if (random.chance(0.5))
        out << "; " << at << " uy " << random.number(-1., 1.);
      out << "\n  set History = " << history(random) << "\nend\n";
      loads.push_back("move" + number);
    }
  }
  out << "subsection Step run\n  set Analysis = transient\n  set Duration = 1.2\n  set Loads = ";
  for (std::size_t i = 0; i < loads.size(); ++i)
    out << (i > 0 ? ", " : "") << loads[i];
  out << "\nend\n";
  scene.text = out.str();
  add_quantities(scene, points, supports);
  return scene;
}

/// Displacements and works below which nothing happens [m], [J].
constexpr double nothing = 1e-6;

Scene scene_of(const unsigned int seed, const bool is_moved) {
  Random random(seed);
  return is_moved ? moved(random) : seed % 3 == 0 ? pipe(random) : masses(random);
}

void compare(const std::string &program, const unsigned int seed, const bool shows,
             const bool is_moved) {
  const Scene scene = scene_of(seed, is_moved);
  const program::TemporaryFolder folder;
  const std::string file = (folder.path / "scene.prm").string();
  std::ofstream(file) << scene.text
                      << "subsection Output\n  set VTU = false\n  set Report = false\nend\n";
  const bool is_pipe = !is_moved && seed % 3 == 0;
  const std::string step = is_pipe ? "4e-4" : "4e-3", fine_step = is_pipe ? "5e-5" : "5e-4",
                    other_step = is_pipe ? "7.3e-3" : "7.3e-2";
  const auto run = [&](const std::string &integrator, const std::string &h) {
    return program::run(program, file,
                        {"--set", "Time/Integrator = " + integrator, "--set", "Time/Step = " + h},
                        folder.path / (integrator + h));
  };
  const program::Run exact = run("event", step), again = run("event", other_step),
                     coarse = run("moreau_jean", step), fine = run("moreau_jean", fine_step);
  for (const program::Run *const r : {&exact, &again, &coarse, &fine})
    if (r->exit_status != 0) {
      std::cerr << "seed " << seed << ":\n" << r->output << '\n' << scene.text;
      CHECK(false);
      return;
    }
  const bool handed_over =
      program::text_of(folder.path / ("event" + step) / "summary.json").find("handed over to") !=
      std::string::npos;
  double at_coarse = 0., at_fine = 0., by_step = 0.; // of the largest
  const auto take = [&](const std::vector<std::string> &names) {
    double largest = nothing;
    for (const std::string &name : names)
      largest = std::max(largest, std::abs(exact[name]));
    for (const std::string &name : names) {
      at_coarse = std::max(at_coarse, std::abs(coarse[name] - exact[name]) / largest);
      at_fine = std::max(at_fine, std::abs(fine[name] - exact[name]) / largest);
      by_step = std::max(by_step, std::abs(again[name] - exact[name]) / largest);
    }
  };
  take(scene.displacements);
  if (is_moved)
    take(scene.others);
  const double imbalance = // without one if nothing has any
      exact.energy.empty() ? 0. : std::abs(exact.energy.at("imbalance"));
  if (shows)
    std::cout << "seed " << seed << ": moreau_jean " << at_coarse << ", " << at_fine
              << "; other step " << by_step << "; imbalance " << imbalance
              << (handed_over ? "; handed over" : "") << ", " << exact.wall_seconds << " s\n"
              << std::flush;
  const int failures = check::n_failures;
  CHECK(at_fine <= std::max(0.5 * at_coarse, 1e-6));
  CHECK(at_fine <= (is_moved ? std::max(5e-3, at_coarse / 6.) : 5e-3));
  CHECK(by_step <= (is_moved ? 1e-6 : 1e-8));
  CHECK(imbalance <= 1e-8);
  CHECK(!handed_over);
  if (check::n_failures > failures)
    std::cerr << "seed " << seed << ": differences of moreau_jean with " << step << " and "
              << fine_step << " s: " << at_coarse << ", " << at_fine << '\n';
}

} // namespace

int main(int argc, char **argv) {
  const unsigned int first = std::stoul(argv[2]), number = std::stoul(argv[3]);
  bool shows = false, is_moved = false, only_writes = false;
  std::vector<unsigned int> open;
  for (int i = 4; i < argc; ++i)
    if (std::string(argv[i]) == "--show")
      shows = true;
    else if (std::string(argv[i]) == "--write")
      only_writes = true;
    else if (std::string(argv[i]) == "--moved")
      is_moved = true;
    else
      open.push_back(std::stoul(argv[i]));
  for (unsigned int seed = first; seed < first + number; ++seed) {
    if (only_writes) {
      std::ofstream(std::to_string(seed) + ".prm") << scene_of(seed, is_moved).text;
      continue;
    }
    const int failures = check::n_failures;
    compare(argv[1], seed, shows, is_moved);
    if (std::find(open.begin(), open.end(), seed) != open.end()) {
      std::cout << "seed " << seed << " is open: "
                << (check::n_failures > failures ? "it differs" : "it does not differ") << '\n';
      check::n_failures = failures;
    }
  }
  return check::report();
}
