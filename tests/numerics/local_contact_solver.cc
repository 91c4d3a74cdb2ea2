// SPDX-License-Identifier: LGPL-2.1-or-later
// One contact by hand: open, sticking, slipping. Random problems by the laws themselves: gaps and
// forces are no less than zero and exclude each other, friction is within the disc, and where it
// slips, at its limit against the slip. A contact shall be right on its own scale, however stiff it
// is and however small its force beside those of others (closed forms, and forces that q is made
// of).
#include "../check.h"

#include <frictionbeam/contact/local_solver.h>

#include <cmath>
#include <random>
#include <vector>

using namespace frictionbeam;
using namespace frictionbeam::contact;

namespace {

contact::LocalProblem one_contact(const Eigen::Vector3d &q) {
  contact::LocalProblem problem;
  problem.W.resize(3, 3);
  problem.W.insert(0, 0) = 2.; // [m/N]
  problem.W.insert(1, 1) = 1.;
  problem.W.insert(2, 2) = 1.;
  problem.q = q;
  problem.friction = Eigen::VectorXd::Constant(1, 0.5);
  return problem;
}

void laws_hold(const contact::LocalProblem &problem, const contact::LocalSolution &solution) {
  CHECK(solution.converged);
  const double most = std::max(solution.reactions.norm(), 1e-30), far = solution.motions.norm();
  for (unsigned int i = 0; i < problem.n_contacts(); ++i) {
    const Eigen::Vector3d r = solution.reactions.segment<3>(3 * i),
                          u = solution.motions.segment<3>(3 * i);
    const Eigen::Vector2d T = r.tail<2>(), slip = u.tail<2>();
    CHECK(r[0] >= -1e-9 * most && u[0] >= -1e-9 * far);
    CHECK(std::abs(r[0] * u[0]) <= 1e-9 * most * far);
    CHECK(T.norm() <= problem.friction[i] * r[0] + 1e-9 * most);
    // least dissipation: T . slip = -mu r_N |slip|
    CHECK_NEAR((T.dot(slip) + problem.friction[i] * r[0] * slip.norm()) / (most * far), 0., 1e-9);
  }
}

contact::LocalProblem random_problem(const unsigned int seed, const int n_contacts) {
  std::minstd_rand random(seed);
  std::normal_distribution<double> number;
  const auto draw = [&](const double) { return number(random); };
  const int n = 3 * n_contacts;
  const Eigen::MatrixXd root = Eigen::MatrixXd(n, n).unaryExpr(draw);
  contact::LocalProblem problem;
  problem.W =
      Eigen::MatrixXd(root * root.transpose() + Eigen::MatrixXd::Identity(n, n)).sparseView();
  problem.q = Eigen::VectorXd(n).unaryExpr(draw);
  problem.friction = Eigen::VectorXd::LinSpaced(n_contacts, 0., 0.6);
  return problem;
}

/// Two contacts that do not know each other, one of them 1e15 times as stiff: W_NN r_N = 4, T = 0.3
/// W_TT.
void one_stiff_contact() {
  for (const double w : {1e-12, 1e-15, 1e-20}) {
    contact::LocalProblem problem;
    problem.W.resize(6, 6);
    for (int i = 0; i < 6; ++i)
      problem.W.insert(i, i) = i < 3 ? 1. : w;
    problem.q.resize(6);
    problem.q << -4., 0.3, 0., -4., 0.3, 3.;
    problem.friction = Eigen::VectorXd::Constant(2, 0.5);
    const auto solution = contact::solve_local_contact(problem, 1e-10);
    CHECK(solution.converged);
    CHECK_NEAR((solution.reactions.head<3>() - Eigen::Vector3d(4., -0.3, 0.)).norm(), 0., 1e-12);
    const Eigen::Vector3d slips(4., -2. * 0.3 / std::hypot(0.3, 3.),
                                -2. * 3. / std::hypot(0.3, 3.));
    CHECK_NEAR((w * solution.reactions.tail<3>() - slips).norm(), 0., 1e-10);
    // What is right for the mean of W_ii is wrong here, and is told to be.
    Eigen::VectorXd wrong = solution.reactions;
    wrong.tail<3>() << 4., -0.3, 0.;
    CHECK(contact::evaluate_residual(problem, wrong).own_scale > 0.1);
    CHECK(!contact::evaluate_residual(problem, wrong).holds(1e-8));
  }
}

/// Some contacts, all sticking, q such that r is their forces, the first of them tiny; W full.
void one_small_force(const unsigned int seed) {
  constexpr int n_contacts = 8, n = 3 * n_contacts;
  constexpr double tiny = 7e-9;
  contact::LocalProblem problem = random_problem(seed, n_contacts);
  const Eigen::MatrixXd W = problem.W;
  Eigen::VectorXd forces(n);
  for (int i = 0; i < n_contacts; ++i)
    forces.segment<3>(3 * i) = (i == 0 ? tiny : 1.) * Eigen::Vector3d(1., 0.1, 0.1);
  problem.friction.setConstant(0.5);
  problem.q = -(W.cast<long double>() * forces.cast<long double>()).cast<double>();
  const auto solution = contact::solve_local_contact(problem, 1e-10);
  CHECK(solution.converged);
  CHECK_NEAR((solution.reactions - forces).norm(), 0., 1e-12);
  // Without the small force it is not a solution, however little it is beside the others.
  Eigen::VectorXd without = solution.reactions;
  without.head<3>().setZero();
  CHECK(!contact::evaluate_residual(problem, without).holds(1e-8));
}

/// A stack of plane blocks of unit mass, each on one contact, falling with 1: r_N of contact i is
/// the momentum above it, n - i, and every block pushed with 0.1 is held, as friction 0.3 allows.
contact::LocalProblem stack(const int n_blocks) {
  contact::LocalProblem problem;
  problem.dimension = 2;
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < n_blocks; ++i)
    for (int c = 0; c < 2; ++c) {
      entries.emplace_back(2 * i + c, 2 * i + c, i == 0 ? 1. : 2.);
      if (i > 0) {
        entries.emplace_back(2 * i + c, 2 * i - 2 + c, -1.);
        entries.emplace_back(2 * i - 2 + c, 2 * i + c, -1.);
      }
    }
  problem.W.resize(2 * n_blocks, 2 * n_blocks);
  problem.W.setFromTriplets(entries.begin(), entries.end());
  problem.q = Eigen::VectorXd::Zero(2 * n_blocks);
  problem.q[0] = -1.;
  problem.q[1] = 0.1;
  problem.friction = Eigen::VectorXd::Constant(n_blocks, 0.3);
  return problem;
}

/// Forces pass through 300 blocks, which sweeps alone would take 1e5 rounds for.
void tall_stack() {
  constexpr int n_blocks = 300;
  const contact::LocalProblem problem = stack(n_blocks);
  const auto solution = contact::solve_local_contact(problem, 1e-10);
  CHECK(solution.converged && !solution.out_of_time);
  CHECK(solution.sweeps < 20000);
  for (int i = 0; i < n_blocks; ++i) {
    CHECK_NEAR(solution.reactions[2 * i], n_blocks - i, 1e-8 * n_blocks);
    CHECK_NEAR(solution.reactions[2 * i + 1], -0.1 * (n_blocks - i), 1e-8 * n_blocks);
  }
}

/// No time: the best so far, which is no solution and says so.
void out_of_time() {
  const auto solution = contact::solve_local_contact(stack(300), 1e-10, 1e-9);
  CHECK(!solution.converged && solution.out_of_time && solution.residual.own_scale > 1e-10);
}

/// Between two stops that overlap by 1, and pressed on ground that does not give: no forces solve
/// it, however large they grow, whatever the units, and whatever else there is.
void no_solution(const double of_W, const double of_q) {
  Eigen::MatrixXd between(2, 4);
  between << 1., 0., -1., 0., 0., 1., 0., 1.;
  LocalProblem stops;
  stops.dimension = 2;
  stops.W = Eigen::MatrixXd(of_W * between.transpose() * between).sparseView(0., 0.);
  stops.q = of_q * Eigen::Vector4d(-1., 0., -1., 0.);
  stops.friction = Eigen::VectorXd::Constant(2, 0.3);
  const LocalSolution squeezed = solve_local_contact(stops, 1e-8);
  CHECK(!squeezed.converged && squeezed.residual.own_scale > 0.1);
  Eigen::VectorXd huge(4);
  huge << 1., 0., 1., 0.;
  CHECK(!evaluate_residual(stops, 1e15 * of_q / of_W * huge).holds(1e-8));

  LocalProblem rigid = one_contact({-of_q, 3. * of_q, 4. * of_q});
  rigid.W = of_W * rigid.W;
  rigid.W.coeffRef(0, 0) = 0.;
  CHECK(!solve_local_contact(rigid, 1e-8).converged);

  // Beside them, and not coupled with them, contacts that are solved, of another size.
  LocalProblem both = stops;
  std::vector<Eigen::Triplet<double>> entries;
  for (int column = 0; column < 4; ++column)
    for (Eigen::SparseMatrix<double>::InnerIterator entry(stops.W, column); entry; ++entry)
      entries.emplace_back(entry.row(), column, entry.value());
  entries.emplace_back(4, 4, of_W);
  entries.emplace_back(5, 5, of_W);
  both.W.resize(6, 6);
  both.W.setFromTriplets(entries.begin(), entries.end());
  both.q.resize(6);
  both.q << stops.q, -1e9 * of_q, 0.;
  both.friction = Eigen::VectorXd::Constant(3, 0.3);
  CHECK(!solve_local_contact(both, 1e-8).converged);
}

/// Four planar contacts on a body with four motions, one of 4000 random ones: neither sweeps nor
/// Newton's steps find its solution, 0 and 3 stick, 1 and 2 are open.
contact::LocalProblem planar_problem() {
  Eigen::MatrixXd W(8, 8);
  W << 2.555979575553804e-06, -1.6897417127682807e-06, 4.672104250188842e-07,
      6.4784560978858789e-08, 1.7199498592794795e-06, 5.8471097886592889e-08,
      -3.8020307929296602e-06, 4.4400117417431856e-07, -1.6897417127682807e-06,
      3.6092692799577287e-06, 1.4273223295732658e-06, -2.1658717643755659e-06,
      -7.0454026423790904e-07, -2.7299152515808153e-07, 2.2417490265099031e-06,
      9.8094697578415414e-07, 4.672104250188842e-07, 1.4273223295732658e-06, 5.2480924762050184e-06,
      -2.0386567223293192e-06, 1.370446766359091e-06, 8.2911578402035686e-07,
      1.3551370810891637e-07, 1.137946465620464e-06, 6.4784560978858789e-08,
      -2.1658717643755659e-06, -2.0386567223293192e-06, 3.0765807677266053e-06,
      1.1405316863522917e-06, 5.3906135810561353e-07, -5.2073135511100681e-07,
      -3.6932591446868799e-07, 1.7199498592794795e-06, -7.0454026423790904e-07,
      1.370446766359091e-06, 1.1405316863522917e-06, 3.4707327052115689e-06, 8.2436372974024372e-07,
      -3.0871528294980678e-06, 1.5225458383367471e-06, 5.8471097886592889e-08,
      -2.7299152515808153e-07, 8.2911578402035686e-07, 5.3906135810561353e-07,
      8.2436372974024372e-07, 4.6167612585416127e-07, -1.4286859184222705e-08,
      2.2800525156062783e-07, -3.8020307929296602e-06, 2.2417490265099031e-06,
      1.3551370810891637e-07, -5.2073135511100681e-07, -3.0871528294980678e-06,
      -1.4286859184222705e-08, 6.1666303106738795e-06, -1.0691902840687848e-06,
      4.4400117417431856e-07, 9.8094697578415414e-07, 1.137946465620464e-06,
      -3.6932591446868799e-07, 1.5225458383367471e-06, 2.2800525156062783e-07,
      -1.0691902840687848e-06, 1.1857003565722635e-06;
  contact::LocalProblem problem;
  problem.dimension = 2;
  problem.W = ((W + W.transpose()) / 2.).sparseView();
  problem.q.resize(8);
  problem.q << -0.00058283117551475108, -0.0015255535396942934, -0.00070637831274959805,
      -0.0005477948367167793, -0.0012719885398728189, 0.00044902948139124342,
      -0.00080815920387406837, -0.0010960172410936374;
  problem.friction.resize(4);
  problem.friction << 1.5, 0.1, 5., 1.5;
  return problem;
}

void few_planar_contacts_are_solved() {
  const contact::LocalSolution solution = solve_local_contact(planar_problem(), 1e-9, 10.);
  CHECK(solution.converged);
  CHECK(solution.reactions[2] == 0. && solution.reactions[4] == 0.);
  CHECK(solution.motions.head<2>().norm() < 1e-12 && solution.motions.tail<2>().norm() < 1e-12);
}

} // namespace

int local_contact_solver(int, char **) {
  few_planar_contacts_are_solved();
  const auto open = contact::solve_local_contact(one_contact({1., 0.3, 0.}), 1e-12);
  CHECK(open.converged && open.reactions.norm() == 0.);

  // r_N = 2 closes the gap of -4; to hold 0.6 takes T = 0.6 < 0.5 * 2.
  const auto sticks = contact::solve_local_contact(one_contact({-4., 0.6, 0.}), 1e-12);
  CHECK(sticks.converged);
  CHECK_NEAR((sticks.reactions - Eigen::Vector3d(2., -0.6, 0.)).norm(), 0., 1e-12);

  // To hold (3, 4) would take 5 > 1: T = -(3, 4)/5, slip 4/5 of it.
  const auto slips = contact::solve_local_contact(one_contact({-4., 3., 4.}), 1e-12);
  CHECK(slips.converged);
  CHECK_NEAR((slips.reactions - Eigen::Vector3d(2., -0.6, -0.8)).norm(), 0., 1e-12);
  CHECK_NEAR((slips.motions - Eigen::Vector3d(0., 2.4, 3.2)).norm(), 0., 1e-11);

  for (unsigned int seed = 1; seed <= 20; ++seed) {
    const contact::LocalProblem problem = random_problem(seed, 1 + seed % 10);
    laws_hold(problem, contact::solve_local_contact(problem, 1e-10));
  }
  one_stiff_contact();
  for (unsigned int seed = 1; seed <= 20; ++seed)
    one_small_force(seed);
  tall_stack();
  for (const double of_W : {1., 1e-3, 1e-6, 1e-9, 1e-12})
    for (const double of_q : {1., 1e-3, 1e-6})
      no_solution(of_W, of_q);
  out_of_time();
  return check::report();
}
