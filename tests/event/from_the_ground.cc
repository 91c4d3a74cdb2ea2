// SPDX-License-Identifier: LGPL-2.1-or-later
// A random line on rests and guides whose ends and grounds all move alike, against the same line
// seen from the ground, where its inertia is a load: behind a static step, with event, forces of
// supports, wear and instants of slip shall be the same to 1e-6.
//   from_the_ground PROGRAM FIRST NUMBER [--show] [OPEN SEED]...
#include "../cases/run_program.h"
#include "../check.h"
#include "random.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace {

/// A motion that begins from rest and its second derivative, formulas of t from the step's
/// beginning.
struct Motion {
  std::array<double, 3> direction{{}}; ///< [m]
  std::string way, acceleration;
};

std::string text(const double number) {
  std::ostringstream out;
  out.precision(17);
  out << number;
  return out.str();
}

Motion motion(Random &random) {
  Motion result;
  const double angle = random.number(0., 6.28), a = random.number(0.01, 0.1),
               w = random.number(3., 15.);
  result.direction = {{a * std::cos(angle), a * std::sin(angle),
                       random.chance(0.3) ? random.number(-0.01, 0.01) : 0.}};
  const std::string phase = text(w) + "*t";
  switch (random.whole(0, 3)) {
  case 0:
    result.way = "1-cos(" + phase + ")";
    result.acceleration = text(w * w) + "*cos(" + phase + ")";
    break;
  case 1:
    result.way = "sin(" + phase + ")^4";
    result.acceleration = text(4. * w * w) + "*sin(" + phase + ")^2*(3-4*sin(" + phase + ")^2)";
    break;
  case 2:
    result.way = text(w * w * w) + "*t^3";
    result.acceleration = text(6. * w * w * w) + "*t";
    break;
  default:
    result.way = "(1-cos(" + phase + "))^2";
    result.acceleration =
        text(2. * w * w) + "*(sin(" + phase + ")^2+(1-cos(" + phase + "))*cos(" + phase + "))";
  }
  return result;
}

struct Scenes {
  std::string moved, seen;                           ///< parameter files
  std::vector<std::string> forces, others, instants; ///< quantities
};

class Writer {
public:
  explicit Writer(const unsigned int seed) : random(seed), way(motion(random)) {}
  Scenes write();

private:
  void both(const std::string &lines) {
    scenes.moved += lines;
    scenes.seen += lines;
  }
  void line();
  void end(const std::string &point, const std::string &motions);
  void support(const std::string &name, const std::string &at, const bool is_guide);
  void steps();
  void quantity(std::vector<std::string> &list, const std::string &support,
                const std::string &words, const std::string &suffix) {
    list.push_back("q" + std::to_string(++n_quantities));
    quantities += "  set " + list.back() + " = " + words + " at " + support + suffix + '\n';
  }

  Random random;
  const Motion way;
  Scenes scenes;
  std::vector<std::string> points = {"P0"};
  std::string quantities, displacements;
  int n_quantities = 0;
};

void Writer::line() {
  std::string route = "P0 0 0 0";
  std::array<double, 3> at = {{0., 0., 0.}};
  const int n = random.whole(2, 4), turn = random.whole(1, n);
  for (int i = 1; i <= n; ++i) {
    at[i > turn ? 1 : 0] += random.number(2., 5.);
    points.push_back("P" + std::to_string(i));
    route += "; " + points.back() + ' ' + text(at[0]) + ' ' + text(at[1]) + " 0";
  }
  both("subsection Material steel\n  set Density = 7850\nend\nsubsection Section S\n"
       "  set Outer diameter = " +
       text(random.number(0.06, 0.3)) +
       "\n  set Wall = 0.006\nend\nsubsection Mesh\n"
       "  set Cell length = 2.5\nend\nsubsection Pipe p\n  set Route = " +
       route + "\nend\n");
}

void Writer::end(const std::string &point, const std::string &motions) {
  const std::array<std::string, 6> names = {{"ux", "uy", "uz", "rx", "ry", "rz"}};
  scenes.seen += "subsection Support end" + point +
                 "\n  set Kind = restraint\n  set At = " + point + "\n  set Fixed = " + motions +
                 "\nend\n";
  for (unsigned int d = 0; d < 6; ++d)
    if (motions.find(names[d]) != std::string::npos)
      displacements += (displacements.empty() ? "" : "; ") + point + ' ' + names[d] + ' ' +
                       text(d < 3 ? way.direction[d] : 0.);
}

void Writer::support(const std::string &name, const std::string &at, const bool is_guide) {
  std::string lines = "subsection Support " + name + "\n  set At = " + at +
                      "\n  set Friction coefficient = " + text(random.number(0.1, 0.5)) + '\n';
  if (is_guide)
    lines += "  set Kind = friction\n  set Normal = 0 1 0\n  set Gap = " +
             text(random.number(1e-4, 3e-3)) +
             "\n  set Axial rigidity = 2e5\n"
             "  set Shear rigidity = 1e5\n";
  else
    lines += std::string("  set Kind = rest\n") +
             (random.chance(0.3) ? "  set Shear rigidity = 2e5\n" : "");
  both(lines);
  scenes.moved += "  set Ground motion time = run\n  set Ground motion = ";
  for (int d = 0; d < 3; ++d) {
    std::string formula = way.way;
    for (std::size_t place = 0; (place = formula.find("t", place)) != std::string::npos; place += 5)
      formula.replace(place, 1, "(t-1)");
    scenes.moved +=
        (d > 0 ? "; " : "") + (way.direction[d] == 0.
                                   ? "0"
                                   : "if(t<1,0," + text(way.direction[d]) + "*(" + formula + "))");
  }
  scenes.moved += '\n';
  both("end\n");
  for (const char *const force : {"fn", "ft1", "ft2"}) {
    quantity(scenes.forces, name, std::string("max ") + force, ", from 1.0001");
    quantity(scenes.forces, name, std::string("min ") + force, ", from 1.0001");
  }
  quantity(scenes.others, name, "change wear", ", from 1");
  quantity(scenes.instants, name, "time_of slip", ", from 1");
}

void Writer::steps() {
  scenes.moved +=
      "subsection Load g\n  set Kind = displacement\n  set Displacements = " + displacements +
      "\n  set History = " + way.way + "\nend\n";
  scenes.seen += "subsection Load g\n  set Kind = ground acceleration\n  set Acceleration = " +
                 text(way.direction[0]) + ' ' + text(way.direction[1]) + ' ' +
                 text(way.direction[2]) + "\n  set History = " + way.acceleration + "\nend\n";
  both("subsection Load w\n  set Kind = weight\nend\nsubsection Step carry\n  set Loads = w\nend\n"
       "subsection Step go\n  set Loads = w, g\n  set Analysis = transient\n  set Duration = 0.2\n"
       "end\nsubsection Time\n  set Integrator = event\n  set Step = 0.01\n"
       "  set Stiffness damping = 2e-4\nend\nsubsection Output\n  set VTU = false\n"
       "  set Report = false\nend\nsubsection Quantities\n" +
       quantities + "end\n");
}

Scenes Writer::write() {
  line();
  end(points.front(), "ux, uy, uz, rx, ry, rz");
  if (random.chance(0.6))
    end(points.back(), random.chance(0.5) ? "uy" : "ux, uz");
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (i + 1 == points.size() || random.chance(0.7))
      support("r" + std::to_string(i), points[i], false);
    if (random.chance(0.25))
      support("g" + std::to_string(i), points[i], true);
  }
  steps();
  return scenes;
}

/// 0 for what is not there: an instant at which nothing happens.
double value(const program::Run &run, const std::string &name) {
  for (const program::Quantity &quantity : run.quantities)
    if (quantity.name == name)
      return quantity.value;
  return 0.;
}

void compare(const std::string &program, const unsigned int seed, const bool shows) {
  const Scenes scenes = Writer(seed).write();
  const program::TemporaryFolder folder;
  const auto run = [&](const std::string &name, const std::string &lines) {
    const std::string file = (folder.path / (name + ".prm")).string();
    std::ofstream(file) << lines;
    return program::run(program, file, {}, folder.path / name);
  };
  const program::Run moved = run("moved", scenes.moved), seen = run("seen", scenes.seen);
  if (moved.exit_status != 0 || seen.exit_status != 0) {
    std::cerr << "seed " << seed << ":\n" << moved.output << seen.output << scenes.moved;
    CHECK(false);
    return;
  }
  double worst = 0.;
  std::string of;
  const auto take = [&](const std::vector<std::string> &names, const double least) {
    double largest = least;
    for (const std::string &name : names)
      largest = std::max(largest, std::abs(value(seen, name)));
    for (const std::string &name : names)
      if (const double error = std::abs(value(moved, name) - value(seen, name)) / largest;
          error > worst) {
        worst = error;
        of = name;
      }
  };
  take(scenes.forces, 1e-3);
  take(scenes.others, 1e-6);
  take(scenes.instants, 1.);
  if (shows || worst > 1e-6)
    std::cerr << "seed " << seed << ": " << worst << " in " << of << ", " << moved.wall_seconds
              << " s for " << seen.wall_seconds << " s\n";
  CHECK(worst <= 1e-6);
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
    if (std::find(open.begin(), open.end(), seed) != open.end())
      check::n_failures = failures;
  }
  return check::report();
}
