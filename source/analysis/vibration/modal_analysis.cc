// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/algebra/eigenpairs.h"
#include "analysis/algebra/rigid_holds.h"
#include "analysis/contact/opposed_contacts.h"

#include "analysis/vibration/modal_analysis.h"
#include "base/algebra/dense_algebra.h"
#include "base/numbers.h"
#include "base/user_error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace frictionbeam {

using namespace dealii;

namespace {

constexpr double stiff = 1e3; ///< times the line's largest stiffness: as good as rigid
constexpr unsigned int largest_dense = 300;

double frequency_of(const double eigenvalue) {
  return std::sqrt(std::max(eigenvalue, 0.)) / (2. * numbers::PI);
}

/// 1 (rad/s)^2, or less where a line is so soft that this would hide its lowest modes: 1e-7 of the
/// slowest motion of a single unknown.
double choose_shift(const SparseMatrix &K, const Eigen::SparseMatrix<double> &M) {
  const Vector stiffness = K.diagonal(), mass = M.diagonal();
  double slowest = 1e7;
  for (int i = 0; i < mass.size(); ++i)
    if (mass[i] > 0. && stiffness[i] > 0.)
      slowest = std::min(slowest, stiffness[i] / mass[i]);
  return 1e-7 * slowest;
}

} // namespace

ModalAnalysis::ModalAnalysis(const Model &model, const LineState &state,
                             const ModalSettings &settings)
    : model(model), start(state),
      matrices(model.scene, model.mesh, model.discretization, model.space, settings.lumped),
      M(matrices.unknowns_to_dofs().transpose() * matrices.mass() * matrices.unknowns_to_dofs()),
      K(model.linear.stiffness()), shift(choose_shift(K, M)) {
  hold_contacts(state, settings.friction_holds);
  const SparseMatrix A = K + shift * SparseMatrix(M);
  shifted.analyze(A);
  factors.analyze(K);
  if (!shifted.factorize(A))
    throw UserError("Modes: a part of the line that has no mass is held by nothing. Give it mass "
                    "(Density, Mass) or hold it.");
  factors.factorize(K);

  const unsigned int size = M.rows();
  unsigned int moving = 0; // unknowns with mass: there are at most so many modes
  const Vector diagonal = M.diagonal();
  for (unsigned int i = 0; i < size; ++i)
    moving += diagonal[i] > 0. ? 1 : 0;
  const unsigned int n = std::min(settings.n_modes, moving);
  if (n == 0)
    throw UserError(
        "Modes: nothing that may move has mass. Give it mass (Density, Mass) or, where "
        "all nodes are held, shorter cells (Mesh/Cell length), or leave out the modes.");
  if (size <= largest_dense || 4 * n > moving)
    solve_dense(n);
  else
    for (unsigned int n_vectors = std::max(2 * n + 2, 20u);; n_vectors *= 2) {
      const bool solved = n_vectors < moving && solve_sparse(n, n_vectors);
      if (solved)
        break;
      if (n_vectors >= moving)
        throw UserError("Modes: ARPACK did not find all of the lowest " + std::to_string(n) +
                        " modes. Ask for another Number.");
    }
  normalize();
}

void ModalAnalysis::hold_contacts(const LineState &state, const bool friction) {
  const Contacts &contacts = model.contacts;
  contacts.prepare(held);
  const std::vector<bool> idle = idle_halves(contacts, state);
  std::vector<HeldStrains> rigid(contacts.size());
  const double stiffest = K.rows() > 0 ? K.diagonal().maxCoeff() : 1.;
  // Vibrations take time, which is when a snubber locks.
  const ContactIncrement increment{state.time, 1., contacts.temperatures(state.load_factors)};
  for (unsigned int i = 0; i < contacts.size(); ++i) {
    const Contact &contact = contacts[i];
    held.state.strain[i] = state.contacts.strain[i];
    contacts.evaluate_law(i, state.contacts, increment, LawTangent::elastic, held);
    held.status[i] = state.contact_status[i];
    const bool closed = held.status[i] != ContactStatus::open && !idle[i],
               sticks = closed && friction && held.status[i] == ContactStatus::stick;
    auto &D = held.tangent[i];
    if (contact.law.has_closed_form()) {
      const FrictionThreshold &law = contact.law.closed_form();
      D.setZero();
      D(0, 0) = law.axial_rigidity;
      D(1, 1) = law.shear_rigidity_y;
      D(2, 2) = law.shear_rigidity_z;
      D(3, 3) = law.torsional_rigidity;
    }
    for (unsigned int r = 0; r < 4; ++r)
      for (unsigned int c = 0; c < 4; ++c)
        if (!closed || ((r > 0 || c > 0) && !sticks))
          D(r, c) = 0.;
    for (unsigned int r = 0; r < 4; ++r)
      rigid[i][r] = D(r, r) > 0. && !(D(r, r) * contact.weight * contact.B.row(r).squaredNorm() <=
                                      stiff * stiffest);
  }
  const SparseMatrix A = K + shift * SparseMatrix(M);
  const auto holds = rigid_holds(A, contacts, rigid);
  for (unsigned int i = 0; i < contacts.size(); ++i)
    for (unsigned int r = 0; r < 4; ++r)
      if (rigid[i][r])
        held.tangent[i](r, r) = holds[i][r] / contacts[i].weight;
  contacts.add_tangent(held, K);
}

void ModalAnalysis::solve_dense(const unsigned int n) {
  how = "dense eigenvalue solver of Eigen";
  const unsigned int size = M.rows();
  const SymmetricEigen mass = symmetric_eigen(Eigen::MatrixXd(M));
  const Vector roots = mass.values.cwiseMax(0.).cwiseSqrt();
  const Eigen::MatrixXd L = mass.vectors * roots.asDiagonal();
  Eigen::MatrixXd flexible(size, size); // (K + shift M)^-1 L
  for (unsigned int i = 0; i < size; ++i)
    flexible.col(i) = shifted.solve(L.col(i));
  const Eigen::MatrixXd G = L.transpose() * flexible;
  const SymmetricEigen eigen = symmetric_eigen((G + G.transpose()) / 2.);
  const double largest = eigen.values[size - 1];
  for (unsigned int i = 0; i < n; ++i) {
    const double value = eigen.values[size - 1 - i];
    if (value <= 1e-14 * largest) // no mass left
      break;
    found.push_back(
        {frequency_of(1. / value - shift), flexible * eigen.vectors.col(size - 1 - i) / value, 0.});
  }
}

bool ModalAnalysis::solve_sparse(const unsigned int n, const unsigned int n_vectors) {
  how = "ARPACK, shift-invert";
  found.clear();
  const std::vector<Eigenpair> pairs = arpack_eigenpairs(
      M, [this](const Vector &x) { return shifted.solve(x); }, -shift, n, n_vectors);
  for (const Eigenpair &pair : pairs)
    found.push_back({frequency_of(pair.value), pair.vector, 0.});
  if (found.empty())
    return false;
  const Mode &mode = found.back();
  const double last = std::pow(2. * numbers::PI * mode.frequency, 2),
               rounding = std::numeric_limits<double>::epsilon() * K.diagonal().maxCoeff() *
                          mode.unknowns.squaredNorm() /
                          std::max(last * mode.unknowns.dot(M * mode.unknowns), not_zero);
  // Between modes that rounding of K alone keeps apart, none is missing.
  const double least_gap = std::min(std::max(1e-6, 4. * rounding), 1e-2);
  return count_eigenvalues_below(Eigen::SparseMatrix<double>(K), M, last * (1. - least_gap)) < n;
}

void ModalAnalysis::normalize() {
  for (Mode &mode : found) {
    const Vector momentum = M * mode.unknowns;
    double scale = 1. / std::sqrt(std::max(mode.unknowns.dot(momentum), not_zero));
    int largest = 0; // its sign is a matter of choice: the largest motion is positive
    mode.unknowns.cwiseAbs().maxCoeff(&largest);
    scale *= mode.unknowns[largest] < 0. ? -1. : 1.;
    const double square = std::pow(2. * numbers::PI * mode.frequency, 2);
    mode.residual = (K * mode.unknowns - square * momentum).norm() /
                    std::max(square * momentum.norm(), not_zero);
    mode.unknowns *= scale;
  }
}

namespace {

bool contains(const std::vector<std::string> &names, const std::string &name) {
  return std::count(names.begin(), names.end(), name) > 0;
}

} // namespace

Vector ModalAnalysis::held_motion(const unsigned int d,
                                  const std::vector<std::string> &names) const {
  const VertexDofs &at = model.discretization.vertex_dofs();
  Vector dofs = Vector::Zero(model.space.n_dofs());
  // What is held moves along the directions in which it is held: by the unit's projection onto
  // them, which may be skew to each other where restraints share a point. That this moves what is
  // free, too, makes no difference: the line at rest is where it is in any case.
  std::map<unsigned int, std::vector<Tensor<1, 6>>> held_at;
  for (unsigned int i = 0; i < model.scene.restraints.size(); ++i)
    if (contains(names, model.scene.restraints[i].name))
      for (const Site &site : model.mesh.restraints[i])
        for (Tensor<1, 6> direction : held_directions(model.scene.restraints[i], site)) {
          std::vector<Tensor<1, 6>> &others = held_at[site.vertex];
          for (const Tensor<1, 6> &other : others)
            direction -= (direction * other) * other;
          if (direction.norm() < no_direction)
            continue;
          direction /= direction.norm();
          others.push_back(direction);
          for (unsigned int c = 0; c < 3; ++c)
            if (const auto dof = at.index(site.vertex, c); dof != numbers::invalid_dof_index)
              dofs[dof] += direction[d] * direction[c];
        }
  for (unsigned int i = 0; i < model.contacts.size(); ++i) {
    const Contact &contact = model.contacts[i];
    if (contains(names, model.scene.supports[contact.support].name) &&
        contact.vertices[1] >= model.discretization.n_line_vertices())
      dofs[at.index(contact.vertices[1], d)] = 1.;
  }
  return dofs;
}

Vector ModalAnalysis::support_motion(const unsigned int d,
                                     const std::vector<std::string> &names) const {
  const VertexDofs &at = model.discretization.vertex_dofs();
  if (names.empty()) { // all of them: the line moves as a whole
    Vector dofs = Vector::Zero(model.space.n_dofs());
    for (unsigned int v = 0; v < model.discretization.vertices().size(); ++v)
      if (const auto dof = at.index(v, d); dof != numbers::invalid_dof_index)
        dofs[dof] = 1.;
    return dofs;
  }
  const Vector dofs = held_motion(d, names);
  const auto &C = matrices.unknowns_to_dofs();
  Vector forces = -C.transpose() * (matrices.stiffness() * dofs);
  ContactResponse response = held;
  for (unsigned int i = 0; i < model.contacts.size(); ++i)
    response.stress[i] = held.tangent[i] * model.contacts[i].strain(dofs);
  Vector contact_forces = Vector::Zero(forces.size());
  model.contacts.add_forces(response, contact_forces);
  forces -= contact_forces;
  for (const Spring &spring : model.scene.springs)
    if (contains(names, spring.name) && spring.other.empty())
      for (unsigned int k = 0; k < 6; ++k)
        if (const double pull = spring.stiffness[k] * spring.directions[k][d]; pull != 0.)
          for (unsigned int c = 0; c < 6; ++c)
            if (spring.directions[k][c] != 0.)
              for (const auto &term :
                   model.space.terms(at.index(model.mesh.points.at(spring.point), c)))
                forces[term.unknown] += term.weight * pull * spring.directions[k][c];
  return C * factors.solve(forces) + dofs;
}

Vector ModalAnalysis::inertia(const Vector &support_motion) const {
  return matrices.unknowns_to_dofs().transpose() * (matrices.mass() * support_motion);
}

double ModalAnalysis::total_mass(const unsigned int d) const { return mass(support_motion(d, {})); }

ModalAnalysis::Vibration ModalAnalysis::at_rest() const {
  return {displaced(Vector::Zero(model.space.n_unknowns())), Vector::Zero(model.space.n_dofs())};
}

ModalAnalysis::Vibration ModalAnalysis::of_mode(const unsigned int k) const {
  return {displaced(found[k].unknowns),
          -std::pow(2. * numbers::PI * found[k].frequency, 2) * motion(k)};
}

ModalAnalysis::Vibration ModalAnalysis::of_inertia(const Vector &motion) const {
  return {displaced(factors.solve(inertia(motion))), -motion};
}

LineState ModalAnalysis::displaced(const Vector &unknowns) const {
  LineState state = start;
  state.unknowns = unknowns;
  state.sections.resize(0); // pipes answer elastically
  model.space.expand(unknowns, state.dofs);
  state.load_factors.assign(state.load_factors.size(), 0.);
  state.load_rates.clear();
  state.load_accelerations.clear();
  state.velocity.setZero();
  state.acceleration.setZero();
  for (unsigned int i = 0; i < model.contacts.size(); ++i) {
    state.contacts.strain[i] = model.contacts[i].strain(state.dofs);
    state.contacts.touch[i].setZero();
    state.contact_stress[i] = held.tangent[i] * state.contacts.strain[i];
    state.contacts.dissipated[i] = 0.;
  }
  return state;
}

} // namespace frictionbeam
