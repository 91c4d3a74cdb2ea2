// SPDX-License-Identifier: LGPL-2.1-or-later
// Condensing a line onto the nodes of its contacts is elimination: S is the Schur complement of the
// stiffness, and what is solved on S and expanded solves the whole line.
#include "../check.h"
#include "line_from.h"

#include <frictionbeam/contact/condensation.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>

using namespace frictionbeam;

int main() {
  // Two rests, a bend between them and cells that no contact touches.
  const LineFrom line(R"(
subsection Material steel
end
subsection Section pipe
  set Outer diameter = 0.2
  set Wall = 0.01
end
subsection Pipe main
  set Route = A 0 0 0; P 4 0 0; 8 0 0 bend 1; Q 8 6 0; B 8 9 0
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
  set At = P, Q
  set Friction coefficient = 0.3
end
subsection Load weight
end
subsection Step weight
  set Loads = weight
end
)");
  const SparseMatrix &K = line.model.linear.stiffness();
  std::vector<int> keep;
  for (unsigned int i = 0; i < line.model.contacts.size(); ++i)
    keep.insert(keep.end(), line.model.contacts[i].vertex_unknowns.begin(),
                line.model.contacts[i].vertex_unknowns.end());
  const auto condensation = contact::condense_parts(K, keep);
  const contact::Condensation &condensed = *condensation;
  const Eigen::MatrixXd dense(K), S(condensed.matrix());
  const int n = K.rows(), n_kept = condensed.n_kept();
  CHECK(n_kept == 12); // six motions of each of two nodes
  CHECK(n > 5 * n_kept);

  // Rows and columns of the inverse that belong to kept unknowns are the inverse of S.
  const Eigen::MatrixXd inverse = dense.ldlt().solve(Eigen::MatrixXd::Identity(n, n));
  Eigen::MatrixXd kept(n_kept, n_kept);
  for (const Contact *contact : {&line.model.contacts[0], &line.model.contacts[1]})
    for (const Contact *other : {&line.model.contacts[0], &line.model.contacts[1]})
      for (const int i : contact->unknowns)
        for (const int k : other->unknowns)
          kept(condensed.place(i), condensed.place(k)) = inverse(i, k);
  const Eigen::MatrixXd S_inverse = S.inverse();
  for (const Contact *contact : {&line.model.contacts[0], &line.model.contacts[1]})
    for (const int i : contact->unknowns) {
      const int place = condensed.place(i);
      CHECK_NEAR(S_inverse(place, place), kept(place, place), 1e-9);
    }

  Vector forces = Vector::LinSpaced(n, -1e3, 2e3);
  const Vector all = condensed.expand(S.ldlt().solve(condensed.condense(forces)), forces);
  const Vector exact = dense.ldlt().solve(forces);
  CHECK_NEAR((all - exact).norm() / exact.norm(), 0., 1e-9);
  CHECK_NEAR((dense * all - forces).norm() / forces.norm(), 0., 1e-7);
  return check::report();
}
