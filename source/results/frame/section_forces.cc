// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/frame/section_forces.h"

#include "analysis/increment/contact_watch.h"
#include "model/cell/line_cells.h"
#include "model/line/pipe_element.h"

#include <algorithm>
#include <map>

namespace frictionbeam {

using namespace dealii;

namespace {

/// Cells whose lengths and directions differ by rounding only are alike.
constexpr double alike = 1e-11;

using Key = std::array<long long, 7>;

} // namespace

SectionForces::SectionForces(const Model &model)
    : model(model), per_cell(model.scene.output.stations + 2), buffer(6 * per_cell) {
  const auto &pipe_cells = model.discretization.pipe_cells();
  std::vector<std::vector<unsigned int>> in_pipe(model.mesh.pipes.size());
  for (unsigned int i = 0; i < pipe_cells.size(); ++i) {
    auto &list = in_pipe[pipe_cells[i].pipe];
    list.resize(std::max<std::size_t>(list.size(), pipe_cells[i].position + 1));
    list[pipe_cells[i].position] = i;
  }
  std::map<Key, unsigned int> known;
  std::vector<types::global_dof_index> dofs(12);
  for (const auto &list : in_pipe)
    for (const unsigned int index : list) {
      const auto cell = model.discretization.pipe_cell(index);
      const Vector3 chord = cell->vertex(1) - cell->vertex(0);
      const bool is_alone = model.discretization.joints(cell) != nullptr ||
                            model.discretization.profiles()[cell->material_id()].arc_centre;
      const auto rounded = [](const double value) { return std::llround(value / alike); };
      Key key{pipe_cells[index].pipe, static_cast<long long>(cell->material_id()),
              pipe_cells[index].reversed ? 1 : 0};
      key[3] = is_alone ? -1 - static_cast<long long>(index)
                        : std::llround(std::log(chord.norm()) / alike);
      for (unsigned int d = 0; d < 3; ++d)
        key[4 + d] = rounded(chord[d] / chord.norm());
      const auto [entry, is_new] = known.try_emplace(key, kinds.size());
      if (is_new)
        kinds.push_back(make_kind(model, index));
      Cell one;
      one.kind = entry->second;
      cell->get_dof_indices(dofs);
      std::copy(dofs.begin(), dofs.end(), one.dofs.begin());
      cells.push_back(one);
    }
}

SectionForces::Kind SectionForces::make_kind(const Model &model, const unsigned int index) {
  const PipeCell &pipe_cell = model.discretization.pipe_cells()[index];
  const auto cell = model.discretization.pipe_cell(index);
  PipeElement element(model.discretization);
  element.reinit(cell);
  const bool is_arc = element.arc().has_value();
  const Vector3 chord = cell->vertex(1) - cell->vertex(0);
  const LocalAxes axes((pipe_cell.reversed ? -1. : 1.) * chord);
  Eigen::Matrix3d turn; // into the axes that the start speaks of
  const std::array<Vector3, 3> rows =
      is_arc ? std::array<Vector3, 3>{{element.arc()->tangent(0.), element.arc()->inward(0.),
                                       element.arc()->axis()}}
             : std::array<Vector3, 3>{{axes.x, axes.y, axes.z}};
  for (unsigned int row = 0; row < 3; ++row)
    for (unsigned int d = 0; d < 3; ++d)
      turn(row, d) = rows[row][d];
  const unsigned int first = pipe_cell.reversed && !is_arc ? 6 : 0;
  // The section force acts on the face that looks away from the start.
  Eigen::Matrix<double, 6, 12> pick = Eigen::Matrix<double, 6, 12>::Zero();
  pick.block<3, 3>(0, first) = -turn;
  pick.block<3, 3>(3, first + 3) = -turn;

  Kind kind;
  kind.start = pick * element.stiffness();
  const PipeElement::Vector12 strain = element.unit_axial_strain(),
                              curvature = element.unit_curvature(), thrust = element.unit_thrust();
  const Eigen::Matrix<double, 12, 3> line_loads = element.unit_line_loads();
  for (const Load &load : model.scene.loads) {
    const CellLoad one =
        cell_load(load, model.scene.pipes[pipe_cell.pipe].name, element.profile(), chord);
    const Eigen::Vector3d q(one.line_force[0], one.line_force[1], one.line_force[2]);
    CellCourse share = CellCourse::Zero();
    share.head<6>() = -pick * (line_loads * q + one.axial_strain * strain +
                               one.curvature * curvature + one.pressure * thrust);
    share.segment<3>(6) = turn * q;
    kind.loads.push_back(share);
  }
  kind.sum.setZero();
  kind.spacing = chord.norm() / (per_cell - 1);
  if (is_arc)
    kind.arc = find_arc(stations_of(*element.arc(), pipe_cell.reversed, turn));
  kind.inertia.setZero();
  if (!model.linear.mass().nonZeros()) // of a static scene
    return kind;
  PipeElement::Matrix12 mass = model.cells.mass_of(index, element);
  if (first == 6) // the other end first
    mass.topRows<6>().swap(mass.bottomRows<6>());
  const Eigen::Vector3d axis = turn.row(0).transpose() * chord.norm(); // of a straight cell
  for (unsigned int i = 0; i < 12; ++i) {
    const CellCourse course = is_arc ? course_in_balance(mass.col(i), *element.arc())
                                     : course_in_balance(mass.col(i), axis);
    for (unsigned int part = 0; part < 12; part += 3)
      kind.inertia.col(i).segment<3>(part) = turn * course.segment<3>(part);
  }
  return kind;
}

SectionForces::ArcStations SectionForces::stations_of(const ArcBeam &arc, const bool reversed,
                                                      const Eigen::Matrix3d &turn) const {
  ArcStations stations;
  for (unsigned int i = 0; i < per_cell; ++i) {
    const double part = static_cast<double>(i) / (per_cell - 1),
                 psi = arc.angle() * (reversed ? 1. - part : part), side = reversed ? -1. : 1.;
    const LocalAxes there(side * arc.tangent(psi));
    Matrix6x12 station;
    for (unsigned int j = 0; j < 12; ++j) {
      const auto [F, M] = section_of_arc(CellCourse::Unit(j), arc, psi);
      station.col(j) << F * there.x, F * there.y, F * there.z, M * there.x, M * there.y,
          M * there.z;
    }
    for (unsigned int of = 0; of < 12; of += 3)
      station.middleCols<3>(of) = (station.middleCols<3>(of) * turn.transpose()).eval();
    stations.push_back(side * station);
  }
  return stations;
}

int SectionForces::find_arc(const ArcStations &stations) {
  constexpr std::ptrdiff_t most_compared = 50; // the last ones
  const auto first = arcs.end() - std::min<std::ptrdiff_t>(arcs.size(), most_compared);
  const auto like = std::find_if(first, arcs.end(), [&](const ArcStations &known) {
    for (unsigned int i = 0; i < per_cell; ++i)
      if (!((known[i] - stations[i]).lpNorm<Eigen::Infinity>() <=
            alike * known[i].lpNorm<Eigen::Infinity>()))
        return false;
    return true;
  });
  const int place = like - arcs.begin();
  if (like == arcs.end())
    arcs.push_back(stations);
  return place;
}

void SectionForces::sum_loads(const std::vector<double> &factors) {
  for (Kind &kind : kinds) {
    kind.sum.setZero();
    for (unsigned int l = 0; l < factors.size(); ++l)
      kind.sum += factors[l] * kind.loads[l];
  }
}

void SectionForces::find_accelerations(const LineState &state) {
  if (!has_inertia(model, state)) {
    accelerations.resize(0);
    return;
  }
  accelerations = model.cells.velocities(state.acceleration, state.load_accelerations);
  if (const double alpha = model.scene.time.mass_damping; alpha != 0.)
    accelerations += alpha * model.cells.velocities(state.velocity, state.load_rates);
}

const double *SectionForces::forces_of(const Kind &kind, const CellCourse &start) {
  if (kind.arc >= 0) {
    for (unsigned int i = 0; i < per_cell; ++i) {
      const Matrix6x12 &station = arcs[kind.arc][i];
      Eigen::Matrix<double, 6, 1> force = start[0] * station.col(0);
      for (unsigned int j = 1; j < 12; ++j)
        force += start[j] * station.col(j);
      Eigen::Map<Eigen::Matrix<double, 6, 1>>(buffer.data() + 6 * i) = force;
    }
    return buffer.data();
  }
  const double qx = start[6], qy = start[7], qz = start[8];
  for (unsigned int i = 0; i < per_cell; ++i) {
    const double x = i * kind.spacing, half = x * x / 2.;
    double *const force = buffer.data() + 6 * i;
    force[0] = start[0] - x * qx;
    force[1] = start[1] - x * qy;
    force[2] = start[2] - x * qz;
    force[3] = start[3] + x * start[9];
    force[4] = start[4] + x * (start[2] + start[10]) - half * qz;
    force[5] = start[5] - x * (start[1] - start[11]) + half * qy;
  }
  return buffer.data();
}

bool is_at_rest(const LineState &state) {
  return state.load_rates.empty() && state.velocity.isZero(0.) && state.acceleration.isZero(0.);
}

double damped_acceleration(const Model &model, const LineState &state,
                           const types::global_dof_index dof) {
  const double alpha = model.scene.time.mass_damping;
  const auto rate = [&](const Vector &unknowns, const std::vector<double> &factors) {
    return model.linear.rate(dof, model.space, unknowns, factors);
  };
  return rate(state.acceleration, state.load_accelerations) +
         (alpha != 0. ? alpha * rate(state.velocity, state.load_rates) : 0.);
}

bool has_inertia(const Model &model, const LineState &state) {
  return !is_at_rest(state) &&
         std::none_of(state.events.begin(), state.events.end(), [&](const ContactEvent &event) {
           return event.status != ContactStatus::open &&
                  is_rigid_stop(model, model.contacts[event.contact]);
         });
}

bool section_forces_jump(const Motion &before, const Motion &after) {
  constexpr double least_jump = 1e-6, rounding = 1e-9; // of a component; of all forces or moments
  for (unsigned int kind = 0; kind < 6; kind += 3) {
    double largest = 0.;
    for (unsigned int c = kind; c < kind + 3; ++c)
      largest = std::max({largest, std::abs(before[c]), std::abs(after[c])});
    for (unsigned int c = kind; c < kind + 3; ++c)
      if (std::abs(after[c] - before[c]) >
          std::max(least_jump * (std::abs(before[c]) + std::abs(after[c])), rounding * largest))
        return true;
  }
  return false;
}

} // namespace frictionbeam
