// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/event/taylor_motion.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {
constexpr double rounding_of_terms = 1e-17;
constexpr double dependent = 1e-11; ///< constraints, by pivots of the matrix that couples them
} // namespace

Vector TaylorMotion::at(const Eigen::MatrixXd &m, const double x) {
  Vector result = Vector::Zero(m.rows());
  for (Eigen::Index k = m.cols(); k-- > 0;)
    result = x * result + m.col(k);
  return result;
}

void TaylorMotion::make_rows(const std::vector<EventState> &states) {
  rows_are_current = true;
  rows.clear();
  curves.clear();
  responses.clear();
  const int n = model.has_mass.size();
  for (unsigned int i = 0; i < states.size(); ++i) {
    const EventContact &contact = model.contacts[i];
    if (!states[i].is_closed())
      continue;
    if (is_curve(states[i]))
      curves.push_back(i);
    if (contact.normal == EventContact::Normal::rigid && contact.moves[0])
      rows.push_back({i, 0});
    if (contact.sticks(states[i]))
      for (int d = 1; d < 3; ++d)
        if (contact.moves[d])
          rows.push_back({i, d});
  }
  columns = Eigen::MatrixXd::Zero(n, rows.size());
  accelerations = columns;
  for (unsigned int k = 0; k < rows.size(); ++k) {
    const EventState &state = states[rows[k].contact];
    const EventContact &contact = model.contacts[rows[k].contact];
    Eigen::Vector3d unit = Eigen::Vector3d::Zero();
    unit[rows[k].component] = 1.;
    if (rows[k].component == 0 && state.status == ContactStatus::slip && !state.curved)
      unit.tail<2>() = -contact.law.dynamic_friction * state.direction;
    for (unsigned int j = 0; j < contact.unknowns.size(); ++j)
      columns(contact.unknowns[j], k) = contact.G.col(j).dot(unit);
    accelerations.col(k) = model.accelerate(columns.col(k));
  }
  make_delassus();
}

void TaylorMotion::make_delassus() {
  Eigen::MatrixXd W(rows.size(), rows.size());
  for (unsigned int k = 0; k < rows.size(); ++k)
    for (unsigned int l = 0; l < rows.size(); ++l)
      W(k, l) =
          model.contacts[rows[k].contact].displacement(accelerations.col(l))[rows[k].component];
  relief.resize(0, 0);
  if (rows.empty())
    return;
  delassus = LeastSquares(W, dependent);
  if (delassus.rank() < W.rows())
    make_relief(W);
}

void TaylorMotion::make_relief(const Eigen::MatrixXd &W) {
  // lambda + N z with the least friction, W N = 0.
  Eigen::FullPivLU<Eigen::MatrixXd> lu(W);
  lu.setThreshold(dependent);
  const Eigen::MatrixXd kernel = lu.kernel();
  Eigen::MatrixXd of_friction = kernel;
  for (unsigned int k = 0; k < rows.size(); ++k)
    if (rows[k].component == 0)
      of_friction.row(k).setZero();
  relief = Eigen::MatrixXd::Identity(W.rows(), W.rows());
  relief -= kernel * LeastSquares(of_friction).pseudo_inverse();
  for (unsigned int k = 0; k < rows.size(); ++k)
    if (rows[k].component == 0)
      relief.col(k) = Eigen::VectorXd::Unit(W.rows(), k);
}

void TaylorMotion::begin_series(const Vector *const unknowns, const Vector *const velocity) {
  const int n = model.has_mass.size();
  q.setZero(n, order + 1);
  v.setZero(n, order + 1);
  if (unknowns == nullptr)
    return;
  q.col(0) = *unknowns;
  v.col(0) = *velocity;
  for (int u = 0; u < n; ++u)
    if (!model.has_mass[u])
      q(u, 0) = v(u, 0) = 0.;
}

Vector TaylorMotion::load_forces(const int k, const double length) const {
  const LinearPart &linear = model.model.linear;
  const Eigen::MatrixXd &factors = loads.factors;
  Vector forces = Vector::Zero(model.has_mass.size());
  if (k < factors.rows())
    for (int l = 0; l < factors.cols(); ++l)
      if (factors(k, l) != 0.)
        forces += factors(k, l) * linear.forces(l);
  for (int l = 0; l < factors.cols(); ++l)
    if (linear.accelerates(l)) {
      if (k + 1 < factors.rows() && factors(k + 1, l) != 0.)
        forces += (k + 1.) / length * factors(k + 1, l) * linear.drag(l);
      if (k + 2 < factors.rows() && factors(k + 2, l) != 0.)
        forces += (k + 1.) * (k + 2.) / (length * length) * factors(k + 2, l) * linear.inertia(l);
    }
  return forces;
}

void TaylorMotion::set_known_force(const unsigned int i, const int k, const EventState &state,
                                   const bool constants, Eigen::Vector3d &known) const {
  const EventContact &contact = model.contacts[i];
  if (contact.normal == EventContact::Normal::platen)
    known[0] = constants ? -contact.contact->platen_force : 0.;
  else if (contact.normal == EventContact::Normal::elastic)
    known[0] = contact.normal_stiffness * (g[i](0, k) + (constants ? contact.law.gap : 0.));
  if (state.status == ContactStatus::slip) {
    if (!state.curved)
      known.tail<2>() = -contact.law.dynamic_friction * known[0] * state.direction;
    else if (k < curve_friction[i].cols())
      known.tail<2>() = curve_friction[i].col(k);
  } else if (state.status == ContactStatus::stick && !contact.rigid_shear) {
    Eigen::Vector2d elastic = g[i].col(k).tail<2>();
    if (constants)
      elastic -= state.plastic;
    known.tail<2>() = contact.shear_stiffness * elastic;
  }
}

void TaylorMotion::expand_series(const double length, const std::vector<EventState> &states,
                                 const std::vector<Eigen::Vector3d> *const forces_before) {
  const bool with_loads = forces_before != nullptr;
  const int n = model.has_mass.size();
  const auto ground_at = [&](const int i, const int k) {
    return with_loads && k < loads.ground.rows()
               ? Eigen::Vector3d(loads.ground.row(k).segment<3>(3 * i).transpose())
               : Eigen::Vector3d(Eigen::Vector3d::Zero());
  };
  for (unsigned int i = 0; i < states.size(); ++i) {
    g[i].setZero(3, order + 1);
    r[i].setZero(3, order + 1);
  }
  std::vector<Eigen::Vector3d> kept(states.size(), Eigen::Vector3d::Zero());
  for (unsigned int i = 0; i < states.size() && with_loads; ++i)
    for (int d = 1; d < 3; ++d) // friction of what cannot move, and does not: as it was
      if (model.contacts[i].sticks(states[i]) && !model.contacts[i].moves[d])
        kept[i][d] = (*forces_before)[i][d];
  for (const Row &row : rows)
    if (with_loads)
      kept[row.contact][row.component] = (*forces_before)[row.contact][row.component];
  for (int k = 0; k <= order; ++k) {
    const bool constants = with_loads && k == 0;
    Vector forces = with_loads ? load_forces(k, length) : Vector(Vector::Zero(n)),
           unknowns = q.col(k);
    forces = model.forces_left(forces, unknowns, v.col(k));
    q.col(k) = unknowns;
    for (unsigned int i = 0; i < states.size(); ++i) {
      const EventContact &contact = model.contacts[i];
      const EventState &state = states[i];
      g[i].col(k) = contact.displacement(unknowns) + ground_at(i, k);
      if (!state.is_closed())
        continue;
      Eigen::Vector3d known = k == 0 ? kept[i] : Eigen::Vector3d(Eigen::Vector3d::Zero());
      set_known_force(i, k, state, constants, known);
      r[i].col(k) = known;
      model.add_contact_force(i, known, forces);
    }
    Vector acceleration = model.accelerate(forces);
    Vector prescribed(rows.size()); // e'' of the rows
    for (unsigned int j = 0; j < rows.size(); ++j)
      prescribed[j] = (k + 1.) * (k + 2.) / (length * length) *
                      ground_at(rows[j].contact, k + 2)[rows[j].component];
    constrain(k, states, prescribed, acceleration);
    if (k == order)
      break;
    v.col(k + 1) = length / (k + 1.) * acceleration;
    q.col(k + 1) = length / (k + 1.) * v.col(k);
  }
  for (int u = 0; u < n; ++u)
    if (!model.has_mass[u])
      for (int k = 0; k < order; ++k)
        v(u, k) = (k + 1.) / length * q(u, k + 1);
}

void TaylorMotion::constrain(const int k, const std::vector<EventState> &states,
                             const Vector &prescribed, Vector &acceleration) {
  if (rows.empty())
    return;
  Vector right(rows.size());
  for (unsigned int j = 0; j < rows.size(); ++j)
    right[j] = model.contacts[rows[j].contact].displacement(acceleration)[rows[j].component] +
               prescribed[j];
  Vector multipliers = delassus.solve(right);
  if (relief.size() > 0)
    multipliers = (relief * multipliers).eval();
  acceleration -= accelerations * multipliers;
  for (unsigned int j = 0; j < rows.size(); ++j) {
    const EventState &state = states[rows[j].contact];
    Eigen::MatrixXd &force = r[rows[j].contact];
    force(rows[j].component, k) += multipliers[j];
    if (rows[j].component == 0 && state.status == ContactStatus::slip && !state.curved)
      force.col(k).tail<2>() -=
          model.contacts[rows[j].contact].law.dynamic_friction * multipliers[j] * state.direction;
  }
}

double TaylorMotion::valid_part() const {
  double part = 1.;
  for (const Eigen::MatrixXd *const m : {&q, &v}) {
    double scale = 0.;
    for (int k = 0; k <= order; ++k)
      scale = std::max(scale, m->col(k).lpNorm<Eigen::Infinity>());
    if (!std::isfinite(scale))
      return 0.;
    // The largest term counts at the length that is left.
    for (unsigned int pass = 0; pass < 30; ++pass) {
      double largest = 0., power = 1.;
      for (int k = 0; k <= order; ++k, power *= part)
        largest = std::max(largest, power * m->col(k).lpNorm<Eigen::Infinity>());
      double allowed = part;
      for (const int k : {order - 1, order})
        if (const double term = m->col(k).lpNorm<Eigen::Infinity>(); term > 0.)
          allowed = std::min(allowed, std::pow(rounding_of_terms * largest / term, 1. / k));
      if (allowed >= 0.999 * part)
        break;
      part = allowed;
    }
  }
  return part;
}

void TaylorMotion::shorten_all(const double x) {
  const auto shorten_columns = [x](Eigen::MatrixXd &m) {
    double power = 1.;
    for (int k = 0; k < m.cols(); ++k, power *= x)
      m.col(k) *= power;
  };
  shorten_columns(q);
  shorten_columns(v);
  for (Eigen::MatrixXd &m : g)
    shorten_columns(m);
  for (Eigen::MatrixXd &m : r)
    shorten_columns(m);
  for (Eigen::MatrixXd &m : s)
    shorten_columns(m);
  for (Eigen::MatrixXd &m : curve_friction)
    shorten_columns(m);
  loads.shorten(x);
}

void TaylorMotion::take(const std::vector<EventState> &states) {
  if (!rows_are_current)
    make_rows(states);
  g.resize(states.size());
  r.resize(states.size());
  s.assign(states.size(), Eigen::MatrixXd(2, 0));
  curve_friction.resize(states.size());
}

double TaylorMotion::first_length(const std::vector<EventState> &states, const double longest) {
  take(states);
  return guess > 0. ? std::min(longest, guess) : longest;
}

double TaylorMotion::compute(const LoadCourse &course, const double time, const double longest,
                             const Vector &unknowns, const Vector &velocity,
                             const std::vector<EventState> &states,
                             const std::vector<Eigen::Vector3d> &forces) {
  double length = first_length(states, longest);
  for (;;) {
    length = loads.expand(course, time, length, longest);
    for (const unsigned int i : curves)
      curve_friction[i].setZero(2, 0);
    begin_series(&unknowns, &velocity);
    expand_series(length, states, &forces);
    double part = valid_part();
    if (part >= 1e-3 && !curves.empty()) {
      shorten_all(part);
      length *= part;
      const double found = find_friction(time, length, states, forces);
      if (found == 0.)
        return 0.;
      loads.shorten(found);
      length *= found;
      part = 1.;
      begin_series(&unknowns, &velocity);
      expand_series(length, states, &forces);
      part = valid_part();
    }
    if (part < 1e-3) { // far off: the high orders may have no digit left
      length /= part > 0. ? 100. : 1e4;
      continue;
    }
    if (part < 1.) {
      shorten_all(part);
      length *= part;
    }
    guess = part < 1. ? 1.05 * length : std::max(guess, 1.5 * length);
    return length;
  }
}

} // namespace frictionbeam
