// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/algebra/dense_algebra.h"
#include "scene/catalogue/catalogue_entries.h"
#include "scene/part/parts.h"

#include <frictionbeam/generalized_strain.h>

#include <Eigen/Cholesky>

#include <algorithm>

namespace frictionbeam::parts {

namespace {

/// Six numbers, or three for the translations alone, in @p units. @p angles: rotations are given
/// in degrees.
Motion parse_motion(const ParameterReader &in, const std::string &entry, const bool angles,
                    const std::array<const char *, 2> &units) {
  const std::vector<double> values = in.numbers(entry);
  if (values.size() != 3 && values.size() != 6)
    in.fail(entry, "three numbers, or six with the rotations", "'0 0 0'");
  Motion motion{};
  for (unsigned int i = 0; i < values.size(); ++i)
    motion[i] = in.in_bounds(
        entry, values[i] * in.si(entry, units[i / 3]) * (angles && i >= 3 ? degree : 1.),
        units[i / 3]);
  return motion;
}

using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// Rows of a stiffness in SI units, checked.
Matrix6 parse_matrix(const ParameterReader &in) {
  constexpr double rounding = 1e-9; // of entries by the diagonal's
  const std::string form = "six rows of six numbers, rows separated by ';'",
                    example = "'1e6 0 0 0 0 0; 0 1e6 0 0 0 0; ...'";
  const std::vector<std::string> rows = split(in.text("Matrix"), ';');
  if (rows.size() != 6)
    in.fail("Matrix", form, example, std::to_string(rows.size()) + " rows");
  Matrix6 K;
  for (unsigned int i = 0; i < 6; ++i) {
    const std::vector<std::string> words = split(rows[i], ' ');
    for (unsigned int j = 0; j < 6; ++j) {
      if (words.size() != 6 || !to_number(words[j], K(i, j)))
        in.fail("Matrix", form, example, "'" + rows[i] + "'");
      const char *const unit = i < 3 && j < 3 ? "N/m" : i < 3 || j < 3 ? "N" : "N m/rad";
      K(i, j) = in.in_bounds("Matrix", K(i, j) * in.si(unit), unit);
    }
  }
  const Eigen::Matrix<double, 6, 1> size = K.diagonal().cwiseMax(0.).cwiseSqrt();
  Matrix6 scaled = Matrix6::Zero();
  for (unsigned int i = 0; i < 6; ++i)
    for (unsigned int j = 0; j < 6; ++j) {
      const std::string place = std::to_string(i + 1) + " " + std::to_string(j + 1);
      if (std::abs(K(i, j) - K(j, i)) > rounding * (std::abs(K(i, j)) + std::abs(K(j, i))))
        in.fail("Matrix", "a symmetric matrix: a force and a moment have one energy",
                "the same number at " + place + " and the other way round",
                "row and column " + place);
      if (K(i, i) < 0. || (K(i, j) != 0. && size[i] * size[j] == 0.))
        in.fail("Matrix", "a matrix that gives back what it took: none that is negative",
                "a diagonal that is not 0 where its row is not", "row and column " + place);
      if (K(i, j) != 0.)
        scaled(i, j) = (K(i, j) + K(j, i)) / (2. * size[i] * size[j]);
    }
  const double least = symmetric_eigen(scaled).values[0];
  if (least < -rounding)
    in.fail("Matrix", "a matrix that gives back what it took: no eigenvalue below 0",
            "smaller numbers off the diagonal",
            "a least eigenvalue of " + to_text(least) + " where the diagonal is scaled to 1");
  return K;
}

/// K = sum over k of stiffness_k a_k a_k^T, by L D L^T with pivots, which leaves zeros zeros.
void give_matrix(const Matrix6 &K, const Axes &axes, Spring &spring) {
  constexpr double vanishing = 1e-14; // of pivots, where the diagonal is 1
  Eigen::Matrix<double, 6, 1> size = K.diagonal().cwiseSqrt(), inverse;
  for (unsigned int i = 0; i < 6; ++i)
    inverse[i] = size[i] > 0. ? 1. / size[i] : 0.;
  const Matrix6 scaled = inverse.asDiagonal() * (K + K.transpose()) / 2. * inverse.asDiagonal();
  const Eigen::LDLT<Matrix6> factors(scaled);
  const Matrix6 L = factors.transpositionsP().transpose() * Matrix6(factors.matrixL());
  for (unsigned int k = 0; k < 6; ++k) {
    const double pivot = factors.vectorD()[k];
    if (!(pivot > vanishing)) {
      spring.stiffness[k] = 0.;
      continue;
    }
    const Eigen::Matrix<double, 6, 1> column = size.asDiagonal() * L.col(k);
    const double scale = column.norm();
    spring.stiffness[k] = pivot * scale * scale;
    spring.directions[k] = {};
    for (unsigned int c = 0; c < 6; ++c)
      for (unsigned int d = 0; d < 3; ++d)
        spring.directions[k][c / 3 * 3 + d] += column[c] / scale * axes[c % 3][d];
  }
}

} // namespace

void declare_axes(ParameterReader &in, const std::string &of) {
  in.declare_text("Axes", "", "x y z; x y z, or one vector x y z",
                  of + " The first axis, and what of the second vector is across it; the third "
                       "completes them. One vector: the second axis is across it and horizontal, "
                       "as a pipe's. Empty: global axes.");
}

Vector3 parse_unit_vector(const ParameterReader &in, const std::string &entry) {
  const Vector3 vector = in.vector(entry);
  if (vector.norm() == 0.)
    in.fail(entry, "a vector that is not zero", "'0 0 1', upwards");
  return vector / vector.norm();
}

Axes parse_axes(const ParameterReader &in) {
  const std::string form = "one vector or two, x y z; x y z, not zero and not parallel",
                    example = "'1 1 0; -1 1 0'";
  if (in.text("Axes").empty())
    return global_axes();
  std::vector<Vector3> vectors;
  for (const std::string &text : split(in.text("Axes"), ';')) {
    const std::vector<std::string> words = split(text, ' ');
    Vector3 vector;
    for (unsigned int d = 0; d < 3; ++d)
      if (words.size() != 3 || !to_number(words[d], vector[d]))
        in.fail("Axes", form, example, "'" + text + "'");
    vectors.push_back(vector);
  }
  constexpr double least_angle = 1e-6;
  if (vectors.size() > 2 || vectors[0].norm() == 0.)
    in.fail("Axes", form, example);
  const dealii::Tensor<1, 3> x = vectors[0] / vectors[0].norm();
  if (vectors.size() == 1) {
    const LocalAxes axes(x);
    return {{axes.x, axes.y, axes.z}};
  }
  const Vector3 across = vectors[1] - (vectors[1] * x) * x;
  if (!(across.norm() > least_angle * vectors[1].norm()))
    in.fail("Axes", form, example);
  const Vector3 y = across / across.norm();
  return {{x, y, dealii::cross_product_3d(x, y)}};
}

void declare_spring(ParameterReader &in) {
  in.declare_text("At", "", "name of a point", "Where the spring acts.");
  in.declare_text("To", "", "name of a point", "Its other end; empty: the ground.");
  in.declare_text("Stiffness", "0 0 0", "kx ky kz [N/m], or with three more about x y z [N m/rad]",
                  "Along and about the axes, none of them negative.");
  in.declare_text("Matrix", "", "six rows of six numbers, rows separated by ';'",
                  "Instead of Stiffness: forces [N] and moments [N m] of displacements [m] and "
                  "rotations [rad] along and about the axes, symmetric, no eigenvalue negative.");
  declare_axes(in, "Of Stiffness, Damping or Matrix.");
  in.declare_text("Damping", "0 0 0",
                  "cx cy cz [N s/m], or with three more about x y z [N m s/rad]",
                  "Of a dashpot beside the spring, in transient steps.");
}

void parse_spring(const ParameterReader &in, const std::string &name, Scene &scene) {
  Spring spring;
  spring.name = name;
  spring.point = in.text("At");
  spring.other = in.text("To");
  check_point(in, "At", spring.point, scene);
  if (!spring.other.empty())
    check_point(in, "To", spring.other, scene);
  if (spring.point == spring.other)
    in.fail("To", "another point than At", "a second point, or nothing for the ground");
  spring.stiffness = parse_motion(in, "Stiffness", false, {{"N/m", "N m/rad"}});
  spring.damping = parse_motion(in, "Damping", false, {{"N s/m", "N m s/rad"}});
  const Axes axes = parse_axes(in);
  spring.directions = unit_motions(axes);
  for (const double c : spring.damping)
    if (c < 0.)
      in.fail("Damping", "numbers >= 0", "a positive damping");
  if (!in.text("Matrix").empty()) {
    for (const char *const other : {"Stiffness", "Damping"})
      if (in.given(other))
        in.fail(other, "this entry without Matrix", "a section Spring of its own at that point");
    give_matrix(parse_matrix(in), axes, spring);
  }
  double sum = 0.;
  for (const double c : spring.damping)
    sum += c;
  for (const double k : spring.stiffness) {
    if (k < 0.)
      in.fail("Stiffness", "numbers >= 0", "a positive stiffness");
    sum += k;
  }
  if (sum == 0.)
    in.fail("Stiffness", "at least one number > 0", "'1e6 0 0'");
  scene.springs.push_back(spring);
}

void declare_mass(ParameterReader &in) {
  in.declare_text("At", "", "names of points, separated by commas", "One such mass at each.");
  in.declare_number("Mass", 0., "kg", 0., 1e300, "Of a valve, a flange.");
  in.declare_text("Item", "", "name of an item of Catalogue/Components",
                  "Of your own table, whose mass it has.");
}

void parse_mass(const ParameterReader &in, const std::string &name, Scene &scene) {
  PointMass mass;
  mass.name = name;
  mass.points = points_at(in, scene);
  if (mass.points.empty())
    in.fail("At", "at least one point", "the name of a point");
  mass.mass = in.number("Mass");
  if (!in.text("Item").empty()) {
    if (in.given("Mass"))
      in.fail("Item", "an item, which has a mass, or 'Mass'", "removing 'Mass'");
    mass.mass = component_item(in, scene).mass;
  }
  scene.masses.push_back(mass);
}

void declare_initial(ParameterReader &in) {
  in.declare_text("At", "", "names of points, separated by commas",
                  "Which points start so. What several such sections give a point adds up.");
  in.declare_text("Pipes", "", "names of pipes, separated by commas",
                  "All of whose nodes start so.");
  in.declare_text("About", "", "name of a point",
                  "Displacement and velocity are those of a rigid body at this point; empty: of "
                  "each node.");
  in.declare_text("Displacement", "0 0 0", "ux uy uz [m], or with rx ry rz [degrees]",
                  "At the start of the first step, which must be transient.");
  in.declare_text("Velocity", "0 0 0", "vx vy vz [m/s], or with three more [degrees/s]",
                  "At the start of the first transient step.");
}

void parse_initial(const ParameterReader &in, Scene &scene) {
  InitialCondition initial;
  initial.points = points_at(in, scene);
  initial.pipes = in.list("Pipes");
  if (initial.points.empty() && initial.pipes.empty())
    in.fail("At", "at least one point here, or a pipe in Pipes", "the name of a point");
  for (const std::string &pipe : initial.pipes)
    in.find("Pipes", pipe, names(scene.pipes), "pipe");
  initial.about = in.text("About");
  if (!initial.about.empty())
    check_point(in, "About", initial.about, scene);
  initial.displacement = parse_motion(in, "Displacement", true, {{"m", "rad"}});
  if (initial.displacement != Motion{} && !scene.steps.empty() && !scene.steps.front().transient)
    in.fail("Displacement", "none before a static step, which moves the line to its equilibrium",
            "a load of kind displacement");
  initial.velocity = parse_motion(in, "Velocity", true, {{"m/s", "rad/s"}});
  if (std::none_of(scene.steps.begin(), scene.steps.end(),
                   [](const LoadStep &step) { return step.transient; }))
    in.fail_section("a section Initial and no transient step", "Initial with a transient step",
                    "set Analysis = transient in a step");
  scene.initial.push_back(initial);
}

} // namespace frictionbeam::parts
