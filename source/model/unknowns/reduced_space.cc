// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/unknowns/reduced_space.h"
#include "base/numbers.h"

#include <frictionbeam/generalized_strain.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>

namespace frictionbeam {

using namespace dealii;

namespace {

Tensor<1, 6> translation(const Vector3 &direction) {
  Tensor<1, 6> row;
  for (unsigned int d = 0; d < 3; ++d)
    row[d] = direction[d];
  return row;
}

Tensor<1, 6> motion(const unsigned int component) {
  Tensor<1, 6> row;
  row[component] = 1.;
  return row;
}

Tensor<1, 6> tensor(const Motion &values) {
  Tensor<1, 6> row;
  for (unsigned int c = 0; c < 6; ++c)
    row[c] = values[c];
  return row;
}

/// Add what of a direction is not held yet, as a unit vector.
void add_orthonormal(Tensor<1, 6> direction, std::vector<Tensor<1, 6>> &held) {
  for (const Tensor<1, 6> &other : held)
    direction -= (direction * other) * other;
  if (direction.norm() > no_direction)
    held.push_back(direction / direction.norm());
}

/// Every direction in which something is held.
std::vector<ReducedSpace::Held> collect(const Scene &scene, const LineMesh &mesh,
                                        const Discretization &discretization) {
  std::vector<ReducedSpace::Held> rows;
  for (unsigned int i = 0; i < scene.restraints.size(); ++i)
    for (const Site &site : mesh.restraints[i])
      for (const Tensor<1, 6> &direction : held_directions(scene.restraints[i], site))
        rows.push_back({site.vertex, direction});
  for (const Load &load : scene.loads)
    if (load.kind == Load::Kind::displacement)
      for (const Load::AtPoint &at : load.at)
        for (unsigned int c = 0; c < 6; ++c)
          if (at.given[c])
            rows.push_back({mesh.points.at(at.point), tensor(unit_motion(at.axes, c))});
  for (unsigned int c = 0; c < 6; ++c)
    if (!scene.free_motions[c])
      for (unsigned int v = 0; v < discretization.n_line_vertices(); ++v)
        rows.push_back({v, motion(c)});

  // The ground: fixed, or a platen free along its normal.
  rows.reserve(rows.size() +
               6 * (discretization.vertices().size() - discretization.n_line_vertices()));
  std::vector<bool> platen(discretization.vertices().size(), false);
  for (const SupportCell &cell : discretization.support_cells()) {
    const FrictionSupport &support = scene.supports[cell.support];
    const unsigned int ground = cell.vertices[1];
    if (support.normal_force == 0. || ground < discretization.n_line_vertices())
      continue;
    platen[ground] = true;
    const LocalAxes axes(cell.axis);
    rows.push_back({ground, translation(axes.y)});
    rows.push_back({ground, translation(axes.z)});
    for (unsigned int c = 3; c < 6; ++c)
      rows.push_back({ground, motion(c)});
  }
  for (unsigned int v = discretization.n_line_vertices(); v < platen.size(); ++v)
    if (!platen[v])
      for (unsigned int c = 0; c < 6; ++c)
        rows.push_back({v, motion(c)});
  return rows;
}

/// The held directions of one vertex, brought to the form: one motion = combination of free ones.
struct VertexElimination {
  std::array<int, 6> pivot_row{{-1, -1, -1, -1, -1, -1}};
  std::vector<Tensor<1, 6>> rows;

  void hold(Tensor<1, 6> row) {
    for (unsigned int c = 0; c < 6; ++c)
      if (pivot_row[c] >= 0) {
        const double factor = row[c];
        row -= factor * rows[pivot_row[c]];
        row[c] = 0.;
      }
    unsigned int pivot = 0;
    for (unsigned int c = 1; c < 6; ++c)
      if (std::abs(row[c]) > std::abs(row[pivot]) * (1. + 1e-12))
        pivot = c;
    if (std::abs(row[pivot]) < 1e-10) // held already
      return;
    row /= double(row[pivot]);
    row[pivot] = 1.;
    for (auto &other : rows) {
      const double factor = other[pivot];
      other -= factor * row;
      other[pivot] = 0.;
    }
    pivot_row[pivot] = rows.size();
    rows.push_back(row);
  }
};

} // namespace

std::vector<Tensor<1, 6>> held_directions(const Restraint &restraint, const Site &site) {
  std::vector<Tensor<1, 6>> held;
  for (unsigned int c = 0; c < 6; ++c)
    if (restraint.fixed[c])
      held.push_back(tensor(unit_motion(restraint.axes, c)));
  for (const Direction &direction : restraint.translations) {
    add_orthonormal(translation(resolve(direction, site.tangent, restraint.name)), held);
    if (direction.kind == Direction::Kind::across && std::abs(site.tangent[2]) > 1. - no_direction)
      add_orthonormal(translation(LocalAxes(site.tangent).z), held);
  }
  return held;
}

ReducedSpace::ReducedSpace(const Scene &scene, const LineMesh &mesh,
                           const Discretization &discretization)
    : rows(collect(scene, mesh, discretization)) {
  const VertexDofs &vertex_dofs = discretization.vertex_dofs();
  std::map<unsigned int, VertexElimination> eliminations;
  for (const Held &held : rows)
    eliminations[held.vertex].hold(held.direction);
  for (unsigned int v = 0; v < discretization.n_line_vertices(); ++v)
    for (unsigned int axis = 0; axis < 3; ++axis)
      if (!discretization.turns(v, axis))
        eliminations[v].hold(motion(3 + axis));

  AffineConstraints<double> constraints;
  for (const auto &[vertex, elimination] : eliminations)
    for (unsigned int c = 0; c < 6; ++c) {
      const auto dof = vertex_dofs.index(vertex, c);
      if (elimination.pivot_row[c] < 0 || dof == numbers::invalid_dof_index)
        continue;
      constraints.add_line(dof);
      const Tensor<1, 6> &row = elimination.rows[elimination.pivot_row[c]];
      for (unsigned int other = 0; other < 6; ++other)
        if (other != c && std::abs(row[other]) > 1e-14)
          constraints.add_entry(dof, vertex_dofs.index(vertex, other), -row[other]);
    }
  constraints.close();

  const auto n = discretization.dof_handler().n_dofs();
  std::vector<int> number(n, -1);
  for (types::global_dof_index dof = 0; dof < n; ++dof)
    if (!constraints.is_constrained(dof))
      number[dof] = n_free++;
  start.reserve(n + 1);
  terms_of_all.reserve(n);
  start.assign(1, 0);
  for (types::global_dof_index dof = 0; dof < n; ++dof) {
    if (number[dof] >= 0)
      terms_of_all.push_back({number[dof], 1.});
    else
      for (const auto &[other, weight] : *constraints.get_constraint_entries(dof))
        terms_of_all.push_back({number[other], weight});
    start.push_back(terms_of_all.size());
  }
}

ReducedSpace::ReducedSpace(const unsigned int n_unknowns,
                           const std::vector<std::vector<Term>> &terms)
    : n_free(n_unknowns), start(1, 0) {
  for (const std::vector<Term> &of_one : terms) {
    terms_of_all.insert(terms_of_all.end(), of_one.begin(), of_one.end());
    start.push_back(terms_of_all.size());
  }
}

namespace {

/// Of an unknown in a degree of freedom.
struct Share {
  int unknown;
  unsigned int place; ///< of the degree of freedom
  double weight;
};

boost::container::small_vector<Share, 24>
shares_of(const std::vector<types::global_dof_index> &dofs, const ReducedSpace &space) {
  boost::container::small_vector<Share, 24> shares;
  for (unsigned int i = 0; i < dofs.size(); ++i)
    for (const ReducedSpace::Term &term : space.terms(dofs[i]))
      shares.push_back({term.unknown, i, term.weight});
  return shares;
}

} // namespace

void ReducedSpace::add_local(const Eigen::Ref<const Eigen::MatrixXd> &local,
                             const std::vector<types::global_dof_index> &dofs,
                             MatrixEntries &entries) const {
  const auto shares = shares_of(dofs, *this);
  for (const Share &column : shares)
    for (const Share &row : shares)
      if (const double value = local(row.place, column.place); value != 0.)
        entries.add(row.unknown, column.unknown, row.weight * column.weight * value);
      else if (local(column.place, row.place) != 0.) // by rounding: the pattern is symmetric
        entries.add_places({row.unknown, column.unknown});
      else
        entries.add(row.unknown, column.unknown, 0.);
}

void ReducedSpace::add_local(const Eigen::Ref<const Eigen::MatrixXd> &local,
                             const std::vector<types::global_dof_index> &dofs,
                             SparseMatrix &matrix) const {
  auto shares = shares_of(dofs, *this);
  std::sort(shares.begin(), shares.end(),
            [](const Share &a, const Share &b) { return a.unknown < b.unknown; });
  for (const Share &row : shares) {
    const int *const end = matrix.innerIndexPtr() + matrix.outerIndexPtr()[row.unknown + 1],
                     *entry = matrix.innerIndexPtr() + matrix.outerIndexPtr()[row.unknown];
    for (const Share &column : shares) {
      const double value = row.weight * column.weight * local(row.place, column.place);
      if (value == 0.)
        continue;
      // Most often the unknown follows that before.
      if (entry != end && *entry < column.unknown)
        ++entry;
      if (entry == end || *entry != column.unknown)
        entry = std::lower_bound(entry, end, column.unknown);
      Assert(entry != end && *entry == column.unknown, ExcInternalError());
      matrix.valuePtr()[entry - matrix.innerIndexPtr()] += value;
    }
  }
}

void ReducedSpace::expand(const Vector &unknowns, Vector &dofs) const {
  dofs.resize(n_dofs());
  for (unsigned int dof = 0; dof < n_dofs(); ++dof) {
    const Term *const first = terms_of_all.data() + start[dof], *const last = terms_of_all.data() +
                                                                              start[dof + 1];
    double value = first == last ? 0. : first->weight * unknowns[first->unknown];
    for (const Term *term = first + 1; term < last; ++term)
      value += term->weight * unknowns[term->unknown];
    dofs[dof] = value;
  }
}

Vector ReducedSpace::restrict_forces(const Vector &dofs) const {
  Vector forces = Vector::Zero(n_free);
  for (unsigned int dof = 0; dof < n_dofs(); ++dof)
    for (const Term &term : terms(dof))
      forces[term.unknown] += term.weight * dofs[dof];
  return forces;
}

} // namespace frictionbeam
