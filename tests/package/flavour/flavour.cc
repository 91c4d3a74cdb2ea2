// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A line of two cells, and Eigen's headers, which those of contact include.
#include <frictionbeam/contact/matrix.h>
#include <frictionbeam/fe_friction_beam.h>
#include <frictionbeam/line_triangulation.h>

int main() {
  using namespace dealii;
  Triangulation<1, 3> triangulation;
  frictionbeam::create_line_triangulation({Point<3>(0, 0, 0), Point<3>(1, 0, 0), Point<3>(2, 0, 0)},
                                          {{{{0, 1}}, 0}, {{{1, 2}}, 1}}, triangulation);
  const frictionbeam::FE_FrictionBeam element;
  const frictionbeam::contact::Vector forces = frictionbeam::contact::Vector::Zero(3);
  return triangulation.n_active_cells() == 2 && element.n_dofs_per_cell() == 6 && forces.size() == 3
             ? 0
             : 1;
}
