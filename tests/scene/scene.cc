// SPDX-License-Identifier: LGPL-2.1-or-later
// A parameter file shall become the scene that it describes; every wrong one shall be refused with
// a message that says what was read, what is allowed and what to try; references of generated
// scenes shall follow their parameters. Numbers come from the closed forms written out here.
#include "../check.h"

#include "base/user_error.h"
#include "scene/read_scene.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

using namespace frictionbeam;
namespace fs = std::filesystem;

namespace {

const fs::path source = SOURCE_DIRECTORY;
constexpr double pi = 3.14159265358979323846;

using Options = std::vector<std::string>;

Scene read(const fs::path &file, const Options &options = {}) {
  LawLibrary laws;
  laws.load_builtin();
  return read_scene(file.string(), options, laws);
}

Scene read_text(const std::string &text, const Options &options = {}) {
  std::ofstream("scene_test.prm") << text;
  return read("scene_test.prm", options);
}

/// The message with which a file is refused; empty if it is not.
std::string message(const fs::path &file, const Options &options = {}) {
  try {
    read(file, options);
  } catch (const UserError &error) {
    return error.what();
  }
  return "";
}

bool contains(const std::string &text, const std::string &part) {
  if (text.find(part) != std::string::npos)
    return true;
  std::cerr << "'" << part << "' is missing in:\n" << text << '\n';
  return false;
}

std::vector<fs::path> files_in(const fs::path &folder) {
  std::vector<fs::path> files;
  for (const auto &entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".prm")
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

/// Each broken file is refused with the texts of its comment lines "# expect: ...".
void test_broken_files() {
  for (const fs::path &file : files_in(source / "tests/scene/broken")) {
    const std::string found = message(file);
    std::ifstream in(file);
    std::string line;
    unsigned int n_expected = 0;
    for (const std::string prefix = "# expect: "; std::getline(in, line);)
      if (line.substr(0, prefix.size()) == prefix) {
        ++n_expected;
        CHECK(contains(found, line.substr(prefix.size())));
      }
    CHECK(n_expected > 0);
    CHECK(contains(found, "  read:    ") && contains(found, "  allowed: ") &&
          contains(found, "  try:     "));
    CHECK(contains(found, file.filename().string()));
  }
  CHECK(contains(message("no such file.prm"), "'no such file.prm' cannot be read"));
}

/// A wrong --set is told as well as a wrong line.
void test_broken_options() {
  const fs::path slab = source / "prm/verification/slab.prm",
                 line = source / "tests/scene/forty_lines.prm";
  const auto expect = [](const fs::path &file, const std::string &option, const Options &texts) {
    const std::string found = message(file, {option});
    CHECK(contains(found, "--set \"" + option + "\""));
    for (const std::string &text : texts)
      CHECK(contains(found, text));
    CHECK(contains(found, "read:    ") && contains(found, "allowed: ") &&
          contains(found, "try:     "));
  };
  expect(slab, "Slab/GS", {"Section/Entry = value"});
  expect(slab, "Slab/Gs = 1e6", {"section 'Slab', entry 'Gs'", "try:     'GS'"});
  expect(slab, "Slab/GS = -1", {"read:    -1", "a number >= 0 [N]"});
  expect(slab, "Slap/GS = 1", {"subsection Slap"});
  expect(line, "Support rest/Friction coefficient = 0.2",
         {"section 'Support rest', which the file does not have", "try:     'Support rests'"});
  expect(line, "Acuracy = 1e-3", {"entry 'Acuracy'", "try:     'Accuracy'"});
}

/// All parameter files of the project are read without complaint.
void test_project_files() {
  for (const std::string folder : {"prm/verification", "prm/example"})
    for (const fs::path &file : files_in(source / folder)) {
      const std::string found = message(file);
      if (!found.empty())
        std::cerr << found << '\n';
      CHECK(found.empty());
    }
}

/// Two legs on supports take at most 40 lines, and become what they say.
void test_forty_lines() {
  const fs::path file = source / "tests/scene/forty_lines.prm";
  std::ifstream in(file);
  std::string line;
  unsigned int n_lines = 0;
  while (std::getline(in, line))
    ++n_lines;
  CHECK(n_lines <= 40);

  const Scene scene = read(file);
  CHECK(scene.name == "forty_lines" && scene.remarks.empty());
  const double D = 0.2191, t = 0.0082, d = D - 2. * t;
  const Section &section = scene.sections.at(0);
  CHECK_NEAR(section.area, pi / 4. * (D * D - d * d), 1e-14);
  CHECK_NEAR(section.inertia, pi / 64. * (std::pow(D, 4) - std::pow(d, 4)), 1e-14);
  CHECK_NEAR(section.torsion_constant, 2. * section.inertia, 1e-14);
  CHECK_NEAR(section.shear_area, section.area / 2., 1e-14);
  CHECK_NEAR(section.bore_area(), pi / 4. * d * d, 1e-14);
  CHECK_NEAR(scene.materials.at(0).youngs_modulus, 2.03e11, 1e-15);
  const Pipe &pipe = scene.pipes.at(0);
  CHECK(pipe.route.size() == 3);
  CHECK(pipe.route.at(2).name == "B" && pipe.route.at(2).position == Point3(18., 12., 0.));
  CHECK_NEAR(pipe.route.at(1).bend_radius, 0.305, 1e-15);
  CHECK(scene.restraints.size() == 1 && scene.restraints.at(0).fixed[5]);
  CHECK(scene.supports.size() == 2);
  const FrictionSupport &rests = scene.supports.at(0);
  CHECK(rests.name == "rests" && rests.placement.every == 6. && rests.normal.vector[2] == 1.);
  LawLibrary laws;
  laws.load_builtin();
  const unsigned int f = parameter_index(laws.find("coulomb"), "Friction coefficient");
  CHECK_NEAR(rests.parameters.at(f), 0.4, 1e-15);
  CHECK_NEAR(
      read(file, {"Support rests/Friction coefficient = 0.1"}).supports.at(0).parameters.at(f), 0.1,
      1e-15);
  CHECK(scene.loads.at(1).value == 160. && scene.loads.at(0).vector[2] == -9.81);
  CHECK(scene.steps.size() == 2 && scene.steps.at(1).name == "heat" &&
        scene.steps.at(1).loads.size() == 2 && scene.steps.at(1).n_increments == 5);
}

/// The less common parts: tee, guide with gap, spring, mass, imposed displacement, initial values.
void test_parts() {
  const Scene scene =
      read_text("set Free motions = ux, uy, uz \\\n, rx, ry, rz # all\n"
                "subsection Material m\nend\n"
                "subsection Section s\n set Area = 0.01\n set Inertia = 1e-4\n"
                " set Shear area = none\n set Added mass = 7\nend\n"
                "subsection Section h\n set Outer diameter = 0.2\n set Wall = 0.01\n"
                " set Shear area = cowper\nend\n"
                "subsection Pipe run\n set Section = s\n"
                " set Route = 10 0 0 0; T by 5 0 0; 10 0 0;\nend\n"
                "subsection Pipe branch\n set Section = h\n"
                " set Route = T; E by 0 0 -2\n set Bend flexibility = 3\nend\n"
                "subsection Support loose\n set Kind = guide\n set At = T\n"
                " set Gap = 0.003\nend\n"
                "subsection Support tight\n set Kind = line stop\n set At = E\nend\n"
                "subsection Support bed\n set Pipe = run\n set Continuous = true\n"
                " set From = 10\n set To = T\n set Rotations = pipe\nend\n"
                "subsection Spring k\n set At = T\n set To = E\n"
                " set Stiffness = 1 2 3\nend\n"
                "subsection Mass v\n set At = T, E\n set Mass = 50\nend\n"
                "subsection Load d\n set Kind = displacement\n"
                " set Displacements = E ux 0.01 rz 180; 10 uy 2\nend\n"
                "subsection Load f\n set Kind = force\n"
                " set Forces = E 1 2 3 4 5 6\nend\n"
                "subsection Step one\n set Loads = f 0.5, d\n"
                " set Analysis = transient\n set Duration = 2\n set Ramp = 1\nend\n"
                "subsection Initial i\n set At = E\n set Velocity = 0 1 0\nend\n"
                "subsection Quantities\n set Source = book\n"
                " set a = |N| at T, time 0.5; scale 1e-3; reference 4\n"
                " set b = fx at loose.plus, step one; reference 5; source me\n"
                " set c = n_slip\nend\n");
  CHECK(scene.pipes.at(1).route.at(0).position == Point3(5., 0., 0.));
  CHECK(scene.pipes.at(0).route.at(0).name == "10" && scene.pipes.at(0).route.at(2).name.empty());
  CHECK(scene.pipes.at(1).section == 1 && scene.pipes.at(1).bend_flexibility.factor == 3.);
  CHECK(scene.sections.at(0).shear_area == 0. && scene.sections.at(0).added_mass == 7.);
  // Cowper's figure tends to 2 (1 + nu)/(4 + 3 nu) for a thin wall; this wall is a tenth of a
  // radius.
  CHECK_NEAR(scene.sections.at(1).shear_area / scene.sections.at(1).area, 2. * 1.3 / 4.9, 1e-2);
  CHECK(scene.supports.size() == 3 && scene.restraints.size() == 1);
  CHECK(scene.supports.at(0).name == "loose.plus" && scene.supports.at(1).name == "loose.minus");
  CHECK(scene.supports.at(0).normal.kind == Direction::Kind::across);
  CHECK(scene.supports.at(0).normal.sign == 1. && scene.supports.at(1).normal.sign == -1.);
  CHECK(scene.supports.at(2).placement.continuous &&
        scene.supports.at(2).rotations == FrictionSupport::Rotations::pipe);
  CHECK(scene.restraints.at(0).translations.at(0).kind == Direction::Kind::along);
  CHECK(scene.springs.at(0).other == "E" && scene.springs.at(0).stiffness[1] == 2.);
  CHECK(scene.masses.at(0).points.size() == 2);
  CHECK(scene.loads.at(0).at.size() == 2 && scene.loads.at(0).at.at(0).given[5] &&
        !scene.loads.at(0).at.at(0).given[1]);
  CHECK_NEAR(scene.loads.at(0).at.at(0).value[5], pi, 1e-15);
  CHECK(scene.loads.at(1).at.at(0).value[5] == 6.);
  CHECK(scene.steps.at(0).transient && scene.steps.at(0).ramp == 1. &&
        scene.steps.at(0).loads.at(0) == std::make_pair(1u, 0.5));
  CHECK(scene.initial.at(0).velocity[1] == 1.);
  CHECK(scene.quantities.at(0).absolute && scene.quantities.at(0).what == "N" &&
        scene.quantities.at(0).scale == 1e-3 && *scene.quantities.at(0).time == 0.5 &&
        scene.quantities.at(0).source == "book");
  CHECK(scene.quantities.at(1).source == "me" && !scene.quantities.at(2).reference);
}

bool remarks_on(const Scene &scene, const std::string &text) {
  return std::any_of(scene.remarks.begin(), scene.remarks.end(), [&](const std::string &remark) {
    return remark.find(text) != std::string::npos;
  });
}

/// A reference in the file goes when the scene is changed, and only then; a file may include
/// another and set its entries again.
void test_references_and_include() {
  const fs::path wedge = source / "prm/verification/wedge.prm";
  const auto has_reference = [&](const Options &options) {
    const Scene scene = read(wedge, options);
    CHECK(remarks_on(scene, "reference") == !scene.quantities.at(0).reference);
    return bool(scene.quantities.at(0).reference);
  };
  CHECK(has_reference({}));
  CHECK(has_reference({"Solver/Method = elastic", "Mesh/Cell length = 1", "Time/Step = 1",
                       "Output/Stations = 0", "Title = other"}));
  CHECK(has_reference({"Support slope/Friction coefficient = 3e-1"}));
  CHECK(!has_reference({"Support slope/Friction coefficient = 0.2"}));

  const Scene scene = read_text("include " + (source / "prm/verification/slab.prm").string() +
                                "\nset Title = shrunk\nsubsection Slab\n set Elements = 4\nend\n");
  CHECK(scene.title == "shrunk" && scene.points.size() == 3);
}

/// Entries of bends that no beam has are told, of each pipe.
void test_bends_that_are_solids() {
  const auto is_told = [](const Options &options) {
    return remarks_on(read(source / "prm/example/mixed_rack.prm", options),
                      "its Bend flexibility is not used where all its bends are solids");
  };
  const std::string given = "Pipe main/Bend flexibility = none";
  CHECK(!is_told({}) && is_told({given}));
  CHECK(is_told({given, "Solid/At = all bends"}) && !is_told({given, "Solid/At ="}));
}

double u_0(const double F, const double GS, const unsigned int n, const Options &more = {}) {
  Options options = more;
  std::ostringstream force, rigidity;
  force.precision(17);
  force << "Slab/Force = " << F;
  rigidity << "Slab/GS = " << GS;
  options.insert(options.end(),
                 {force.str(), rigidity.str(), "Slab/Elements = " + std::to_string(n)});
  return *read(source / "prm/verification/slab.prm", options).quantities.at(0).reference;
}

/// The slab's reference is the solution of the discrete model with cosh, where that does not
/// overflow, and tends to the continuum.
void test_slab() {
  const double L = 8., EA = 1000., q = 3.;
  for (const double F : {6., 12., 18.})
    for (const double GS : {1e2, 1e3, 1e4, 1e6, 1e9})
      for (const unsigned int n : {4u, 16u}) {
        const double h = L / n, c = EA / h, K = GS, Q = q * h;
        const double th = std::acosh(1. + K / (2. * c));
        double u = 0.;
        for (unsigned int m = 0; m <= n; ++m) {
          const double k = n - m;
          const double N = m == 0 ? F : F - (m - 0.5) * Q;
          const double ratio = std::cosh(th * (k - 1.)) / std::cosh(th * k);
          u = m == n   ? N / (K / 2.)
              : m == 0 ? F / (c * (1. - ratio) + K / 2.)
                       : N * 1. / (c * (std::cosh(th * (k + 1.)) / std::cosh(th * k) - 1.));
          if (K * u > Q)
            continue;
          for (unsigned int i = m; i > 0; --i)
            u += (N + (m - i) * Q) / c;
          break;
        }
        CHECK_NEAR(u_0(F, GS, n), u, 1e-11);
      }
  // Long stick zone: u(0) = F^2/(2 q EA) + q/(2k).
  for (const double GS : {1e6, 1e12})
    CHECK_NEAR(u_0(12., GS, 800), 144. / (2. * q * EA) + q / (2. * GS / (L / 800)), 1e-6);
  // Far end fixed and all slipping.
  CHECK_NEAR(u_0(30., 1e9, 16, {"Slab/Far end = fixed"}), (30. * L - q * L * L / 2.) / EA, 1e-12);
  // More than friction holds.
  const Scene slides = read(source / "prm/verification/slab.prm", {"Slab/Force = 24.1"});
  CHECK(!slides.quantities.at(0).reference && slides.remarks.size() == 1);
}

/// The exact oscillator obeys the recursion of its turning points and its equation of motion.
void test_oscillator() {
  const Scene scene = read(source / "prm/verification/oscillator.prm",
                           {"Oscillator/Initial velocity = 0", "Oscillator/Friction stiffness = 3",
                            "Oscillator/Friction force = 1.5"});
  const auto &x = scene.exact.value().value;
  const double k1 = 1., k2 = 3., F = 1.5, a = F / k1, delta = F / k2;
  // First turning point from rest at x0 with T = 0: energy, x0 - delta being where slip begins.
  const double x0 = 10., w = std::sqrt(k1 + k2), centre = k2 * x0 / (k1 + k2);
  const double t1 = std::acos((x0 - delta - centre) / (x0 - centre)) / w,
               v1 = -(x0 - centre) * w * std::sin(w * t1);
  double X = -a + std::hypot(x0 - delta - a, v1 / std::sqrt(k1)); // at -X
  CHECK_NEAR(x(0.), x0, 1e-14);
  CHECK_NEAR(x(t1), x0 - delta, 1e-13);
  const double dt = 1e-4;
  unsigned int n_found = 0;
  for (double t = dt; t < 20. - dt && X > delta && n_found < 4; t += dt)
    if ((x(t) - x(t - dt)) * (x(t + dt) - x(t)) < 0.) {
      CHECK_NEAR(std::abs(x(t)), X, 1e-6);
      X = -a + std::sqrt((X - a) * (X - a) + 4. * a * delta);
      ++n_found;
    }
  CHECK(n_found >= 3);
}

/// Published figures of the friction bed, and continuity of its closed forms where they change.
void test_friction_bed() {
  const auto values = [](const std::string &ratio) {
    std::vector<double> result;
    for (const Quantity &q :
         read(source / "prm/verification/rack_closed_form.prm", {"Rack/Length ratio = " + ratio})
             .quantities)
      result.push_back(*q.reference);
    return result;
  };
  const double f = 240., L_a = 6.88e8 * 1.2e-5 * 60. / f, strain = 1.2e-5 * 60.;
  const auto short_one = values("0.3"), long_one = values("2");
  CHECK_NEAR(short_one.at(0), -f * 0.3 * L_a, 1e-14);
  CHECK_NEAR(short_one.at(2), f * 0.3 * L_a, 1e-14);
  CHECK_NEAR(short_one.at(1), strain * 0.3 * L_a * (1. - 0.3 / 2.), 1e-14);
  CHECK_NEAR(short_one.at(1) + short_one.at(3), strain * 0.3 * L_a, 1e-13);
  CHECK_NEAR(values("0.8").at(3), 0.341798, 1e-5);
  CHECK_NEAR(long_one.at(0), -6.88e8 * strain, 1e-14);
  CHECK(long_one.at(2) == 0.);
  CHECK_NEAR(long_one.at(3), long_one.at(1) / 2., 1e-14);
  for (const std::string change : {"0.5", "1.0"}) {
    const auto before = values(change), after = values(change + "000000001");
    for (unsigned int i = 0; i < 4; ++i) // 0 and 2 are forces
      CHECK(std::abs(before.at(i) - after.at(i)) < 1e-8 * (i % 2 == 0 ? f * L_a : strain * L_a));
  }
}

/// Every entry has a unit in brackets and says what is allowed; doc/parameters.prm is up to date.
void test_documentation() {
  LawLibrary laws;
  laws.load_builtin();
  std::ostringstream printed;
  print_parameters(printed, laws);
  std::istringstream lines(printed.str());
  std::string line, comment;
  unsigned int n_entries = 0;
  while (std::getline(lines, line)) {
    const auto begin = line.find_first_not_of(' ');
    if (begin != std::string::npos && line[begin] == '#')
      comment += line.substr(begin + 1);
    else if (begin != std::string::npos && line.compare(begin, 4, "set ") == 0) {
      ++n_entries;
      const bool explained =
          comment.find('[') != std::string::npos && comment.find("Allowed: ") != std::string::npos;
      if (!explained)
        std::cerr << line << '\n';
      CHECK(explained);
      comment.clear();
    } else
      comment.clear();
  }
  CHECK(n_entries > 100);

  std::ifstream in(source / "doc/parameters.prm");
  std::ostringstream documented;
  documented << in.rdbuf();
  if (documented.str() != printed.str())
    std::cerr << "Write it again: frictionbeam --print-parameters > doc/parameters.prm\n";
  CHECK(documented.str() == printed.str());
}

} // namespace

int main() {
  test_broken_files();
  test_broken_options();
  test_project_files();
  test_forty_lines();
  test_parts();
  test_references_and_include();
  test_bends_that_are_solids();
  test_slab();
  test_oscillator();
  test_friction_bed();
  test_documentation();
  return check::report();
}
