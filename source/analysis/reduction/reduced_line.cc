// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/reduction/reduced_line.h"

#include "analysis/reduction/static_shapes.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace frictionbeam {

namespace {

using Eigen::MatrixXd;
using Triplet = Eigen::Triplet<double>;

constexpr double no_entry = 1e-11; ///< of a matrix, relative to its diagonal

/// Points whose motion the scene asks for.
std::set<unsigned int> monitored_vertices(const Model &model) {
  std::set<unsigned int> vertices;
  const auto add = [&](const std::string &point) {
    if (const auto found = model.mesh.points.find(point); found != model.mesh.points.end())
      vertices.insert(found->second);
  };
  for (const std::string &point : model.scene.monitors)
    add(point);
  for (const Quantity &quantity : model.scene.quantities)
    add(quantity.where);
  if (model.scene.exact)
    add(model.scene.exact->point);
  return vertices;
}

/// Vertices whose motion decides the forces of restraints and springs: those of the cells at
/// restraints and at nodes that loads move, and the springs' own.
std::set<unsigned int> vertices_of_reactions(const Model &model) {
  std::set<unsigned int> held, result;
  for (const auto &sites : model.mesh.restraints)
    for (const Site &site : sites)
      held.insert(site.vertex);
  for (const Load &load : model.scene.loads)
    if (load.kind == Load::Kind::displacement)
      for (const Load::AtPoint &at : load.at)
        held.insert(model.mesh.points.at(at.point));
  for (const Spring &spring : model.scene.springs)
    for (const std::string &point : {spring.point, spring.other})
      if (!point.empty())
        held.insert(model.mesh.points.at(point));
  for (unsigned int i = 0; i < model.discretization.pipe_cells().size(); ++i) {
    const auto cell = model.discretization.pipe_cell(i);
    const unsigned int one = cell->vertex_index(0), other = cell->vertex_index(1);
    if (held.count(one) + held.count(other) > 0)
      result.insert({one, other});
  }
  result.insert(held.begin(), held.end());
  return result;
}

/// Project a matrix of a part on its shapes. @param border rows inside, columns of the border
void project(const MatrixXd &shapes, const Eigen::SparseMatrix<double> &inner,
             const MatrixXd &border, MatrixXd &share) {
  share = shapes.transpose() * (inner * shapes);
  const MatrixXd across = shapes.transpose() * border;
  share.leftCols(border.cols()) += across;
  share.topRows(border.cols()) += across.transpose();
}

} // namespace

ReducedLine::ReducedLine(const Model &line, const LineParts &parts, const LineParts::Choice &modes,
                         const LineState &start, const std::vector<bool> &loads)
    : line(line), parts(parts), bases(parts.size()) {
  for (unsigned int p = 0; p < parts.size(); ++p)
    make_basis(p, modes.n_of_part[p], start, loads);
  make_places();
  make_dofs();
  std::vector<std::vector<ReducedSpace::Term>> terms_of_dofs;
  for (const unsigned int dof : dofs) {
    std::vector<ReducedSpace::Term> all;
    for (const auto &outer : line.space.terms(dof))
      for (const auto &inner : terms(outer.unknown))
        all.push_back({inner.unknown, outer.weight * inner.weight});
    terms_of_dofs.push_back(all);
  }
  space = std::make_unique<ReducedSpace>(n, terms_of_dofs);
  contacts = std::make_unique<Contacts>(line.contacts, dof_places, unknown_places, n);
  linear = std::make_unique<LinearPart>(make_matrices());
  cells =
      std::make_unique<LinearCells>(line.scene, line.mesh, line.discretization, *space, *linear);
  reduced = std::make_unique<Model>(
      Model{line.scene, line.mesh, line.discretization, *space, *contacts, *linear, *cells});
}

void ReducedLine::make_basis(const unsigned int p, const unsigned int n_modes,
                             const LineState &start, const std::vector<bool> &loads) {
  const PartOfLine &part = parts[p];
  MatrixXd modes(part.inside.size(), n_modes);
  Vector stiffness(n_modes), mass(n_modes);
  for (unsigned int j = 0; j < n_modes; ++j) {
    modes.col(j) = part.modes[j].vector;
    mass[j] = modes.col(j).dot(part.M * modes.col(j));
    stiffness[j] = part.modes[j].value * mass[j];
  }
  StaticShapes shapes(part, modes, stiffness);
  shapes.add_loads(line.linear, loads);
  if (part.has_mass)
    shapes.add_border_inertia();
  const auto at_border = [&](const Vector &all) {
    Vector border(part.border.size());
    for (unsigned int b = 0; b < part.border.size(); ++b)
      border[b] = all[parts.kept()[part.border[b]]];
    return border;
  };
  shapes.add_state(start.unknowns, at_border(start.unknowns), part.K);
  if (part.has_mass)
    shapes.add_state(start.velocity, at_border(start.velocity), part.M);

  const MatrixXd others = shapes.orthogonal();
  n_shapes += others.cols();
  const unsigned int n_border = part.border.size(), n_own = n_modes + others.cols();
  Basis &basis = bases[p];
  basis.shapes.resize(part.inside.size(), n_border + n_own);
  basis.shapes.leftCols(n_border) = part.constraint_modes;
  basis.shapes.middleCols(n_border, n_modes) = modes;
  basis.shapes.rightCols(others.cols()) = others;
  basis.mass.resize(n_own);
  basis.stiffness.resize(n_own);
  basis.mass.head(n_modes) = mass;
  basis.stiffness.head(n_modes) = stiffness;
  for (int j = 0; j < others.cols(); ++j) {
    basis.stiffness[n_modes + j] = others.col(j).dot(part.K * others.col(j));
    basis.mass[n_modes + j] = part.has_mass ? others.col(j).dot(part.M * others.col(j)) : 0.;
  }
  basis.first = n_eta;
  n_eta += n_own;
}

void ReducedLine::make_places() {
  n = n_eta + parts.kept().size();
  unknown_places.assign(line.space.n_unknowns(), -1);
  for (unsigned int k = 0; k < parts.kept().size(); ++k)
    unknown_places[parts.kept()[k]] = n_eta + k;
}

void ReducedLine::make_dofs() {
  dof_places.assign(line.space.n_dofs(), -1);
  const auto take = [&](const unsigned int dof) {
    if (dof_places[dof] < 0) {
      dof_places[dof] = dofs.size();
      dofs.push_back(dof);
    }
  };
  for (unsigned int i = 0; i < line.contacts.size(); ++i)
    for (const unsigned int dof : line.contacts[i].dofs)
      take(dof);
  const VertexDofs &at = line.discretization.vertex_dofs();
  std::set<int> unknowns;
  for (const unsigned int vertex : monitored_vertices(line)) {
    std::array<int, 6> places;
    for (unsigned int c = 0; c < 6; ++c) {
      const auto dof = at.index(vertex, c);
      places[c] = -1;
      if (dof == dealii::numbers::invalid_dof_index)
        continue;
      take(dof);
      places[c] = dof_places[dof];
      for (const auto &term : line.space.terms(dof))
        unknowns.insert(term.unknown);
    }
    monitored_dofs.push_back(places);
  }
  for (const unsigned int vertex : vertices_of_reactions(line))
    for (unsigned int c = 0; c < 6; ++c)
      if (const auto dof = at.index(vertex, c); dof != dealii::numbers::invalid_dof_index) {
        take(dof);
        for (const auto &term : line.space.terms(dof))
          unknowns.insert(term.unknown);
      }
  for (const int unknown : unknowns)
    monitored_unknowns.emplace_back(unknown, terms(unknown));
}

std::vector<ReducedSpace::Term> ReducedLine::terms(const int unknown) const {
  if (unknown_places[unknown] >= 0)
    return {{unknown_places[unknown], 1.}};
  const auto &[p, row] = parts.home(unknown);
  const PartOfLine &part = parts[p];
  const Basis &basis = bases[p];
  const unsigned int n_border = part.border.size();
  std::vector<ReducedSpace::Term> result;
  for (int j = 0; j < basis.shapes.cols(); ++j) {
    const unsigned int column = j;
    const int place =
        column < n_border ? n_eta + part.border[column] : basis.first + column - n_border;
    if (basis.shapes(row, j) != 0.)
      result.push_back({place, basis.shapes(row, j)});
  }
  return result;
}

Vector ReducedLine::reduce_forces(const Vector &forces) const {
  Vector result = Vector::Zero(n);
  for (unsigned int k = 0; k < parts.kept().size(); ++k)
    result[n_eta + k] = forces[parts.kept()[k]];
  for (unsigned int p = 0; p < parts.size(); ++p) {
    const Vector inner = parts[p].inner(forces);
    if (inner.isZero(0.))
      continue;
    const Vector share = bases[p].shapes.transpose() * inner;
    const unsigned int n_border = parts[p].border.size();
    for (unsigned int b = 0; b < n_border; ++b)
      result[n_eta + parts[p].border[b]] += share[b];
    result.segment(bases[p].first, share.size() - n_border) += share.tail(share.size() - n_border);
  }
  return result;
}

/// Entries of a reduced matrix.
struct ReducedLine::Assembly {
  const ReducedLine &owner;
  std::vector<Triplet> entries;

  /// What stands between kept unknowns in the line's own matrix.
  void add_kept(const SparseMatrix &matrix) {
    const std::vector<int> &kept = owner.parts.kept();
    if (matrix.nonZeros() > 0)
      for (unsigned int k = 0; k < kept.size(); ++k)
        for (SparseMatrix::InnerIterator entry(matrix, kept[k]); entry; ++entry)
          if (const int place = owner.parts.place(entry.col()); place >= 0)
            entries.emplace_back(owner.n_eta + k, owner.n_eta + place, entry.value());
  }

  /// A part's share, on its border and its own unknowns.
  void add(const unsigned int p, const MatrixXd &share) {
    const PartOfLine &part = owner.parts[p];
    const int n_border = part.border.size();
    const auto place = [&](const int i) {
      return i < n_border ? owner.n_eta + part.border[i] : owner.bases[p].first + i - n_border;
    };
    for (int i = 0; i < share.rows(); ++i)
      for (int j = 0; j < share.cols(); ++j) {
        const double value = (share(i, j) + share(j, i)) / 2.;
        if (std::abs(value) > no_entry * std::sqrt(std::abs(share(i, i) * share(j, j))))
          entries.emplace_back(place(i), place(j), value);
      }
  }

  /// Zeros where tangents of contacts and diagonals will stand.
  void add_pattern() {
    for (unsigned int i = 0; i < owner.contacts->size(); ++i)
      for (const int row : (*owner.contacts)[i].unknowns)
        for (const int column : (*owner.contacts)[i].unknowns)
          entries.emplace_back(row, column, 0.);
    for (unsigned int i = 0; i < owner.n; ++i)
      entries.emplace_back(i, i, 0.);
  }

  SparseMatrix matrix() const {
    SparseMatrix result(owner.n, owner.n);
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
  }
};

LinearPart::Matrices ReducedLine::make_matrices() const {
  Assembly K{*this, {}}, M{*this, {}}, C{*this, {}};
  K.add_pattern();
  K.add_kept(line.linear.stiffness());
  M.add_kept(line.linear.mass());
  C.add_kept(line.linear.damping());
  const bool damped = line.linear.damping().nonZeros() > 0;
  for (unsigned int p = 0; p < parts.size(); ++p) {
    const PartOfLine &part = parts[p];
    const Basis &basis = bases[p];
    const unsigned int n_border = part.border.size(), n_own = basis.mass.size();
    MatrixXd share = MatrixXd::Zero(n_border + n_own, n_border + n_own);
    share.topLeftCorner(n_border, n_border) = part.constraint_modes.transpose() * part.K_border;
    share.bottomRightCorner(n_own, n_own) = basis.stiffness.asDiagonal();
    K.add(p, share);
    if (part.has_mass) {
      project(basis.shapes, part.M, part.M_border, share);
      share.bottomRightCorner(n_own, n_own) = basis.mass.asDiagonal();
      M.add(p, share);
    }
    if (damped) {
      project(basis.shapes, part.C, part.C_border, share);
      C.add(p, share);
    }
  }
  LinearPart::Matrices matrices;
  matrices.stiffness = K.matrix();
  matrices.mass = M.matrix();
  matrices.damping = C.matrix();
  matrices.products = line.linear.imposed_products();
  add_loads(matrices);
  return matrices;
}

void ReducedLine::add_loads(LinearPart::Matrices &matrices) const {
  for (unsigned int l = 0; l < line.scene.loads.size(); ++l) {
    matrices.forces.push_back(reduce_forces(line.linear.forces(l)));
    const bool moves = line.linear.accelerates(l);
    matrices.moves_mass.push_back(moves);
    matrices.inertia.push_back(moves ? reduce_forces(line.linear.inertia(l)) : Vector());
    matrices.drag.push_back(moves ? reduce_forces(line.linear.drag(l)) : Vector());
    matrices.imposed.emplace_back();
    for (const auto &[dof, value] : line.linear.imposed(l))
      if (dof_places[dof] >= 0)
        matrices.imposed.back().emplace_back(dof_places[dof], value);
  }
}

LineState ReducedLine::reduce(const LineState &state) const {
  LineState result = state;
  result.unknowns = result.velocity = result.acceleration = result.auxiliary = Vector::Zero(n);
  const Vector forces = line.linear.stiffness() * state.unknowns,
               momentum = line.linear.mass() * state.velocity;
  for (unsigned int k = 0; k < parts.kept().size(); ++k) {
    result.unknowns[n_eta + k] = state.unknowns[parts.kept()[k]];
    result.velocity[n_eta + k] = state.velocity[parts.kept()[k]];
  }
  for (unsigned int p = 0; p < parts.size(); ++p) {
    const PartOfLine &part = parts[p];
    const Basis &basis = bases[p];
    const unsigned int n_border = part.border.size(), n_own = basis.mass.size();
    const auto own = basis.shapes.rightCols(n_own);
    Vector border_velocity(n_border);
    for (unsigned int b = 0; b < n_border; ++b)
      border_velocity[b] = state.velocity[parts.kept()[part.border[b]]];
    const Vector with_border =
        part.M_border * border_velocity + part.M * (part.constraint_modes * border_velocity);
    result.unknowns.segment(basis.first, n_own) =
        (own.transpose() * part.inner(forces)).cwiseQuotient(basis.stiffness);
    const Vector rate = own.transpose() * (part.inner(momentum) - with_border);
    for (unsigned int j = 0; j < n_own; ++j)
      if (basis.mass[j] > 0.)
        result.velocity[basis.first + j] = rate[j] / basis.mass[j];
  }
  result.dofs.resize(dofs.size());
  for (unsigned int d = 0; d < dofs.size(); ++d)
    result.dofs[d] = state.dofs[dofs[d]];
  return result;
}

Vector ReducedLine::all_unknowns(const Vector &reduced_unknowns) const {
  Vector result(line.space.n_unknowns());
  for (unsigned int k = 0; k < parts.kept().size(); ++k)
    result[parts.kept()[k]] = reduced_unknowns[n_eta + k];
  for (unsigned int p = 0; p < parts.size(); ++p) {
    const PartOfLine &part = parts[p];
    const unsigned int n_border = part.border.size(), n_own = bases[p].mass.size();
    Vector local(n_border + n_own);
    for (unsigned int b = 0; b < n_border; ++b)
      local[b] = reduced_unknowns[n_eta + part.border[b]];
    local.tail(n_own) = reduced_unknowns.segment(bases[p].first, n_own);
    const Vector inner = bases[p].shapes * local;
    for (unsigned int i = 0; i < part.inside.size(); ++i)
      result[part.inside[i]] = inner[i];
  }
  return result;
}

void ReducedLine::expand(const LineState &state, const bool everything, LineState &full) const {
  full.time = state.time;
  full.load_factors = state.load_factors;
  full.load_rates = state.load_rates;
  full.load_accelerations = state.load_accelerations;
  full.contacts = state.contacts;
  full.contact_stress = state.contact_stress;
  full.contact_status = state.contact_status;
  full.events = state.events;
  if (everything) {
    full.unknowns = all_unknowns(state.unknowns);
    full.velocity = all_unknowns(state.velocity);
    full.acceleration = all_unknowns(state.acceleration);
    return;
  }
  for (const auto &[unknown, depends_on] : monitored_unknowns) {
    full.unknowns[unknown] = full.velocity[unknown] = full.acceleration[unknown] = 0.;
    for (const auto &term : depends_on) {
      full.unknowns[unknown] += term.weight * state.unknowns[term.unknown];
      full.velocity[unknown] += term.weight * state.velocity[term.unknown];
      full.acceleration[unknown] += term.weight * state.acceleration[term.unknown];
    }
  }
  for (unsigned int d = 0; d < dofs.size(); ++d)
    full.dofs[dofs[d]] = state.dofs[d];
}

} // namespace frictionbeam
