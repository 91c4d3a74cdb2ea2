// SPDX-License-Identifier: LGPL-2.1-or-later
// What the contact library costs, on a line and on a block: seconds of set-up and of four
// increments.
//   build/bin/benchmark_contact_cost [LARGEST = 10000]
#include <frictionbeam/contact/solver.h>
#include <frictionbeam/law_library.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <iostream>

using namespace frictionbeam;
using Vector = contact::Vector;
using Entries = std::vector<Eigen::Triplet<double>>;

namespace {

struct Body {
  Eigen::SparseMatrix<double> K;
  std::vector<unsigned int> on_floor; ///< nodes, of three unknowns each
  Vector press, push;
};

Eigen::SparseMatrix<double> matrix_of(const Entries &entries, const unsigned int n) {
  Eigen::SparseMatrix<double> K(n, n);
  K.setFromTriplets(entries.begin(), entries.end());
  return K;
}

/// Nodes in a row on a floor, coupled by springs along it and, weakly, across, pushed along.
Body line(const unsigned int n) {
  Entries entries;
  const double stiffness[3] = {1e6, 1e4, 1e4};
  for (unsigned int i = 0; i + 1 < n; ++i)
    for (unsigned int d = 0; d < 3; ++d) {
      const unsigned int a = 3 * i + d, b = a + 3;
      entries.emplace_back(a, a, stiffness[d]);
      entries.emplace_back(b, b, stiffness[d]);
      entries.emplace_back(a, b, -stiffness[d]);
      entries.emplace_back(b, a, -stiffness[d]);
    }
  for (unsigned int d = 0; d < 3; ++d)
    entries.emplace_back(d, d, 1e6);
  Body body{matrix_of(entries, 3 * n), {}, Vector::Zero(3 * n), Vector::Zero(3 * n)};
  for (unsigned int i = 0; i < n; ++i) {
    body.on_floor.push_back(i);
    body.press[3 * i + 2] = -100.;
  }
  body.push[3 * n - 3] = 25. * n; // of 30 that friction holds, from the far end
  return body;
}

/// Stiffness of a unit cube of Young's modulus 1e6 and Poisson's ratio 0.3, trilinear, by 2 x 2 x 2
/// points.
Eigen::Matrix<double, 24, 24> cube() {
  const double E = 1e6, nu = 0.3, mu = E / 2. / (1. + nu), lambda = 2. * mu * nu / (1. - 2. * nu),
               g = 0.5 / std::sqrt(3.);
  Eigen::Matrix<double, 24, 24> K = Eigen::Matrix<double, 24, 24>::Zero();
  for (int q = 0; q < 8; ++q) {
    const double at[3] = {0.5 + (q & 1 ? g : -g), 0.5 + (q & 2 ? g : -g), 0.5 + (q & 4 ? g : -g)};
    Eigen::Matrix<double, 8, 3> gradient;
    for (int v = 0; v < 8; ++v)
      for (int d = 0; d < 3; ++d) {
        gradient(v, d) = 1.;
        for (int e = 0; e < 3; ++e) {
          const bool up = v >> e & 1;
          gradient(v, d) *= e == d ? (up ? 1. : -1.) : (up ? at[e] : 1. - at[e]);
        }
      }
    for (int a = 0; a < 8; ++a)
      for (int b = 0; b < 8; ++b)
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j)
            K(3 * a + i, 3 * b + j) +=
                (lambda * gradient(a, i) * gradient(b, j) + mu * gradient(a, j) * gradient(b, i) +
                 (i == j ? mu * gradient.row(a).dot(gradient.row(b)) : 0.)) /
                8.;
  }
  return K;
}

/// 4 n x 2 n x n unit cubes on a floor, held by friction alone, pressed and pushed at the top.
Body block(const unsigned int n) {
  const unsigned int nx = 4 * n + 1, ny = 2 * n + 1, nz = n + 1, size = 3 * nx * ny * nz;
  const auto node = [&](unsigned int x, unsigned int y, unsigned int z) {
    return (z * ny + y) * nx + x;
  };
  const Eigen::Matrix<double, 24, 24> of_cube = cube();
  Entries entries;
  for (unsigned int z = 0; z + 1 < nz; ++z)
    for (unsigned int y = 0; y + 1 < ny; ++y)
      for (unsigned int x = 0; x + 1 < nx; ++x)
        for (int a = 0; a < 24; ++a)
          for (int b = 0; b < 24; ++b) {
            const auto of = [&](const int k) {
              const int v = k / 3;
              return 3 * node(x + (v & 1), y + (v >> 1 & 1), z + (v >> 2 & 1)) + k % 3;
            };
            entries.emplace_back(of(a), of(b), of_cube(a, b));
          }
  Body body{matrix_of(entries, size), {}, Vector::Zero(size), Vector::Zero(size)};
  for (unsigned int y = 0; y < ny; ++y)
    for (unsigned int x = 0; x < nx; ++x) {
      body.on_floor.push_back(node(x, y, 0));
      body.press[3 * node(x, y, nz - 1) + 2] = -100.;
      body.push[3 * node(x, y, nz - 1)] = 25.; // of 30 that friction holds
    }
  return body;
}

double seconds_since(const std::chrono::steady_clock::time_point &start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

bool run(const std::string &name, const Body &body, const LawDescription &law) {
  std::vector<contact::Contact> contacts;
  for (const unsigned int node : body.on_floor)
    contacts.push_back(contact::on_ground({3 * node, 3 * node + 1, 3 * node + 2}, {0., 0., -1.},
                                          law, default_parameters(law)));
  const auto start = std::chrono::steady_clock::now();
  contact::Solver solver(contact::system_of(body.K), contacts);
  solver.most_contacts_for_uniqueness = 0;
  const double setup = seconds_since(start);
  contact::ContactMemory memory = solver.initial_memory();
  Vector u;
  const auto solution = std::chrono::steady_clock::now();
  unsigned int factorizations = 0, n_slip = 0;
  for (const double share : {0., 0.5, 1., 0.2}) {
    const contact::Report report = solver.solve(body.press + share * body.push, memory, u, memory);
    factorizations += report.factorizations;
    if (!report.converged) {
      std::cout << name << ": " << report.remark << '\n';
      return false;
    }
    n_slip = 0;
    for (const contact::ContactState &state : report.contacts)
      n_slip += state.status == ContactStatus::slip ? 1 : 0;
  }
  std::cout << "| " << name << " | " << contacts.size() << " | " << body.K.rows() << " | "
            << std::setprecision(2) << setup << " | " << seconds_since(solution) / 4. << " | "
            << factorizations / 4. << " |\n";
  return true;
}

} // namespace

int main(int argc, char **argv) {
  const unsigned int largest = argc > 1 ? std::atoi(argv[1]) : 10000;
  LawLibrary laws;
  laws.load_builtin();
  const LawDescription &law = laws.find("coulomb");
  std::cout
      << "| body | contacts | unknowns | set-up [s] | an increment [s] | factorizations of an "
         "increment |\n| --- | --- | --- | --- | --- | --- |\n";
  bool solved = true;
  for (unsigned int n = 10; n <= largest; n *= 10)
    solved = run("line", line(n), law) && solved;
  for (const unsigned int n : {1, 2, 4, 8})
    if ((4 * n + 1) * (2 * n + 1) <= largest)
      solved = run("block", block(n), law) && solved;
  return solved ? 0 : 1;
}
