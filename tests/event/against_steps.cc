// SPDX-License-Identifier: LGPL-2.1-or-later
// Random moving scenes with friction on rigid rests, tilted ones among them, and on elastic
// supports: what moreau_jean finds with steps of h and h/8 shall come nearer to what event finds,
// to less than half of the difference, and near it; event's account of energy shall close to 1e-8,
// its slip along curves shall not be handed over, and its answer shall not depend on its step.
//   against_steps PROGRAM FIRST NUMBER [--show] [OPEN SEED]...
#include "../cases/run_program.h"
#include "../check.h"

#include <algorithm>
#include <random>

namespace {

class Random {
public:
  explicit Random(const unsigned int seed) : engine(seed * 7919u + 13u) {}
  /// The same on every machine.
  double number(const double low, const double high) {
    return low + (high - low) * static_cast<double>(engine() >> 11) / 9007199254740992.;
  }
  int whole(const int low, const int high) {
    return low + static_cast<int>(engine() % static_cast<unsigned long>(high - low + 1));
  }
  bool chance(const double p) { return number(0., 1.) < p; }

private:
  std::mt19937_64 engine;
};

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

void add_friction(std::ostringstream &out, Random &random) {
  const double friction = random.number(0.1, 0.5);
  out << "  set Friction coefficient = " << friction << '\n';
  if (random.chance(0.35)) // elastic
    out << "  set Axial rigidity = " << random.number(2e3, 2e4)
        << "\n  set Shear rigidity = " << random.number(1e3, 1e4) << '\n';
}

/// Masses on springs, pressed onto rests.
Scene masses(Random &random) {
  Scene scene;
  std::ostringstream out;
  out << "set Free motions = ux, uy, uz\n";
  std::vector<std::string> points, supports;
  const int n = random.whole(1, 3);
  for (int i = 0; i < n; ++i) {
    const std::string number = std::to_string(i), at = "P" + number;
    points.push_back(at);
    out << "subsection Point " << at << "\n  set Position = " << i << " 0 0\nend\nsubsection Mass m"
        << number << "\n  set At = " << at << "\n  set Mass = " << random.number(0.5, 2.)
        << "\nend\nsubsection Spring k" << number << "\n  set At = " << at
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

void compare(const std::string &program, const unsigned int seed, const bool shows) {
  Random random(seed);
  const Scene scene = seed % 3 == 0 ? pipe(random) : masses(random);
  const program::TemporaryFolder folder;
  const std::string file = (folder.path / "scene.prm").string();
  std::ofstream(file) << scene.text
                      << "subsection Output\n  set VTU = false\n  set Report = false\nend\n";
  const std::string step = seed % 3 == 0 ? "4e-4" : "4e-3",
                    fine_step = seed % 3 == 0 ? "5e-5" : "5e-4",
                    other_step = seed % 3 == 0 ? "7.3e-3" : "7.3e-2";
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
  double largest = 0., at_coarse = 0., at_fine = 0., by_step = 0.;
  for (const std::string &name : scene.displacements) {
    largest = std::max(largest, std::abs(exact[name]));
    at_coarse = std::max(at_coarse, std::abs(coarse[name] - exact[name]));
    at_fine = std::max(at_fine, std::abs(fine[name] - exact[name]));
    by_step = std::max(by_step, std::abs(again[name] - exact[name]));
  }
  if (shows)
    std::cout << "seed " << seed << ": moreau_jean " << at_coarse / largest << ", "
              << at_fine / largest << "; other step " << by_step / largest << "; imbalance "
              << exact.energy.at("imbalance") << (handed_over ? "; handed over" : "") << ", "
              << exact.wall_seconds << " s\n"
              << std::flush;
  const int failures = check::n_failures;
  CHECK(at_fine <= std::max(0.5 * at_coarse, 1e-6 * largest));
  CHECK(at_fine <= 5e-3 * largest);
  CHECK(by_step <= 1e-8 * largest);
  CHECK(std::abs(exact.energy.at("imbalance")) <= 1e-8);
  CHECK(!handed_over);
  if (check::n_failures > failures)
    std::cerr << "seed " << seed << ": differences of moreau_jean with " << step << " and "
              << fine_step << " s: " << at_coarse << ", " << at_fine << " m of " << largest
              << " m\n";
}

} // namespace

int main(int argc, char **argv) {
  const unsigned int first = std::stoul(argv[2]), number = std::stoul(argv[3]);
  bool shows = false;
  std::vector<unsigned int> open;
  for (int i = 4; i < argc; ++i)
    if (std::string(argv[i]) == "--show")
      shows = true;
    else
      open.push_back(std::stoul(argv[i]));
  for (unsigned int seed = first; seed < first + number; ++seed) {
    const int failures = check::n_failures;
    compare(argv[1], seed, shows);
    if (std::find(open.begin(), open.end(), seed) != open.end()) {
      std::cout << "seed " << seed << " is open: "
                << (check::n_failures > failures ? "it differs" : "it does not differ") << '\n';
      check::n_failures = failures;
    }
  }
  return check::report();
}
