// SPDX-License-Identifier: LGPL-2.1-or-later
// `frictionbeam contact` shall solve the problems of FCLIB files, as the closed forms written out
// here say; refuse broken files with a message; say honestly what it could not solve. The problems
// that a run exports shall be solved by the forces of that run. Files are written and read by
// FCLIB's own library.
//
// contact_files PROGRAM SOURCE_DIRECTORY
#include "../cases/run_program.h"
#include "fclib_files.h"

#include <cmath>
#include <limits>

namespace {

namespace fs = std::filesystem;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using namespace fclib_files;

bool contains(const std::string &text, const std::string &part) {
  if (text.find(part) != std::string::npos)
    return true;
  std::cerr << "'" << part << "' is missing in:\n" << text << '\n';
  return false;
}

/// The number that the output gives last after @p name.
double number_after(const std::string &text, const std::string &name) {
  const auto place = text.rfind(name);
  return place == std::string::npos ? std::numeric_limits<double>::quiet_NaN()
                                    : std::stod(text.substr(place + name.size()));
}

struct Tests {
  Tests(const std::string &program, const std::string &source) : program(program), source(source) {}

  const std::string program, source;
  const program::TemporaryFolder folder;
  const fs::path file = folder.path / "problem.hdf5";

  program::Run solve(const fs::path &path) const {
    return program::execute({program, "contact", path.string()});
  }

  Solution solved(const int n) const {
    const program::Run run = solve(file);
    CHECK(run.exit_status == 0);
    CHECK(contains(run.output, "Solved in"));
    CHECK(number_after(run.output, "/ ||q|| = ") <= 1e-8);
    CHECK(number_after(run.output, "on its own scale = ") <= 1e-8);
    return read_solution(file, n);
  }

  void expect(const Solution &found, const VectorXd &r, const VectorXd &u) const {
    CHECK((found.r - r).norm() <= 1e-10);
    CHECK((found.u - u).norm() <= 1e-10);
  }

  void three_contacts_in_3d() const;
  void one_contact_in_2d() const;
  void body_on_two_contacts() const;
  void no_solution() const;
  void solution_is_replaced() const;
  void broken_files() const;
  void global_problem() const;
  void time_limit() const;
  void exported_rack(const std::string &friction) const;
  void exported_history(const std::string &name, std::vector<std::string> settings,
                        const int n_increments) const;
  void line_on_contacts_alone() const;
};

/// Uncoupled, W = diag(2, 1, 1) each: u_N = 2 r_N - 1 = 0, r_N = 1/2.
void Tests::three_contacts_in_3d() const {
  Problem problem;
  problem.W = MatrixXd::Zero(9, 9);
  for (int i = 0; i < 9; ++i)
    problem.W(i, i) = i % 3 == 0 ? 2. : 1.;
  problem.q.resize(9);
  problem.q << -1., 0.3, 0.4, -1., 0.3, 0.4, 1., 0.3, 0.4;
  problem.mu.resize(3);
  problem.mu << 0.5, 2., 0.5; // slips, sticks, open
  VectorXd r(9), u(9);
  r << 0.5, -0.25 * 0.6, -0.25 * 0.8, 0.5, -0.3, -0.4, 0., 0., 0.;
  u << 0., 0.3 - 0.15, 0.4 - 0.2, 0., 0., 0., 1., 0.3, 0.4;
  for (const int kind : {-2, -1, 0}) {
    fs::remove(file);
    write(file, problem, kind);
    expect(solved(9), r, u);
  }
}

/// Slipping forward, r_T = -mu r_N: u_N = 2 r_N - 0.5 mu r_N - 1 = 0, u_T = 0.5 r_N + r_T + 0.6.
void Tests::one_contact_in_2d() const {
  Problem problem{2, MatrixXd(2, 2), VectorXd(2), VectorXd::Constant(1, 0.2)};
  problem.W << 2., 0.5, 0.5, 1.;
  problem.q << -1., 0.6;
  const double normal = 1. / 1.9;
  VectorXd r(2), u(2);
  r << normal, -0.2 * normal;
  u << 0., 0.3 * normal + 0.6;
  fs::remove(file);
  write(file, problem, 0);
  expect(solved(2), r, u);
}

/// A plane body of mass and inertia 1, falling with 1 and moving by 0.1, on contacts at x = -1, 1:
/// W has rank 3 of 4. It stops: sum of r_N = 1, sum of r_T = -0.1; the two r_T are not unique.
void Tests::body_on_two_contacts() const {
  MatrixXd H(3, 4); // ux, uy, rz
  H << 0., 1., 0., 1., 1., 0., 1., 0., -1., 0., 1., 0.;
  Problem problem{2, H.transpose() * H, H.transpose() * Eigen::Vector3d(0.1, -1., 0.),
                  VectorXd::Constant(2, 0.3)};
  fs::remove(file);
  write(file, problem);
  const program::Run run = solve(file);
  CHECK(run.exit_status == 0);
  CHECK(contains(run.output, "W has rank 3 of 4"));
  const Solution found = read_solution(file, 4);
  CHECK_NEAR(found.r[0], 0.5, 1e-8);
  CHECK_NEAR(found.r[2], 0.5, 1e-8);
  CHECK_NEAR(found.r[1] + found.r[3], -0.1, 1e-8);
  CHECK(std::abs(found.r[1]) <= 0.15 && std::abs(found.r[3]) <= 0.15);
  CHECK(found.u.norm() <= 1e-8);
}

/// Two faces of one immovable body pushed into each other: u_N = r_1 - r_2 - 1 and r_2 - r_1 - 1
/// cannot both be >= 0.
void Tests::no_solution() const {
  MatrixXd H(2, 4);
  H << 1., 0., -1., 0., 0., 1., 0., 1.;
  Problem problem{2, H.transpose() * H, VectorXd(4), VectorXd::Constant(2, 0.3)};
  problem.q << -1., 0.1, -1., 0.1;
  fs::remove(file);
  write(file, problem);
  const program::Run run = solve(file);
  CHECK(run.exit_status == 2);
  CHECK(contains(run.output, "NOT solved"));
  CHECK(contains(run.output, "it is not a solution, and there may be none"));
  CHECK(contains(run.output, "W has rank 2 of 4"));
  CHECK(number_after(run.output, "/ ||q|| = ") > 1e-8);
  const Solution written = read_solution(file, 4);
  CHECK(written.r.allFinite() && (problem.W * written.r + problem.q - written.u).norm() < 1e-10);
}

/// Solving again replaces /solution, and nothing else of the file changes.
void Tests::solution_is_replaced() const {
  Problem problem{2, MatrixXd::Identity(2, 2), VectorXd(2), VectorXd::Constant(1, 0.5)};
  problem.q << -1., 0.2;
  fs::remove(file);
  write(file, problem);
  double wrong[2] = {3., 4.};
  fclib_solution solution{nullptr, wrong, wrong, nullptr};
  CHECK(fclib_write_guesses(1, &solution, file.c_str()) == 1);
  CHECK(fclib_write_solution(&solution, file.c_str()) == 1);
  VectorXd r(2), u = VectorXd::Zero(2);
  r << 1., -0.2;
  expect(solved(2), r, u);
  const program::Run again = solve(file);
  CHECK(again.exit_status == 0);
  CHECK(number_after(again.output, "file had: ") < 1e-12);
  int n = 0;
  fclib_solution *const guesses = fclib_read_guesses(file.c_str(), &n);
  CHECK(n == 1 && guesses[0].r[0] == 3.);
  fclib_delete_solutions(guesses, n);
}

void Tests::broken_files() const {
  const auto refused = [this](const std::vector<std::string> &parts) {
    const program::Run run = solve(file);
    CHECK(run.exit_status == 1);
    CHECK(contains(run.output, file.string()));
    for (const std::string &part : parts)
      CHECK(contains(run.output, part));
    fs::remove(file);
  };
  const Problem good{2, MatrixXd::Identity(4, 4), VectorXd::Constant(4, -1.),
                     VectorXd::Constant(2, 0.5)};
  fs::remove(file);
  refused({"There is no file"});
  std::ofstream(file) << "no HDF5\n";
  refused({"cannot be opened as HDF5", "h5ls"});

  const auto changed = [&](const auto &change, const std::vector<std::string> &parts) {
    Problem problem = good;
    change(problem);
    write(file, problem);
    refused(parts);
  };
  changed([](Problem &one) { one.mu[1] = -0.5; },
          {"mu of contact 1", "-0.5", "it must be 0 or more"});
  changed([](Problem &one) { one.q[2] = std::nan(""); },
          {"/fclib_local/vectors/q has an entry that is not finite"});
  changed([](Problem &one) { one.W(3, 3) = -1.; }, {"Entry 3", "positive semidefinite"});
  changed([](Problem &one) { one.W(3, 0) = -(one.W(0, 3) = 0.5); },
          {"W is not symmetric", "0.5 in row 0, column 3", "-0.5 in row 3, column 0"});
  changed([](Problem &one) { one.W = MatrixXd::Ones(4, 6); }, {"W is 4 x 6", "it must be square"});
  write(file, good, -1, [](StoredMatrix &W) { W.i[3] = 7; });
  refused({"row 7, column 3", "outside of its 4"});
  write(file, good, -1, [](StoredMatrix &W) { W.p[4] = 9; });
  refused({"p ends with 9"});

  // A global problem whose M is singular, and one with equality constraints.
  StoredMatrix matrix(MatrixXd::Identity(2, 2), -1), singular(MatrixXd::Ones(2, 2), -1);
  double zero[2] = {0., 0.};
  fclib_global global{};
  global.M = &singular.stored;
  global.H = &matrix.stored;
  global.f = global.w = global.mu = zero;
  global.spacedim = 2;
  CHECK(fclib_write_global(&global, file.c_str()) == 1);
  refused({"W = H^T M^-1 H does not exist", "M that is singular", "contact library"});
  fclib_local local{};
  local.W = local.V = local.R = &matrix.stored;
  local.q = local.s = local.mu = zero;
  local.spacedim = 2;
  CHECK(fclib_write_local(&local, file.c_str()) == 1);
  refused({"equality constraints", "Eliminate them"});

  const program::Run run = program::execute({program, "contact"});
  CHECK(run.exit_status == 1);
  CHECK(contains(run.output, "file is required"));
  for (const std::string option : {"--tolerance=2", "--time-limit=-1"}) {
    const program::Run refused = program::execute({program, "contact", option, file.string()});
    CHECK(refused.exit_status == 1);
    CHECK(contains(refused.output, "not understood"));
    CHECK(option != "--tolerance=2" || contains(refused.output, "range 1e-15 to 0.01"));
  }
}

/// A block of mass 2 and moment of inertia 0.5 that falls with 1 and moves by 0.1 is held by its
/// two contacts, and stops: v = 0, sums of r are 2 and -0.2.
void Tests::global_problem() const {
  MatrixXd M = MatrixXd::Zero(3, 3), H(3, 4); // ux, uy, rz
  M.diagonal() << 2., 2., 0.5;
  H << 0., 1., 0., 1., 1., 0., 1., 0., -1., 0., 1., 0.;
  const VectorXd f = M * Eigen::Vector3d(0.1, -1., 0.);
  for (const int kind : {-2, -1, 0}) {
    StoredMatrix stored_M(M, kind), stored_H(H, kind);
    std::vector<double> forces(f.data(), f.data() + 3), w(4, 0.), mu(2, 0.3);
    fclib_global global{};
    global.M = &stored_M.stored;
    global.H = &stored_H.stored;
    global.f = forces.data();
    global.w = w.data();
    global.mu = mu.data();
    global.spacedim = 2;
    fs::remove(file);
    CHECK(fclib_write_global(&global, file.c_str()) == 1);
    const program::Run run = solve(file);
    CHECK(run.exit_status == 0);
    CHECK(contains(run.output, "a global problem of 3 unknowns, 2 contacts in 2D"));
    CHECK(number_after(run.output, "||M v - H r - f|| / ||f|| = ") <= 1e-12);
    const Solution found = read_solution(file, 4);
    CHECK_NEAR(found.r[0] + found.r[2], 2., 1e-10);
    CHECK_NEAR(found.r[1] + found.r[3], -0.2, 1e-10);
    CHECK_NEAR(found.r[0], found.r[2], 1e-10);
    CHECK(found.u.norm() <= 1e-10);
    fclib_solution *const solution = fclib_read_solution(file.c_str());
    CHECK(vector(solution->v, 3).norm() <= 1e-10);
    fclib_delete_solutions(solution, 1);
  }
}

/// Time runs out before a stack of 400 blocks is solved: the best is written, and told to be none.
void Tests::time_limit() const {
  constexpr int n = 800;
  Problem problem{2, MatrixXd::Zero(n, n), VectorXd::Zero(n), VectorXd::Constant(n / 2, 0.3)};
  for (int i = 0; i < n; ++i) {
    problem.W(i, i) = i < 2 ? 1. : 2.;
    if (i >= 2)
      problem.W(i, i - 2) = problem.W(i - 2, i) = -1.;
  }
  problem.q[0] = -1.;
  fs::remove(file);
  write(file, problem);
  const program::Run run =
      program::execute({program, "contact", "--time-limit=1e-6", file.string()});
  CHECK(run.exit_status == 2);
  CHECK(contains(run.output, "The time limit of 1e-06 s was reached"));
  CHECK(contains(run.output, "NOT solved"));
  const program::Run longer = program::execute(
      {program, "contact", "--time-limit=100", "--tolerance=1e-10", file.string()});
  CHECK(longer.exit_status == 0);
  CHECK(number_after(longer.output, "on its own scale = ") <= 1e-10);
  CHECK_NEAR(read_solution(file, n).r[0], n / 2, 1e-7);
}

/// The rack's own forces solve the problem that it exports, in either form, and our solution of
/// that problem is the same.
void Tests::exported_rack(const std::string &friction) const {
  const fs::path results = folder.path / ("rack-" + friction);
  const program::Run run = program::run(
      program, source + "/prm/benchmark/rack_family.prm",
      {"--set", "Rack/Friction = " + friction, "--set", "Output/Write contact problems = true"},
      results);
  CHECK(run.exit_status == 0);
  const fs::path exported = results / "contact_problems/01_weight_and_heat_0001.hdf5";
  fclib_local *const local = fclib_read_local(exported.c_str());
  const int n = local->W->m;
  CHECK(n == 57 && local->spacedim == 3);
  const MatrixXd W = dense(*local->W);
  const VectorXd q = vector(local->q, n);
  for (int i = 0; i < n / 3; ++i)
    CHECK(local->mu[i] == std::stod(friction));
  fclib_delete_local(local);
  const Solution own = read_solution(exported, n);
  CHECK((W * own.r + q - own.u).norm() <= 1e-12 * q.norm());
  double sum = 0.;
  for (int i = 0; i < n; i += 3)
    sum += own.r[i];
  CHECK_NEAR(sum, run["sum_normal"], 1e-9);

  const program::Run solved = solve(exported);
  CHECK(solved.exit_status == 0);
  CHECK(number_after(solved.output, "/ ||q|| = ") <= 1e-8);
  const Solution found = read_solution(exported, n);
  CHECK((found.r - own.r).lpNorm<Eigen::Infinity>() <= 1e-6 * own.r.lpNorm<Eigen::Infinity>());

  const fs::path path = results / "contact_problems/01_weight_and_heat_0001_global.hdf5";
  fclib_global *const global = fclib_read_global(path.c_str());
  fclib_solution *const solution = fclib_read_solution(path.c_str());
  const MatrixXd M = dense(*global->M), H = dense(*global->H);
  const VectorXd f = vector(global->f, M.rows()), w = vector(global->w, n),
                 v = vector(solution->v, M.rows());
  CHECK((M * v - H * own.r - f).norm() <= 1e-8 * f.norm());
  // What is left of equilibrium, some 1e-11 of the loads, moves a line without its supports by
  // more.
  CHECK((H.transpose() * v + w - own.u).norm() <= 1e-8 * q.norm());
  const VectorXd free = M.ldlt().solve(f);
  CHECK((H.transpose() * free + w - q).norm() <= 1e-6 * q.norm());
  fclib_delete_solutions(solution, 1);
  fclib_delete_global(global);
  CHECK(solve(path).exit_status == 0);
  const Solution from_global = read_solution(path, n);
  CHECK((from_global.r - own.r).lpNorm<Eigen::Infinity>() <=
        1e-6 * own.r.lpNorm<Eigen::Infinity>());
}

/// Each increment's problem is solved by the forces of the run.
/// @param settings of the case, as the program's options
void Tests::exported_history(const std::string &name, std::vector<std::string> settings,
                             const int n_increments) const {
  const fs::path results = folder.path / fs::path(name).stem();
  settings.insert(settings.end(), {"--set", "Output/Write contact problems = true"});
  CHECK(program::run(program, source + name, settings, results).exit_status == 0);
  int n_files = 0;
  for (const auto &entry : fs::directory_iterator(results / "contact_problems")) {
    if (entry.path().stem().string().find("global") != std::string::npos)
      continue;
    ++n_files;
    fclib_local *const local = fclib_read_local(entry.path().c_str());
    const int n = local->W->m;
    fclib_delete_local(local);
    const Solution own = read_solution(entry.path(), n);
    CHECK(solve(entry.path()).exit_status == 0);
    const Solution found = read_solution(entry.path(), n);
    CHECK((found.r - own.r).norm() <= 1e-6 * own.r.norm());
  }
  CHECK(n_files == n_increments);
}

/// The slab is held by friction alone: no W, but the global form, and a remark.
void Tests::line_on_contacts_alone() const {
  const fs::path results = folder.path / "slab";
  const program::Run run = program::run(program, source + "/prm/verification/slab.prm",
                                        {"--set", "Output/Write contact problems = true"}, results);
  CHECK(run.exit_status == 0);
  CHECK(contains(run.output, "contact problems are written in the global form only"));
  for (const auto &entry : fs::directory_iterator(results / "contact_problems"))
    CHECK(entry.path().stem().string().find("global") != std::string::npos);
}

} // namespace

int main(int argc, char **argv) {
  if (argc != 3)
    return 1;
  const Tests tests(argv[1], argv[2]);
  tests.three_contacts_in_3d();
  tests.one_contact_in_2d();
  tests.body_on_two_contacts();
  tests.no_solution();
  tests.solution_is_replaced();
  tests.broken_files();
  tests.global_problem();
  tests.time_limit();
  tests.exported_rack("0.3");
  tests.exported_rack("1");
  // Weighed, heated, cooled on supports of finite stiffness with old slips; with spring hangers.
  tests.exported_history("/tests/cases/line/slide.prm",
                         {"--set", "Support rests/Axial rigidity = 1e8", "--set",
                          "Support rests/Shear rigidity = 1e7"},
                         11);
  tests.exported_history("/prm/example/pump_line.prm", {}, 5);
  tests.line_on_contacts_alone();
  return check::report();
}
