// SPDX-License-Identifier: LGPL-2.1-or-later
// The stiffness of a line that neither turns nor yields shall have no zeros but the places of its
// contacts and its diagonal, and the numbers of one that has places for all that cells may couple.
// A sequence that puts its contact method away in between shall come to the same numbers, to the
// last bit.
#include "../check.h"
#include "line_from.h"

#include "analysis/sequence/load_sequence.h"
#include "analysis/statics/linear_statics.h"

#include <algorithm>
#include <set>

using namespace frictionbeam;

namespace {

// Along the axes, up, and skew; rests with friction and a guide.
const char *const text = R"(
subsection Material steel
end
subsection Section pipe
  set Outer diameter = 0.2191
  set Wall = 0.0082
end
subsection Pipe main
  set Section = pipe
  set Route = A 0 0 0; by 30 0 0; by 0 12 0; by 0 0 5; B by 6 3 1
end
subsection Support anchor
  set Kind = anchor
  set At = A, B
end
subsection Support rests
  set Kind = rest
  set Pipe = main
  set Every = 6
  set Friction coefficient = 0.3
end
subsection Load weight
end
subsection Load heat
  set Kind = temperature
  set Temperature = 90
end
subsection Step weight
  set Loads = weight
end
subsection Step hot
  set Loads = weight, heat
  set Increments = 5
end
subsection Step cold
  set Loads = weight
  set Increments = 3
end
)";

/// The motions at the end of the steps.
Vector solve(const Model &model, const bool rests_between) {
  LinearStatics statics(model);
  LoadSequence sequence(model, statics);
  const auto rest = [&](const Progress &, const LineState &) {
    if (rests_between)
      statics.hold_less();
  };
  CHECK(sequence.run(rest));
  return sequence.state().unknowns;
}

} // namespace

int places_of_stiffness(int, char **) {
  const LineFrom line(text), turning(std::string("set Kinematics = corotational\n") + text);
  const SparseMatrix &K = line.model.linear.stiffness(), &all = turning.model.linear.stiffness();
  CHECK(K.nonZeros() < 0.6 * all.nonZeros());
  CHECK(SparseMatrix(K - all).coeffs().isZero(0.));

  std::set<std::pair<int, int>> of_contacts;
  for (unsigned int i = 0; i < line.model.contacts.size(); ++i) {
    std::vector<int> unknowns = line.model.contacts[i].unknowns;
    const std::vector<int> &others = line.model.contacts[i].vertex_unknowns;
    unknowns.insert(unknowns.end(), others.begin(), others.end());
    for (const int row : unknowns)
      for (const int column : unknowns)
        of_contacts.emplace(row, column);
  }
  for (int row = 0; row < K.rows(); ++row)
    for (SparseMatrix::InnerIterator entry(K, row); entry; ++entry)
      if (entry.value() == 0.)
        CHECK(entry.col() == row || of_contacts.count({row, entry.col()}) > 0 ||
              K.coeff(entry.col(), row) != 0.);
  for (int row = 0; row < K.rows(); ++row) // symmetric
    for (SparseMatrix::InnerIterator entry(K, row); entry; ++entry)
      CHECK(std::binary_search(K.innerIndexPtr() + K.outerIndexPtr()[entry.col()],
                               K.innerIndexPtr() + K.outerIndexPtr()[entry.col() + 1], row));
  for (const auto &[row, column] : of_contacts)
    CHECK(std::binary_search(K.innerIndexPtr() + K.outerIndexPtr()[row],
                             K.innerIndexPtr() + K.outerIndexPtr()[row + 1], column));

  const Vector motions = solve(line.model, false);
  CHECK(motions.norm() > 0.);
  CHECK(solve(line.model, true) == motions);
  return check::report();
}
