// SPDX-License-Identifier: LGPL-2.1-or-later
// Condensing a line onto the nodes of its contacts is elimination: S is the Schur complement of the
// stiffness, and what is solved on S and expanded solves the whole line. Also of equal spans, which
// are eliminated once.
#include "../check.h"
#include "line_from.h"

#include <frictionbeam/contact/condensation.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>

using namespace frictionbeam;

namespace {

/// @param route of a pipe from A @param rests points of it
LineFrom line_of(const std::string &route, const std::string &rests) {
  return LineFrom(R"(
subsection Material steel
end
subsection Section pipe
  set Outer diameter = 0.2
  set Wall = 0.01
end
subsection Pipe main
  set Route = )" + route +
                  R"(
end
subsection Mesh
  set Cell length = 1
end
subsection Support end
  set Kind = anchor
  set At = A
end
subsection Support rests
  set Kind = rest
  set At = )" + rests +
                  R"(
  set Friction coefficient = 0.3
end
subsection Load weight
end
subsection Step weight
  set Loads = weight
end
)");
}

void check_line(const LineFrom &line, const int n_rests) {
  const SparseMatrix &K = line.model.linear.stiffness();
  const Contacts &contacts = line.model.contacts;
  std::vector<int> keep;
  for (unsigned int i = 0; i < contacts.size(); ++i)
    keep.insert(keep.end(), contacts[i].vertex_unknowns.begin(), contacts[i].vertex_unknowns.end());
  const auto condensation = contact::condense_parts(K, keep);
  const contact::Condensation &condensed = *condensation;
  const Eigen::MatrixXd dense(K), S(condensed.matrix());
  const int n = K.rows(), n_kept = condensed.n_kept();
  CHECK(n_kept == 6 * n_rests); // six motions of each node
  CHECK(n > 2 * n_kept);

  // Rows and columns of the inverse that belong to kept unknowns are the inverse of S.
  const Eigen::MatrixXd inverse = dense.ldlt().solve(Eigen::MatrixXd::Identity(n, n)),
                        S_inverse = S.inverse();
  for (const int i : keep)
    for (const int k : keep)
      CHECK_NEAR((S_inverse(condensed.place(i), condensed.place(k)) - inverse(i, k)) /
                     std::sqrt(inverse(i, i) * inverse(k, k)),
                 0., 1e-9);

  Vector forces = Vector::LinSpaced(n, -1e3, 2e3);
  const Vector all = condensed.expand(S.ldlt().solve(condensed.condense(forces)), forces);
  const Vector exact = dense.ldlt().solve(forces);
  CHECK_NEAR((all - exact).norm() / exact.norm(), 0., 1e-9);
  CHECK_NEAR((dense * all - forces).norm() / forces.norm(), 0., 1e-7);
}

} // namespace

int condensed_line(int, char **) {
  // Two rests, a bend between them and cells that no contact touches.
  check_line(line_of("A 0 0 0; P 4 0 0; 8 0 0 bend 1; Q 8 6 0; B 8 9 0", "P, Q"), 2);
  // Spans of 4 m, equal along x and along y.
  check_line(line_of("A 0 0 0; P 4 0 0; Q 8 0 0; R 12 0 0; S 12 4 0; T 12 8 0; B 12 12 0",
                     "P, Q, R, S, T"),
             5);
  return check::report();
}
