// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/contact/ground_point.h"

#include "base/numbers.h"
#include "base/user_error.h"

namespace frictionbeam {

using namespace dealii;

Vector3 arm_of_ground(const Discretization &discretization, const Contact &contact) {
  const Vector3 way = discretization.vertices()[contact.vertices[0]] -
                      discretization.vertices()[contact.vertices[1]];
  const Vector3 arm = way - (way * contact.axes.x) * contact.axes.x;
  return arm.norm() > same_place * way.norm() ? arm : Vector3();
}

void stand_on_point(const FrictionSupport &support, const Discretization &discretization,
                    Contact &contact) {
  using Rotations = FrictionSupport::Rotations;
  using Column = Contact::Strains;
  const Vector3 arm = arm_of_ground(discretization, contact);
  const LocalAxes &axes = contact.axes;
  std::vector<Column> columns;
  contact.dofs.clear();
  for (const bool is_ground : {false, true})
    for (unsigned int c = 0; c < 6; ++c) {
      const auto dof = discretization.vertex_dofs().index(contact.vertices[is_ground ? 1 : 0], c);
      if (dof == numbers::invalid_dof_index ||
          (c >= 3 && !discretization.turns(contact.vertices[is_ground ? 1 : 0], c - 3)))
        continue;
      Vector3 unit;
      unit[c % 3] = 1.;
      const double slope = (is_ground ? 1. : -1.) / contact.length;
      Column column = Column::Zero();
      const auto move = [&](const Vector3 &motion) {
        column += slope * Column(axes.x * motion, axes.y * motion, axes.z * motion, 0.);
      };
      if (c < 3)
        move(unit);
      else {
        if (is_ground)
          move(cross_product_3d(unit, arm));
        // Of two ends of which one is a point that cannot turn, the other carries the couple.
        const bool other_turns = discretization.turns(contact.vertices[is_ground ? 0 : 1], c - 3);
        const double part = support.rotations == Rotations::averaged ? (other_turns ? 0.5 : 1.)
                            : support.rotations == Rotations::pipe && !is_ground ? 1.
                                                                                 : 0.;
        column += Column(0., -part * (axes.z * unit), part * (axes.y * unit),
                         support.torsion ? slope * (axes.x * unit) : 0.);
      }
      if (column.isZero(0.))
        continue;
      contact.dofs.push_back(dof);
      columns.push_back(column);
    }
  contact.B_dofs.resize(n_support_strains, columns.size());
  for (unsigned int i = 0; i < columns.size(); ++i)
    contact.B_dofs.col(i) = columns[i];
}

} // namespace frictionbeam
