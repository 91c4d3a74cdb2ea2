// SPDX-License-Identifier: LGPL-2.1-or-later
// A line that holds less memory shall have the same numbers, to the last bit: its stiffness with
// all places again, forces by it in extended precision, and the solution of its steps, also where
// its contact method has been put away in between.
#include "../check.h"
#include "line_from.h"

#include "analysis/sequence/load_sequence.h"
#include "analysis/statics/linear_statics.h"

#include <frictionbeam/contact/problem.h>

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

int main() {
  const LineFrom whole(text);
  LineModel lean(whole.scene, whole.laws);
  lean.hold_less();
  const LinearPart &all = whole.model.linear, &less = lean.model().linear;
  const SparseMatrix &K = all.stiffness();
  CHECK(all.has_all_places() && !less.has_all_places());
  CHECK(less.stiffness().nonZeros() < 0.6 * K.nonZeros());
  const SparseMatrix again = less.stiffness_with_places();
  CHECK(again.nonZeros() == K.nonZeros());
  CHECK(std::equal(K.valuePtr(), K.valuePtr() + K.nonZeros(), again.valuePtr()));
  CHECK(std::equal(K.innerIndexPtr(), K.innerIndexPtr() + K.nonZeros(), again.innerIndexPtr()));
  CHECK(std::equal(K.outerIndexPtr(), K.outerIndexPtr() + K.rows() + 1, again.outerIndexPtr()));

  std::srand(7); // of Eigen's random vectors
  for (int i = 0; i < 20; ++i) {
    const Vector forces = 1e4 * Vector::Random(K.rows()), motion = Vector::Random(K.rows()),
                 low = 1e-17 * Vector::Random(K.rows());
    CHECK(less.unbalanced(forces, motion, low) ==
          contact::unbalanced_forces({K, forces}, motion, low));
  }

  const Vector motions = solve(whole.model, false);
  CHECK(motions.norm() > 0.);
  CHECK(solve(lean.model(), false) == motions);
  CHECK(solve(lean.model(), true) == motions);
  return check::report();
}
