// SPDX-License-Identifier: LGPL-2.1-or-later
#include "increment_equations.h"

#include <frictionbeam/contact/tolerances.h>

#include <algorithm>
#include <cstring>
#include <limits>

namespace frictionbeam::contact {

namespace {

Vector positive_diagonal(const SparseMatrix &matrix) {
  Vector diagonal = matrix.diagonal();
  const double mean = diagonal.size() > 0 ? diagonal.mean() : 1.;
  for (double &d : diagonal)
    d = d > 0. ? d : mean > 0. ? mean : 1e6;
  return diagonal;
}

/// Place of an entry among the values.
int place_of(const SparseMatrix &matrix, const int row, const int column) {
  const int *const begin = matrix.innerIndexPtr() + matrix.outerIndexPtr()[row],
                   *const end = matrix.innerIndexPtr() + matrix.outerIndexPtr()[row + 1];
  return std::lower_bound(begin, end, column) - matrix.innerIndexPtr();
}

/// Whether all bits of two lists are the same.
bool are_same(const std::vector<Block> &a, const std::vector<Block> &b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Block)) == 0;
}

} // namespace

IncrementEquations::IncrementEquations(const Settings &settings, const SiteList &contacts,
                                       const Condensation &line, ProximalSites &proximal)
    : settings(settings), contacts(contacts), S(line.matrix()), proximal(proximal),
      diagonal(positive_diagonal(S)), line(line), stiffness(S.pruned()),
      start_strain(contacts.size()) {
  first_place.push_back(0);
  first_value.push_back(0);
  for (unsigned int i = 0; i < contacts.size(); ++i) {
    moves.emplace_back();
    for (unsigned int j = 0; j < contacts[i].unknowns.size(); ++j)
      places.push_back({line.place(contacts[i].unknowns[j]), contacts[i].B.col(j)});
    first_place.push_back(places.size());
    for (unsigned int strain = 0; strain < 4; ++strain)
      moves.back()[strain] = (contacts[i].B.row(strain).array() != 0.).any();
    for (unsigned int a = first_place[i]; a < places.size(); ++a)
      for (unsigned int b = first_place[i]; b < places.size(); ++b)
        value_places.push_back(place_of(S, places[a].unknown, places[b].unknown));
    first_value.push_back(value_places.size());
  }
  for (int i = 0; i < S.rows(); ++i)
    diagonal_places.push_back(place_of(S, i, i));
  find_changing();
  if (factors.is_of_body())
    reduced.emplace(S, contacts, unknowns_of_contacts());
}

void IncrementEquations::find_changing() {
  std::vector<int> changing = value_places; // in the values of S
  changing.insert(changing.end(), diagonal_places.begin(), diagonal_places.end());
  std::sort(changing.begin(), changing.end());
  changing.erase(std::unique(changing.begin(), changing.end()), changing.end());
  for (std::vector<int> *const list : {&value_places, &diagonal_places})
    for (int &place : *list)
      place = std::lower_bound(changing.begin(), changing.end(), place) - changing.begin();
  for (const int place : changing)
    changing_of_S.push_back(S.valuePtr()[place]);
  factors.analyze(S, changing);
}

void IncrementEquations::begin(const Vector &forces, const double largest, const double so_far,
                               std::vector<Strains> strain, const double displacement,
                               const State &state, const Increment &of_time) {
  loads = line.condense(forces);
  largest_load = largest;
  force_so_far = so_far;
  committed = &state;
  increment = of_time;
  start_displacement = displacement;
  forget_check();
  start_strain = std::move(strain);
}

void IncrementEquations::place(const Vector &x, Response &response) const {
  contacts.prepare(response);
  for (unsigned int i = 0; i < contacts.size(); ++i)
    response.state.strain[i] = start_strain[i] + strain_of(i, x);
}

void IncrementEquations::evaluate(const Vector &x, Response &response) {
  evaluate_contacts(x, response);
  left_by_body.resize(loads.size());
  const int *const outer = stiffness.outerIndexPtr(), *const inner = stiffness.innerIndexPtr();
  const double *const values = stiffness.valuePtr();
  for (int row = 0; row < stiffness.rows(); ++row) {
    double elastic = 0.;
    for (int p = outer[row]; p < outer[row + 1]; ++p)
      elastic += values[p] * x[inner[p]];
    left_by_body[row] = loads[row] - elastic;
  }
  if (drag > 0.)
    left_by_body -= drag * diagonal.cwiseProduct(x);
}

void IncrementEquations::evaluate_contacts(const Vector &x, Response &response) {
  place(x, response);
  displacement_rounding = rounding_of_motion(x);
  forget_check();
  proximal.evaluate(*committed, increment, LawTangent::consistent, response);
}

void IncrementEquations::evaluate_on_step(const double length, const Vector &x,
                                          Response &response) {
  if (length == 1.) {
    evaluate(x, response);
    left_at_end = left_by_body;
    return;
  }
  evaluate_contacts(x, response);
  left_by_body = left_at_start + length * (left_at_end - left_at_start);
}

Vector IncrementEquations::forces_left(const Response &response) const {
  Vector forces = left_by_body;
  for (unsigned int i = 0; i < contacts.size(); ++i)
    subtract_force(i, response.stress[i], forces);
  return forces;
}

bool IncrementEquations::balanced(const Vector &forces, const Vector &x, const Response &response,
                                  Result &result) {
  double largest = largest_load;
  for (unsigned int i = 0; i < contacts.size(); ++i)
    largest = std::max(largest, contacts[i].largest_force(response.stress[i]));
  const double size = forces.size() > 0 ? forces.lpNorm<Eigen::Infinity>() : 0.;
  result.residual = largest > 0. ? size / largest : size;
  double stiffest = x.size() > 0 ? diagonal.cwiseProduct(x).lpNorm<Eigen::Infinity>() : 0.;
  for (unsigned int i = 0; i < contacts.size(); ++i)
    if (!proximal.is_exact(i)) // its force is as inexact as the displacement that makes it
      stiffest = std::max(stiffest, contacts[i].share() * std::abs(response.tangent[i](0, 0) *
                                                                   response.state.strain[i][0]));
  force_left = size;
  largest_force = std::max(largest, force_so_far);
  rounding = 8. * std::numeric_limits<double>::epsilon() * stiffest;
  return size <=
         std::max(settings.tolerance * largest, std::min(rounding, most_excused * largest_force));
}

double IncrementEquations::energy(const Vector &forces) const {
  return forces.cwiseProduct(forces).cwiseQuotient(diagonal).sum();
}

double IncrementEquations::energy_together(const Response &response) const {
  Vector forces = left_by_body;
  double misfit = 0.;
  for (unsigned int i = 0; i < contacts.size(); ++i) {
    Strains stress = response.stress[i];
    if (proximal.is_exact(i)) {
      stress.head<3>() = proximal.centre[i].head<3>();
      misfit += contacts[i].weight * proximal.misfit[i].cwiseAbs2().dot(proximal.by_centre(i));
    }
    subtract_force(i, stress, forces);
  }
  return energy(forces) + misfit;
}

const Check &IncrementEquations::check(const Response &response) {
  if (!checked)
    checked = proximal.check(response, *committed, displacement_rounding);
  return *checked;
}

double IncrementEquations::rounding_of_motion(const Vector &x) const {
  const double largest = x.size() > 0 ? x.lpNorm<Eigen::Infinity>() : 0.;
  return 8. * std::numeric_limits<double>::epsilon() * (start_displacement + largest);
}

std::vector<std::vector<int>> IncrementEquations::unknowns_of_contacts() const {
  std::vector<std::vector<int>> unknowns(contacts.size());
  for (unsigned int i = 0; i < contacts.size(); ++i)
    for (unsigned int j = first_place[i]; j < first_place[i + 1]; ++j)
      unknowns[i].push_back(places[j].unknown);
  return unknowns;
}

void IncrementEquations::add_block(const unsigned int i, const Block &stiffness) {
  const int *place = value_places.data() + first_value[i];
  for (unsigned int a = first_place[i]; a < first_place[i + 1]; ++a) {
    const Strains row = contacts[i].weight * stiffness.transpose() * places[a].strain;
    for (unsigned int b = first_place[i]; b < first_place[i + 1]; ++b)
      tangent[*place++] += row.dot(places[b].strain);
  }
}

void IncrementEquations::begin_tangent(const double shift) {
  factored.clear();
  tangent = changing_of_S;
  shift_tangent(shift);
}

void IncrementEquations::shift_tangent(const double shift) {
  if (shift != 0.)
    for (int i = 0; i < diagonal.size(); ++i)
      tangent[diagonal_places[i]] += shift * diagonal[i];
}

bool IncrementEquations::factor_tangent() { return factors.factorize(tangent); }

bool IncrementEquations::differs_without_unknowns(const Response &response) const {
  if (reduced || is_shifted || factored.size() != contacts.size())
    return false;
  for (unsigned int i = 0; i < contacts.size(); ++i) {
    if (std::memcmp(&response.tangent[i], &factored[i], sizeof(Block)) == 0)
      continue;
    for (unsigned int row = 0; row < 4; ++row)
      for (unsigned int column = 0; column < 4; ++column)
        if (moves[i][row] && moves[i][column] &&
            response.tangent[i](row, column) != factored[i](row, column))
          return false;
  }
  return true;
}

bool IncrementEquations::factor(const Response &response, Result &result) {
  if (are_same(response.tangent, factored)) // nothing slides, nothing opened or closed
    return true;
  if (differs_without_unknowns(response)) {
    status_of_factors = response.status;
    factored = response.tangent;
    return true;
  }
  is_reduced = reduced && drag == 0.;
  if (!is_reduced)
    return factor_all(response, result);
  factored.clear();
  ++result.factorizations;
  is_reduced = reduced->factorize(response.tangent);
  if (!is_reduced)
    return factor_all(response, result);
  factored = response.tangent;
  return true;
}

bool IncrementEquations::factor_all(const Response &response, Result &result) {
  constexpr double hardly_any = 1e-12; // left of a pivot
  is_reduced = false;
  status_of_factors = response.status;
  begin_tangent(0.);
  for (unsigned int i = 0; i < contacts.size(); ++i)
    add_block(i, response.tangent[i]);
  double shifted = -drag;
  for (const double shift : {0., 1e-9, 1e-6}) { // there is no pivoting
    shift_tangent(shift - shifted);
    shifted = shift;
    ++result.factorizations;
    if (factors.factorize(tangent)) {
      is_shifted = shift > 0.;
      is_singular = is_shifted || factors.least_share() < hardly_any;
      factored = response.tangent;
      return true;
    }
  }
  return false;
}

bool IncrementEquations::is_held(const Response &response, Result &result) {
  return (response.status == status_of_factors || factor_all(response, result)) && !is_singular;
}

bool IncrementEquations::solve(const Vector &forces, const Response &response, Result &result,
                               Vector &direction) {
  if (is_reduced) {
    if (reduced->solve(forces, direction))
      return true;
    if (!factor_all(response, result))
      return false;
  }
  direction = factors.solve(forces);
  return true;
}

void IncrementEquations::restore(const WarmStart &memory) {
  factored.clear();
  if (memory.factored.empty())
    return;
  Response response;
  response.tangent = memory.factored;
  Result not_counted;
  factor(response, not_counted);
}

void IncrementEquations::set_drag(const double factor) {
  drag = factor;
  factored.clear();
}

} // namespace frictionbeam::contact
