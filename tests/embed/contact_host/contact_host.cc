// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A mass on a spring is pressed on a floor and pulled along it: exact contact with Eigen alone.
#include <frictionbeam/contact/solver.h>
#include <frictionbeam/law_library.h>

#include <cmath>
#include <iostream>

using namespace frictionbeam;

int main() {
  const double k = 1e3, f = 0.3, press = 100.; // [N/m], [-], [N]
  Eigen::SparseMatrix<double> K(3, 3);
  K.insert(0, 0) = k; // along the floor; nothing else holds it
  LawLibrary laws;
  laws.load_builtin();
  const LawDescription &law = laws.find("coulomb");
  std::vector<double> parameters = default_parameters(law);
  parameters[parameter_index(law, "Friction coefficient")] = f;
  contact::Solver solver(contact::system_of(K),
                         {contact::on_ground({0, 1, 2}, {0., 0., -1.}, law, parameters)});
  contact::ContactMemory memory = solver.initial_memory();
  contact::Vector u;
  bool passed = true;
  double expected = 0.; // the spring has what friction does not hold
  for (const double pull : {20., 50., 10., -40.}) {
    const contact::Report report =
        solver.solve(contact::Vector3(pull, 0., -press), memory, u, memory);
    if (!report.converged) {
      std::cout << report.remark << '\n';
      return 1;
    }
    expected = std::max((pull - f * press) / k, std::min((pull + f * press) / k, expected));
    passed = passed && std::abs(u[0] - expected) < 1e-12;
    std::cout << "pulled by " << pull << " N it is at " << u[0] << " m, the floor holds "
              << -report.contacts[0].force[0] << " N\n";
  }
  return passed ? 0 : 1;
}
