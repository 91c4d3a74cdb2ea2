// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/contact/ground_point.h"

#include "base/numbers.h"
#include "base/user_error.h"

#include <cmath>

namespace frictionbeam {

using namespace dealii;

Vector3 arm_of_ground(const Discretization &discretization, const Contact &contact) {
  const Vector3 way = discretization.vertices()[contact.vertices[0]] -
                      discretization.vertices()[contact.vertices[1]];
  const Vector3 arm = way - (way * contact.axes.x) * contact.axes.x;
  return arm.norm() > same_place * way.norm() ? arm : Vector3();
}

namespace {

/// What of the way along the normal the element's length leaves, towards the pipe [m].
Vector3 rest_along_normal(const Discretization &discretization, const Contact &contact) {
  const Vector3 way = discretization.vertices()[contact.vertices[0]] -
                      discretization.vertices()[contact.vertices[1]];
  const double rest = way * contact.axes.x + contact.length;
  return std::abs(rest) > same_place * way.norm() ? rest * contact.axes.x : Vector3();
}

} // namespace

void stand_on_point(const FrictionSupport &support, const Discretization &discretization,
                    Contact &contact) {
  using Rotations = FrictionSupport::Rotations;
  using Column = Contact::Strains;
  const LocalAxes &axes = contact.axes;
  const Vector3 arm = arm_of_ground(discretization, contact),
                along = support.rotations == Rotations::none
                            ? Vector3()
                            : rest_along_normal(discretization, contact);
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
        // Of two ends of which one is a point that cannot turn, the other carries the couple.
        const bool other_turns = discretization.turns(contact.vertices[is_ground ? 0 : 1], c - 3);
        if (is_ground)
          move(cross_product_3d(unit, arm + along));
        else if (!other_turns)
          move(cross_product_3d(unit, -along));
        const double part = support.rotations == Rotations::none       ? 0.
                            : !other_turns                             ? 1.
                            : support.rotations == Rotations::averaged ? 0.5
                            : is_ground                                ? 0.
                                                                       : 1.;
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
