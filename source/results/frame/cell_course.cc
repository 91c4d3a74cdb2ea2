// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/frame/cell_course.h"

#include <cmath>

namespace frictionbeam {

using namespace dealii;

namespace {

/// Forces on the ends as F, M and q of a course over a length.
CellCourse without_couple(const PipeElement::Vector12 &ends, const double length) {
  CellCourse course = CellCourse::Zero();
  course.head<6>() = -ends.head<6>();
  course.segment<3>(6) = -(ends.head<3>() + ends.segment<3>(6)) / length;
  return course;
}

/// The couple per length that is missing for the moment on the other end.
void close(const PipeElement::Vector12 &ends, const Vector3 &moment, const double length,
           CellCourse &course) {
  for (unsigned int d = 0; d < 3; ++d)
    course[9 + d] = (ends[9 + d] - moment[d]) / length;
}

} // namespace

Vector3 part_of(const CellCourse &course, const unsigned int first) {
  return Vector3({course[first], course[first + 1], course[first + 2]});
}

CellCourse course_of(const Eigen::Matrix<double, 6, 1> &section, const Vector3 &line_force) {
  CellCourse course = CellCourse::Zero();
  course.head<6>() = section;
  for (unsigned int d = 0; d < 3; ++d)
    course[6 + d] = line_force[d];
  return course;
}

CellCourse course_in_balance(const PipeElement::Vector12 &ends, const Eigen::Vector3d &axis) {
  const double length = axis.norm();
  CellCourse course = without_couple(ends, length);
  const Vector3 along({axis[0] / length, axis[1] / length, axis[2] / length});
  close(ends, section_of_straight(course, along, length).second, length, course);
  return course;
}

CellCourse course_in_balance(const PipeElement::Vector12 &ends, const ArcBeam &arc) {
  const double length = arc.radius() * arc.angle();
  CellCourse course = without_couple(ends, length);
  close(ends, section_of_arc(course, arc, arc.angle()).second, length, course);
  return course;
}

std::pair<Vector3, Vector3> section_of_straight(const CellCourse &course, const Vector3 &along,
                                                const double distance) {
  const Vector3 F = part_of(course, 0), q = part_of(course, 6);
  return {F - distance * q,
          part_of(course, 3) -
              cross_product_3d(along, distance * F - distance * distance / 2. * q) +
              distance * part_of(course, 9)};
}

std::pair<Vector3, Vector3> section_of_arc(const CellCourse &course, const ArcBeam &arc,
                                           const double psi) {
  // Equilibrium of what lies between the cell's beginning and the section: q acts on each slice.
  const Vector3 F = part_of(course, 0), q = part_of(course, 6),
                arm = arc.point(psi) - arc.point(0.);
  const double R = arc.radius();
  const Vector3 slices =
      psi * R * arm -
      R * R * ((1. - std::cos(psi)) * arc.tangent(0.) + (psi - std::sin(psi)) * arc.inward(0.));
  return {F - psi * R * q, part_of(course, 3) - cross_product_3d(arm, F) +
                               cross_product_3d(slices, q) + psi * R * part_of(course, 9)};
}

} // namespace frictionbeam
