// SPDX-License-Identifier: LGPL-2.1-or-later
// A straight cell's matrices shall be those of the first cell of its section and length, turned:
// the same as of an element that evaluates each cell by itself, in any direction of space, and
// whatever cell came before, an arc as well.
#include "../check.h"
#include "line_from.h"

#include "model/line/pipe_element.h"

#include <deal.II/base/quadrature_lib.h>

#include <set>

using namespace frictionbeam;

namespace {

// Two sections; legs of 3 m in many directions, one of another length, a bend.
const char *const text = R"(
subsection Material steel
  set Density = 7850
end
subsection Section wide
  set Outer diameter = 0.3
  set Wall = 0.01
end
subsection Section narrow
  set Outer diameter = 0.1
  set Wall = 0.005
end
subsection Pipe main
  set Section = wide
  set Route = A 0.1 0.2 0.3; by 3 0 0; by 0 3 0; by 0 0 3; by 1 2 2; by -2 1 2; by 1 -2 2; C by 0 0 -4; \\
              by 2 0 0 bend 0.5; by 0 2 1
end
subsection Pipe branch
  set Section = narrow
  set Route = C; by 2 -1 -2; by -1 2 2; by 0 0 -3
end
subsection Support clamp
  set Kind = anchor
  set At = A
end
subsection Load weight
end
subsection Step weight
  set Loads = weight
end
)";

void compare(const std::string &bends, const std::size_t n_kinds) {
  const LineFrom line(text + ("subsection Mesh\n  set Bends = " + bends + "\nend\n"));
  const Discretization &discretization = line.model.discretization;
  PipeElement taken(discretization);
  PipeElement evaluated(discretization, dealii::QGauss<1>(2), dealii::QGauss<1>(12));
  const auto distance = [](const auto &a, const auto &b) { return (a - b).norm() / b.norm(); };
  // Of pieces of 0.1 m at places of 10 m: their lengths are known to 1e-14, their stiffness by the
  // cube of it.
  constexpr double rounding = 1e-12;
  std::set<unsigned int> kinds;
  for (unsigned int i = 0; i < discretization.pipe_cells().size(); ++i) {
    const auto cell = discretization.pipe_cell(i);
    taken.reinit(cell);
    if (!taken.arc())
      kinds.insert(discretization.like(cell)->active_cell_index());
    evaluated.reinit(cell);
    CHECK_NEAR(distance(taken.stiffness(), evaluated.stiffness()), 0., rounding);
    CHECK_NEAR(distance(taken.unit_line_loads(), evaluated.unit_line_loads()), 0., rounding);
    CHECK_NEAR(distance(taken.unit_axial_strain(), evaluated.unit_axial_strain()), 0., rounding);
    CHECK_NEAR(distance(taken.mass(cell), evaluated.mass(cell)), 0., rounding);
  }
  CHECK(kinds.size() == n_kinds);
}

} // namespace

int like_cells(int, char **) {
  // Of the wide one: 3 m, 4 m, two ends of legs beside the bend and the bend's pieces; one narrow.
  compare("straight pieces", 6);
  compare("arcs", 5);
  return check::report();
}
