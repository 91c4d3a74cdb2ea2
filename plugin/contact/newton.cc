// SPDX-License-Identifier: LGPL-2.1-or-later
#include "newton.h"
#include "free_motion.h"
#include <frictionbeam/contact/halving_search.h>
#include <frictionbeam/contact/tolerances.h>

#include <Eigen/LU>
#include <algorithm>
#include <limits>

namespace frictionbeam::contact {

namespace {

constexpr unsigned int most_proximal = 15, most_stalls = 4;
constexpr double stiffness_of_direction = 1e6;
/// Part of the largest force up to which rounding may be left to the refinement on the whole line.
constexpr double most_rounding = 1e-2;
/// Parts of the tolerances at which nothing is left to gain, and of the merit that a step must
/// leave for another one to be worth it.
constexpr double sharp = 1e-4, least_gain = 0.25;

Vector positive_diagonal(const SparseMatrix &matrix) {
  Vector diagonal = matrix.diagonal();
  const double mean = diagonal.size() > 0 ? diagonal.mean() : 1.;
  for (double &d : diagonal)
    d = d > 0. ? d : mean > 0. ? mean : 1.;
  return diagonal;
}

/// Place of an entry among the values.
int place_of(const SparseMatrix &matrix, const int row, const int column) {
  const int *const begin = matrix.innerIndexPtr() + matrix.outerIndexPtr()[row],
                   *const end = matrix.innerIndexPtr() + matrix.outerIndexPtr()[row + 1];
  return std::lower_bound(begin, end, column) - matrix.innerIndexPtr();
}

} // namespace

Newton::Newton(const Settings &settings, const SiteList &contacts, const Condensation &line,
               ProximalSites &proximal)
    : settings(settings), contacts(contacts), S(line.matrix()), line(line), proximal(proximal),
      places(contacts.size()), diagonal(positive_diagonal(S)), start_strain(contacts.size()) {
  factors.analyze(S);
  for (int i = 0; i < S.rows(); ++i)
    diagonal_places.push_back(place_of(S, i, i));
  tangent = S;
  for (unsigned int i = 0; i < contacts.size(); ++i) {
    for (const int unknown : contacts[i].unknowns)
      places[i].unknowns.push_back(line.place(unknown));
    for (const int row : places[i].unknowns)
      for (const int column : places[i].unknowns)
        places[i].values.push_back(place_of(S, row, column));
  }
  if (factors.is_of_body())
    reduced.emplace(S, contacts, unknowns_of_contacts());
}

void Newton::begin(const Vector &forces, const double largest, const double so_far,
                   std::vector<Strains> strain, const double displacement, const State &state,
                   const Increment &of_time) {
  loads = line.condense(forces);
  largest_load = largest;
  force_so_far = so_far;
  is_barred = is_proved = false;
  committed = &state;
  increment = of_time;
  start_displacement = displacement;
  start_strain = std::move(strain);
}

void Newton::evaluate(const Vector &x, Response &response) {
  contacts.prepare(response);
  for (unsigned int i = 0; i < contacts.size(); ++i)
    response.state.strain[i] = start_strain[i] + strain_of(i, x);
  largest_displacement = start_displacement + (x.size() > 0 ? x.lpNorm<Eigen::Infinity>() : 0.);
  proximal.evaluate(*committed, increment, LawTangent::consistent, response);
  left_by_body = loads - S * x;
  if (drag > 0.)
    left_by_body -= drag * diagonal.cwiseProduct(x);
}

Vector Newton::forces_left(const Response &response) const {
  Vector forces = left_by_body;
  for (unsigned int i = 0; i < contacts.size(); ++i)
    subtract_force(i, response.stress[i], forces);
  return forces;
}

bool Newton::balanced(const Vector &forces, const Vector &x, const Response &response,
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

std::string Newton::rounding_remark() const {
  return too_much_rounding(force_left, largest_force) +
         ": what carries the loads is too stiff for them, or something moves freely before a "
         "contact closes";
}

double Newton::energy(const Vector &forces) const {
  return forces.cwiseProduct(forces).cwiseQuotient(diagonal).sum();
}

double Newton::energy_together(const Response &response) const {
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

Check Newton::check(const Response &response) const {
  return proximal.check(response, *committed,
                        8. * std::numeric_limits<double>::epsilon() * largest_displacement);
}

void Newton::add_block(const unsigned int i, const Block &stiffness) {
  const auto &B = contacts[i].B;
  const Eigen::MatrixXd block = contacts[i].weight * B.transpose() * stiffness * B;
  for (Eigen::Index a = 0, v = 0; a < block.rows(); ++a)
    for (Eigen::Index b = 0; b < block.cols(); ++b, ++v)
      tangent.valuePtr()[places[i].values[v]] += block(a, b);
}

void Newton::begin_tangent(const double shift) {
  factored.clear();
  std::copy(S.valuePtr(), S.valuePtr() + S.nonZeros(), tangent.valuePtr());
  for (int i = 0; i < tangent.rows(); ++i)
    tangent.valuePtr()[diagonal_places[i]] += shift * diagonal[i];
}

bool Newton::factor(const Response &response, Result &result) {
  if (response.tangent == factored) // nothing slides, nothing opened or closed
    return true;
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

bool Newton::factor_all(const Response &response, Result &result) {
  is_reduced = false;
  begin_tangent(0.);
  for (unsigned int i = 0; i < contacts.size(); ++i)
    add_block(i, response.tangent[i]);
  double shifted = -drag;
  for (const double shift : {0., 1e-9, 1e-6}) { // there is no pivoting
    for (int i = 0; i < tangent.rows(); ++i)
      tangent.valuePtr()[diagonal_places[i]] += (shift - shifted) * diagonal[i];
    shifted = shift;
    ++result.factorizations;
    if (factors.factorize(tangent)) {
      factored = response.tangent;
      return true;
    }
  }
  return false;
}

bool Newton::solve(const Vector &forces, const Response &response, Result &result,
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

void Newton::restore(const WarmStart &memory) {
  factored.clear();
  if (memory.factored.empty())
    return;
  Response response;
  response.tangent = memory.factored;
  Result not_counted;
  factor(response, not_counted);
}

bool Newton::slides_away(const Vector &x, Response &response) {
  constexpr double shift = 1e-9;
  evaluate(x, response);
  Vector forces = forces_left(response);
  if (drag > 0.) // the loads' own
    forces += drag * diagonal.cwiseProduct(x);
  begin_tangent(shift);
  const double stiff = diagonal.size() > 0 ? diagonal.maxCoeff() : 1.;
  for (unsigned int i = 0; i < contacts.size(); ++i) // what is closed holds along its normal
    if (response.status[i] != ContactStatus::open)
      add_block(i, stiff * contacts[i].length * contacts[i].length / contacts[i].weight *
                       Strains::UnitX().asDiagonal());
  if (!factors.factorize(tangent))
    return false;
  const Vector motion = factors.solve(forces);
  const double work = forces.dot(motion);
  return work > 0. && motion.dot(S * motion) <= 1e-3 * work && loads_do(work, motion) &&
         is_resisted_in_vain(motion, response);
}

bool Newton::is_resisted_in_vain(const Vector &motion, const Response &response) {
  for (unsigned int i = 0; i < contacts.size(); ++i)
    if (!proximal.gives_utmost(i, response, strain_of(i, motion)))
      return false;
  if (!is_proved) { // once for these loads
    motion_of_proof = find_free_motion(contacts, unknowns_of_contacts(), S, diagonal, loads, motion)
                          .value_or(Vector());
    is_proved = true;
  }
  return motion_of_proof.size() > 0;
}

void Newton::set_drag(const double factor) {
  drag = factor;
  is_barred = false;
  factored.clear();
}

bool Newton::strains_nothing(const Vector &x) {
  constexpr double shift = 1e-12, soft = 1e-13;
  begin_tangent(shift);
  if (!factors.factorize(tangent))
    return false;
  Vector part = x;
  for (int iteration = 0; iteration < 3; ++iteration) // what is strained shrinks by its stiffness
    part = factors.solve(shift * diagonal.cwiseProduct(part));
  return part.norm() > x.norm() / 2. &&
         part.dot(S * part) <= soft * part.dot(diagonal.cwiseProduct(part));
}

bool Newton::drag_alone_holds(const Vector &x, const Response &response) {
  constexpr double hardly_elastic = 1e-3;
  const double work = drag * x.dot(diagonal.cwiseProduct(x));
  return work > 0. && loads_do(work, x) && x.dot(S * x) <= hardly_elastic * work &&
         strains_nothing(x) && is_resisted_in_vain(x, response);
}

bool Newton::loads_do(const double work, const Vector &motion) const {
  constexpr double rounding_of_work = 1e-3;
  return loads.dot(motion) >= (1. - rounding_of_work) * work;
}

Outcome Newton::solve_proximal(Vector &x, Response &response, Result &result) {
  evaluate(x, response);
  Vector forces = forces_left(response), direction;
  for (unsigned int iteration = 0;; ++iteration) {
    if (settings.in_each_iteration)
      settings.in_each_iteration();
    if (response.failed) {
      result.remark = "a law had no answer";
      return Outcome::stalled;
    }
    if (balanced(forces, x, response, result))
      return Outcome::solved;
    ++result.iterations;
    const bool regular = iteration < most_proximal && factor(response, result) &&
                         solve(forces, response, result, direction);
    if (!regular) {
      result.remark = "no convergence in " + std::to_string(most_proximal) + " iterations";
      return slides_away(x, response) ? Outcome::slides_away : Outcome::stalled;
    }
    const Vector start = x;
    const auto go = [&](const double length) {
      x = start + length * direction;
      evaluate(x, response);
      forces = forces_left(response);
      return energy(forces);
    };
    search_by_halving(go, energy(forces), 0.0625);
  }
}

void Newton::eliminate_centre(Response &response, std::vector<Strains> &step) const {
  const double epsilon = std::min(1., proximal.stiffness_factor / stiffness_of_direction);
  for (unsigned int i = 0; i < contacts.size(); ++i) {
    if (!proximal.is_exact(i)) {
      step[i].setZero();
      continue;
    }
    proximal.centre[i][3] = response.stress[i][3]; // torsion has no proximal term
    const Block D = response.tangent[i];
    const Eigen::PartialPivLU<Block> M(Block::Identity() -
                                       (1. - epsilon) * D * proximal.by_centre(i).asDiagonal());
    response.tangent[i] = M.solve(D);
    step[i] = M.solve(proximal.misfit[i]);
    response.stress[i] = proximal.centre[i] + step[i];
  }
}

Outcome Newton::solve_together(const unsigned int most_iterations, Vector &x, Response &response,
                               Result &result) {
  std::vector<Strains> step(contacts.size());
  evaluate(x, response);
  double before = energy_together(response);
  Vector direction;
  unsigned int stalls = 0;
  struct Solved {
    Vector x;
    std::vector<Strains> centre;
    double merit;
  };
  std::optional<Solved> solved; // the best so far that the tolerances accept
  const auto take = [&]() {
    if (!response.failed && before <= solved->merit)
      return Outcome::solved;
    x = solved->x;
    proximal.centre = solved->centre;
    evaluate(x, response);
    balanced(forces_left(response), x, response, result);
    return Outcome::solved;
  };
  for (unsigned int iteration = 0;; ++iteration) {
    if (settings.in_each_iteration)
      settings.in_each_iteration();
    if (response.failed || !(before < std::numeric_limits<double>::max()))
      return solved ? take() : Outcome::stalled;
    // A tenth of the tolerance is aimed at, and the whole accepted where rounding bars the way.
    // From there a step or two more, on the same states of contact, reach rounding.
    const bool last = iteration == most_iterations || stalls == most_stalls;
    const bool is_balanced = balanced(forces_left(response), x, response, result);
    const double natural_map = check(response).natural_map;
    const bool holds = is_balanced && natural_map <= (last ? 1. : 0.1) * settings.contact_tolerance;
    if (solved && (before > least_gain * solved->merit || (last && !holds))) {
      if (!holds)
        before = std::numeric_limits<double>::max();
      return take();
    }
    if (holds &&
        (last || (natural_map <= sharp * settings.contact_tolerance &&
                  force_left <= std::max(sharp * settings.tolerance * largest_force, rounding))))
      return Outcome::solved;
    if (holds)
      solved = {x, proximal.centre, before};
    if (last) {
      if (force_left > rounding || natural_map > settings.contact_tolerance)
        return Outcome::stalled;
      // As good as rounding lets it be: what is left is solved for once more, on the whole line.
      if (force_left <= most_rounding * largest_force)
        return Outcome::solved;
      if (slides_away(x, response))
        return Outcome::slides_away;
      is_barred = true;
      return Outcome::stalled;
    }

    eliminate_centre(response, step);
    ++result.iterations;
    if (!factor(response, result) || !solve(forces_left(response), response, result, direction)) {
      before = std::numeric_limits<double>::max();
      if (solved)
        return take();
      return slides_away(x, response) ? Outcome::slides_away : Outcome::stalled;
    }
    const Vector start = x;
    for (unsigned int i = 0; i < contacts.size(); ++i)
      if (proximal.is_exact(i))
        step[i] += response.tangent[i] * strain_of(i, direction);

    const std::vector<Strains> centre = proximal.centre;
    const auto go = [&](const double length) {
      x = start + length * direction;
      for (unsigned int i = 0; i < contacts.size(); ++i)
        proximal.centre[i] = centre[i] + length * step[i];
      evaluate(x, response);
      return energy_together(response);
    };
    before = take_step_of_both(go, before, stalls);
  }
}

} // namespace frictionbeam::contact
