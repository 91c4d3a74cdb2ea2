// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/substructure/wall_stretch.h"

#include "analysis/substructure/free_pressed_wall.h"
#include "mesh/solid/held_points.h"
#include "mesh/solid/wall_layout.h"

#include <deal.II/base/quadrature_lib.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace frictionbeam {

using namespace dealii;

namespace {

/// The wall's materials, and the section that an anchor holds at one of its ends.
Scene body_scene_of(const Scene &scene, const PipeWall &wall, const SolidStretch &stretch) {
  ContinuumScene body;
  body.dimension = 3;
  const Material &material = scene.materials[scene.pipes.front().material];
  body.materials.push_back({material.youngs_modulus, material.poissons_ratio});
  const bool breathes = scene.solid.anchors == SolidSettings::Anchors::breathing;
  const WallRing &end = stretch.anchored[1] ? wall.rings.back() : wall.rings.front();
  if (stretch.anchored[0] || stretch.anchored[1])
    body.sections.push_back({end.centre, end.tangent, wall.outer, breathes});
  else
    body.holds = holds_at_points(wall);
  Scene result = scene;
  result.continuum = body;
  result.continuum_settings.degree = scene.solid.degree;
  result.continuum_settings.linear_solver = ContinuumSettings::LinearSolver::direct;
  return result;
}

/// Of a symmetric matrix, scaled, for forces and moments have their own units.
/// @return its inverse, and whether it is positive definite
std::pair<Eigen::MatrixXd, bool> inverse_of(const Eigen::MatrixXd &matrix) {
  const Eigen::MatrixXd symmetric = 0.5 * (matrix + matrix.transpose());
  const Eigen::VectorXd scale = symmetric.diagonal().cwiseAbs().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = scale.asDiagonal() * symmetric * scale.asDiagonal(),
                        one = Eigen::MatrixXd::Identity(matrix.rows(), matrix.rows());
  const Eigen::LLT<Eigen::MatrixXd> factors(scaled);
  const bool is_positive = factors.info() == Eigen::Success;
  const Eigen::MatrixXd solved = is_positive ? Eigen::MatrixXd(factors.solve(one))
                                             : Eigen::MatrixXd(scaled.partialPivLu().solve(one)),
                        inverse = scale.asDiagonal() * solved * scale.asDiagonal();
  return {0.5 * (inverse + inverse.transpose()), is_positive};
}

} // namespace

WallStretch::WallStretch(const Scene &whole, const LineMesh &line, const SolidStretch &stretch)
    : stretch(stretch), own(whole, line, stretch),
      wall(with_held_points(build_pipe_wall(own.scene, own.line))),
      body_scene(body_scene_of(own.scene, wall, stretch)), body(body_scene, wall.mesh) {
  body.distribute();
  loads = std::make_unique<const WallLoads>(own.scene, own.line, wall, body);
  for (unsigned int i = 0; i < own.vertices.size(); ++i)
    rings.push_back(wall.ring_at(i));
  reference = stretch.anchored[0] && !stretch.anchored[1] ? 0 : rings.size() - 1;
  wall.pipe_start[0] = -stretch.from;
}

WallStretch::Matrix6 WallStretch::carried(const unsigned int section) const {
  const Vector3 arm = place(section) - place(reference);
  Matrix6 result = Matrix6::Identity();
  for (unsigned int k = 0; k < 3; ++k) {
    Vector3 axis;
    axis[k] = 1.;
    const Vector3 moved = cross_product_3d(axis, arm);
    for (unsigned int d = 0; d < 3; ++d)
      result(d, 3 + k) = moved[d];
  }
  return result;
}

/// @param resultant of the forces about the reference, which balances it unless it is held
ContinuumVector WallStretch::balanced(ContinuumVector forces, const Vector6 &resultant) const {
  if (!has_held_end())
    sections[reference].add_forces(-resultant, forces);
  return forces;
}

Eigen::VectorXd WallStretch::relative(const ContinuumVector &displacement) const {
  Vector6 base = Vector6::Zero();
  if (!has_held_end())
    base = sections[reference].motion(displacement);
  Eigen::VectorXd result(6 * (sections.size() - 1));
  for (unsigned int i = 0, row = 0; i < sections.size(); ++i)
    if (i != reference) {
      result.segment<6>(row) = sections[i].motion(displacement) - carried(i) * base;
      row += 6;
    }
  return result;
}

Eigen::MatrixXd WallStretch::relative(const std::vector<ContinuumVector> &fields) const {
  Eigen::MatrixXd result(6 * (sections.size() - 1), fields.size());
  for (unsigned int k = 0; k < fields.size(); ++k)
    result.col(k) = relative(fields[k]);
  return result;
}

Eigen::VectorXd WallStretch::push(const unsigned int rest) const {
  const unsigned int section = wall.patches[rest].vertex,
                     row = 6 * (section < reference ? section : section - 1);
  Eigen::VectorXd result = Eigen::VectorXd::Zero(6 * (sections.size() - 1));
  for (unsigned int d = 0; d < 3; ++d)
    result[row + d] = -wall.patches[rest].outward[d];
  return result;
}

Eigen::MatrixXd WallStretch::on_sections() const {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(n_forces, n_loads);
  for (unsigned int l = 0; l < own.at_sections.size() && !wall.patches.empty(); ++l)
    for (unsigned int i = 0, row = 0; i < sections.size(); ++i)
      if (i != reference) {
        result.block<6, 1>(row, l) = Eigen::Map<const Vector6>(own.at_sections[l][i].data());
        row += 6;
      }
  return result;
}

Eigen::MatrixXd WallStretch::relation() const {
  const unsigned int n = sections.size();
  Eigen::MatrixXd G = Eigen::MatrixXd::Zero(6 * (n - 1), 6 * n);
  for (unsigned int i = 0, row = 0; i < n; ++i)
    if (i != reference) {
      G.block<6, 6>(row, 6 * i) = Matrix6::Identity();
      G.block<6, 6>(row, 6 * reference) = -carried(i);
      row += 6;
    }
  return G;
}

void WallStretch::solve_fields(const std::vector<Vector6> &resultants,
                               const std::vector<double> &pressures) {
  std::vector<ContinuumVector> all;
  for (unsigned int i = 0; i < sections.size(); ++i)
    for (unsigned int c = 0; c < 6 && i != reference; ++c) {
      const Vector6 unit = Vector6::Unit(c);
      ContinuumVector forces;
      body.reinit(forces);
      sections[i].add_forces(unit, forces);
      all.push_back(balanced(std::move(forces), carried(i).transpose() * unit));
    }
  n_forces = all.size();
  std::vector<ContinuumVector> of_loads = loads->forces();
  for (unsigned int l = 0; l < of_loads.size(); ++l)
    all.push_back(balanced(std::move(of_loads[l]), resultants[l]));
  const bool is_pressed = std::any_of(pressures.begin(), pressures.end(),
                                      [](const double pressure) { return pressure != 0.; });
  if (is_pressed && own.scene.solid.pressure_stiffening) {
    stiffening = std::make_unique<const PressureStiffness>(
        PressureStiffness{wall, body, free_pressed_wall(body_scene, wall)});
    all.push_back(stiffening->times_free_field());
  }
  n_loads = all.size() - n_forces;
  std::vector<ContinuumVector> presses;
  for (unsigned int p = 0; p < wall.patches.size(); ++p)
    presses.push_back(sections[wall.patches[p].vertex].pressure(wall, body, p));
  all.insert(all.end(), presses.begin(), presses.end());
  fields = std::make_unique<const WallFields>(body, std::move(all), stiffening.get(),
                                              stiffening ? pressures : std::vector<double>());
  motions = relative(fields->basis());
  rest_work.resize(motions.cols(), presses.size());
  for (unsigned int k = 0; k < rest_work.rows(); ++k)
    for (unsigned int p = 0; p < presses.size(); ++p)
      rest_work(k, p) = presses[p] * fields->basis()[k];
}

Eigen::MatrixXd WallStretch::directions(const Eigen::MatrixXd &stiffness,
                                        const Eigen::MatrixXd &of_rests) const {
  Eigen::MatrixXd B = Eigen::MatrixXd::Identity(stiffness.rows(), stiffness.rows());
  for (unsigned int p = 0; p < of_rests.cols(); ++p) {
    const Eigen::VectorXd n = push(p), kn = stiffness * n;
    Eigen::VectorXd forces = stiffness * of_rests.col(p);
    // Its own section is taken to be where no force along n holds it.
    forces -= n.dot(forces) / n.dot(kn) * kn;
    B += forces * n.transpose();
  }
  return B;
}

WallStretch::Condensed WallStretch::condense(const double pressure) const {
  Condensed result{pressure, fields->coefficients(pressure), {}, {}, true};
  const Eigen::MatrixXd of_all = motions * result.fields, F = of_all.leftCols(n_forces);
  const auto [stiffness, is_positive] = inverse_of(F);
  result.holds = is_positive;
  const Eigen::MatrixXd B = directions(stiffness, of_all.rightCols(wall.patches.size())),
                        of_loads = result.fields.middleCols(n_forces, n_loads);
  result.inverse = inverse_of(B.transpose() * F * B).first;
  result.free_motions = of_all.middleCols(n_forces, n_loads);
  for (unsigned int p = 0; p < wall.patches.size(); ++p)
    result.free_motions += push(p) * (rest_work.col(p).transpose() * of_loads);
  result.free_motions += B.transpose() * F * point_forces;
  return result;
}

Eigen::MatrixXd WallStretch::forces(const Condensed &at) const {
  Eigen::MatrixXd result = relation().transpose() * (at.inverse * at.free_motions - point_forces);
  result.middleRows(6 * reference, 6) += on_reference;
  return result;
}

SolidPart::Pressed WallStretch::pressed(const double pressure) const {
  const Condensed at = condense(pressure);
  const Eigen::MatrixXd G = relation(), added = forces(at) - forces(unpressed);
  SolidPart::Pressed result;
  result.stiffness = G.transpose() * (at.inverse - unpressed.inverse) * G;
  result.forces = added.leftCols(n_loads - 1);
  result.by_itself = pressure * pressure * forces(at).col(n_loads - 1);
  // With all sections held, the wall has as many negative eigenvalues less as the forces that hold
  // them take away.
  if (fields->is_stable(pressure))
    result.stability = SolidPart::Stability::known;
  else if (at.holds && fields->n_negative(pressure) > 0)
    result.stability = SolidPart::Stability::buckled;
  else
    result.stability = SolidPart::Stability::of_the_line;
  return result;
}

std::vector<WallStretch::Vector6> WallStretch::resultants(const SolidPart &part) const {
  std::vector<Vector6> result;
  for (const std::vector<Motion> &on_cells : part.cell_loads) {
    result.push_back(Vector6::Zero());
    for (unsigned int k = 0; k < on_cells.size(); ++k)
      result.back() += carried(k).transpose() * Eigen::Map<const Vector6>(on_cells[k].data());
  }
  return result;
}

SolidPart WallStretch::superelement(const std::vector<double> &pressures) {
  for (const unsigned int ring : rings)
    sections.emplace_back(wall, body, ring);
  SolidPart part;
  part.pipe = stretch.pipe;
  part.first_cell = own.first_cell;
  part.vertices = own.vertices;
  part.cell_loads = cell_loads();
  const std::vector<Vector6> of_cells = resultants(part);
  solve_fields(of_cells, pressures);
  on_reference = Eigen::MatrixXd::Zero(6, n_loads);
  for (unsigned int l = 0; l < of_cells.size(); ++l)
    on_reference.col(l) = of_cells[l];
  point_forces = on_sections();
  unpressed = condense(0.);
  AssertThrow(unpressed.holds, ExcInternalError());
  part.stiffness = relation().transpose() * unpressed.inverse * relation();
  const Eigen::MatrixXd by_load = forces(unpressed);
  for (unsigned int l = 0; l < of_cells.size(); ++l)
    part.forces.push_back(by_load.col(l));
  if (!stiffening)
    return part;
  for (const Load &load : own.scene.loads)
    part.pressures.push_back(load.kind == Load::Kind::pressure ? load.value : 0.);
  part.pressed = [this](const double pressure) -> const SolidPart::Pressed & {
    if (!last_pressed || pressure != last_pressure)
      last_pressed = pressed(pressure);
    last_pressure = pressure;
    return *last_pressed;
  };
  return part;
}

Eigen::VectorXd WallStretch::load_factors(const std::vector<double> &factors) const {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(n_loads);
  result.head(factors.size()) = Eigen::Map<const Eigen::VectorXd>(factors.data(), factors.size());
  if (stiffening)
    result[n_loads - 1] = std::pow(loads->pressure(factors), 2);
  return result;
}

ContinuumVector WallStretch::displacement(const Eigen::VectorXd &of_sections,
                                          const std::vector<double> &factors) const {
  const Condensed at = condense(stiffening ? loads->pressure(factors) : 0.);
  const Eigen::VectorXd x = load_factors(factors),
                        pushes = at.inverse * (relation() * of_sections - at.free_motions * x);
  Eigen::VectorXd amplitudes(at.fields.cols());
  amplitudes << pushes + point_forces * x, x, Eigen::VectorXd::Zero(wall.patches.size());
  for (unsigned int p = 0; p < wall.patches.size(); ++p)
    amplitudes[n_forces + n_loads + p] = push(p).dot(pushes);
  const Eigen::VectorXd parts = at.fields * amplitudes;
  ContinuumVector field;
  body.reinit(field);
  for (unsigned int k = 0; k < parts.size(); ++k)
    if (parts[k] != 0.)
      field.add(parts[k], fields->basis()[k]);
  Vector6 rigid = of_sections.segment<6>(6 * reference);
  if (!has_held_end())
    rigid -= sections[reference].motion(field);
  field += rigid_displacement(body, place(reference), rigid);
  return field;
}

bool WallStretch::is_disturbed(const unsigned int ring) const {
  constexpr double near_the_cut = 1.5; // lengths
  const double length = own.scene.sections[own.scene.pipes.front().section].decay_length(),
               s = wall.rings[ring].s, end = wall.length();
  return std::any_of(wall.patches.begin(), wall.patches.end(), [&](const WallPatch &patch) {
    return (!stretch.anchored[0] && patch.from < near_the_cut * length && s < patch.to + length) ||
           (!stretch.anchored[1] && patch.to > end - near_the_cut * length &&
            s > patch.from - length);
  });
}

std::vector<std::vector<Motion>> WallStretch::cell_loads() const {
  // What is integrated over the metal and over the bore: size times vector, moment about the
  // origin.
  struct Integral {
    double volume = 0.;
    Vector3 first_moment, normal, turn;
  };
  std::vector<Integral> integrals(rings.size() - 1);
  FEValues<3> values(body.mapping, body.fe, QGauss<3>(body.fe.degree + 1),
                     update_quadrature_points | update_JxW_values);
  FEFaceValues<3> on_bore(body.mapping, body.fe, QGauss<2>(body.fe.degree + 2),
                          update_quadrature_points | update_normal_vectors | update_JxW_values);
  for (const auto &cell : body.dof_handler.active_cell_iterators()) {
    unsigned int k = 0;
    while (rings[k + 1] <= wall.layer_of(cell->index()))
      ++k;
    Integral &sum = integrals[k];
    values.reinit(cell);
    for (const unsigned int q : values.quadrature_point_indices()) {
      sum.volume += values.JxW(q);
      sum.first_moment += values.JxW(q) * (values.quadrature_point(q) - place(k));
    }
    if (cell->index() / wall.around % wall.through > 0)
      continue;
    on_bore.reinit(cell, 0);
    for (const unsigned int q : on_bore.quadrature_point_indices()) {
      const Vector3 normal = on_bore.JxW(q) * on_bore.normal_vector(q);
      sum.normal += normal;
      sum.turn += cross_product_3d(Vector3(on_bore.quadrature_point(q) - place(k)), normal);
    }
  }
  std::vector<std::vector<Motion>> result(own.scene.loads.size());
  for (unsigned int l = 0; l < result.size(); ++l) {
    std::vector<double> factors(result.size(), 0.);
    factors[l] = 1.;
    const Vector3 weight = loads->volume_force(0, factors);
    const double p = loads->pressure(factors);
    for (unsigned int k = 0; k < integrals.size(); ++k) {
      const WallRing &begin = wall.rings[rings[k]], &end = wall.rings[rings[k + 1]];
      // Sections have the effective force, less the thrust of the bore.
      const Vector3 thrust = p * wall.bore_area() * end.tangent,
                    force = integrals[k].volume * weight - p * integrals[k].normal + thrust -
                            p * wall.bore_area() * begin.tangent,
                    moment = cross_product_3d(integrals[k].first_moment, weight) -
                             p * integrals[k].turn +
                             cross_product_3d(Vector3(end.centre - begin.centre), thrust);
      result[l].push_back({{force[0], force[1], force[2], moment[0], moment[1], moment[2]}});
    }
  }
  return result;
}

} // namespace frictionbeam
