// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/contact/halving_search.h"

#include "analysis/statics/continuum_newton.h"
#include "base/interruption.h"
#include "base/numbers.h"

#include <Eigen/LU>

#include <limits>

namespace frictionbeam {

using namespace dealii;

namespace {

constexpr double stiffness_of_direction = 1e6;
constexpr std::array<double, 4> scales = {1., 0.1, 10., 0.01}; ///< of rho, tried in this order
constexpr unsigned int most_iterations = 40, most_stalls = 6;
constexpr double epsilon_of_rounding = 64. * std::numeric_limits<double>::epsilon();

double largest_of(const ContinuumVector &vector) { return vector.linfty_norm(); }

} // namespace

template <int dim>
ContinuumNewton<dim>::ContinuumNewton(const ContinuumBody<dim> &body, ContinuumSystem &system,
                                      FoundationContacts &contacts)
    : body(body), system(system), contacts(contacts), settings(body.scene.solver) {
  body.reinit(diagonal);
  for (const auto dof : body.owned)
    diagonal(dof) = system.diagonal(dof);
}

template <int dim>
std::vector<LocalVector> ContinuumNewton<dim>::local(const ContinuumVector &u) const {
  std::vector<LocalVector> result(body.nodes.size(), LocalVector::Zero());
  for (unsigned int i = 0; i < body.nodes.size(); ++i)
    for (unsigned int a = 0; a < dim; ++a)
      for (unsigned int d = 0; d < dim; ++d)
        result[i][a] += body.nodes[i].frame[a][d] * u(body.nodes[i].dofs[d]);
  return result;
}

template <int dim>
void ContinuumNewton<dim>::add_forces(const std::vector<LocalVector> &stress,
                                      ContinuumVector &forces) const {
  for (unsigned int i = 0; i < body.nodes.size(); ++i) {
    const auto &node = body.nodes[i];
    for (unsigned int a = 0; a < dim; ++a)
      for (unsigned int d = 0; d < dim; ++d)
        if (!body.constraints.is_constrained(node.dofs[d]))
          forces(node.dofs[d]) += node.weight * node.frame[a][d] * stress[i][a];
  }
}

template <int dim>
void ContinuumNewton<dim>::residual(const ContinuumVector &forces, const ContinuumVector &elastic,
                                    const std::vector<LocalVector> &stress,
                                    ContinuumVector &left) const {
  left = forces;
  left -= elastic;
  add_forces(stress, left);
  body.constraints.set_zero(left);
}

template <int dim>
double ContinuumNewton<dim>::energy(const ContinuumVector &forces) const {
  double sum = 0.;
  for (const auto dof : body.owned)
    sum += forces(dof) * forces(dof) / diagonal(dof);
  return Utilities::MPI::sum(sum, body.communicator);
}

template <int dim>
std::pair<double, double>
ContinuumNewton<dim>::largest(const std::vector<LocalVector> &stress) const {
  double force = 0., traction = 0.;
  for (unsigned int i = 0; i < stress.size(); ++i) {
    traction = std::max(traction, stress[i].norm());
    force = std::max(force, body.nodes[i].weight * stress[i].norm());
  }
  return {Utilities::MPI::max(force, body.communicator),
          Utilities::MPI::max(traction, body.communicator)};
}

template <int dim>
ContinuumNewtonResult ContinuumNewton<dim>::solve(const ContinuumVector &forces,
                                                  const FoundationState &committed,
                                                  const LawIncrement &increment, ContinuumVector &u,
                                                  FoundationResponse &response) {
  ContinuumNewtonResult result;
  contacts.begin(committed);
  const ContinuumVector start = u;
  const auto centre = contacts.centre;
  for (const double scale : scales) {
    contacts.stiffness_factor = scale;
    u = start;
    contacts.centre = centre;
    result.converged = iterate(forces, committed, increment, u, response, result);
    while (result.converged &&
           Utilities::MPI::max(static_cast<unsigned int>(contacts.let_slipping_go(response.state)),
                               body.communicator) > 0)
      result.converged = iterate(forces, committed, increment, u, response, result);
    if (result.converged)
      return result;
  }
  result.remark = "Newton's method on the contacts does not converge";
  return result;
}

template <int dim>
bool ContinuumNewton<dim>::iterate(const ContinuumVector &forces, const FoundationState &committed,
                                   const LawIncrement &increment, ContinuumVector &u,
                                   FoundationResponse &response, ContinuumNewtonResult &result) {
  const unsigned int n = contacts.size();
  const double epsilon = contacts.stiffness_factor / stiffness_of_direction;
  std::vector<LocalVector> step(n), displacement, used(n);
  ContinuumVector left, direction, elastic; // elastic forces: stiffness times u
  body.reinit(left);
  body.reinit(direction);
  body.reinit(elastic);
  const double largest_load = largest_of(forces);

  // Evaluates at u and the centre; the merit of both together.
  const auto evaluate = [&]() {
    displacement = local(u);
    contacts.evaluate(displacement, committed, increment, response);
    double misfit = 0.;
    for (unsigned int i = 0; i < n; ++i) {
      used[i] = response.state.stress[i];
      if (!contacts.is_exact(i))
        continue;
      if (!contacts.has_pressure(i))
        used[i][0] = contacts.centre[i][0];
      used[i].tail<2>() = contacts.centre[i].tail<2>();
      const LocalVector difference = response.state.stress[i] - used[i];
      misfit +=
          body.nodes[i].weight * difference.cwiseProduct(difference).dot(contacts.by_centre(i));
    }
    system.multiply(u, elastic);
    residual(forces, elastic, used, left);
    return energy(left) + Utilities::MPI::sum(misfit, body.communicator);
  };

  double before = evaluate();
  unsigned int stalls = 0;
  for (unsigned int iteration = 0;; ++iteration) {
    interruption::end_if_overdue();
    if (Utilities::MPI::max(static_cast<unsigned int>(response.failed), body.communicator) > 0) {
      result.remark = "a law had no answer";
      return false;
    }
    const auto [contact_force, traction] = largest(response.state.stress);
    const double largest_force = std::max(largest_load, contact_force);
    const double largest_displacement = largest_of(u);
    const double rounding = epsilon_of_rounding * largest_displacement;
    residual(forces, elastic, response.state.stress, left);
    ContinuumVector stiff(u);
    stiff.scale(diagonal);
    const double size = largest_of(left);
    result.residual = largest_force > 0. ? size / largest_force : size;
    ContactCheck check =
        contacts.check(displacement, response.state, committed, traction, rounding);
    check.natural_map = Utilities::MPI::max(check.natural_map, body.communicator);
    check.penetration = Utilities::MPI::max(check.penetration, body.communicator);
    check.cone_violation = Utilities::MPI::max(check.cone_violation, body.communicator);
    check.slip_angle = Utilities::MPI::max(check.slip_angle, body.communicator);
    check.least_dissipation = Utilities::MPI::min(check.least_dissipation, body.communicator);
    result.check = check;
    const bool last = iteration == most_iterations || stalls == most_stalls;
    const double accepted =
        std::max(settings.tolerance * largest_force,
                 std::min(epsilon_of_rounding * largest_of(stiff), most_excused * largest_force));
    if (size <= accepted && check.holds(settings.contact_tolerance) &&
        (last || check.natural_map <= 0.1 * settings.contact_tolerance))
      return true;
    if (last)
      return false;

    // Stress and tangent with the centre eliminated, point by point.
    std::vector<ContinuumSystem::Block> blocks(n);
    bool symmetric = true;
    for (unsigned int i = 0; i < n; ++i) {
      step[i].setZero();
      LocalMatrix &D = response.tangent[i];
      used[i] = response.state.stress[i];
      if (contacts.is_exact(i)) {
        LocalVector centre = contacts.centre[i];
        if (contacts.has_pressure(i))
          centre[0] = used[i][0];
        const LocalMatrix by_centre = -D * contacts.by_centre(i).asDiagonal();
        const Eigen::PartialPivLU<LocalMatrix> M(LocalMatrix::Identity() -
                                                 (1. - epsilon) * by_centre);
        D = M.solve(LocalMatrix(D));
        step[i] = M.solve(LocalVector(used[i] - centre));
        used[i] = centre + step[i];
      }
      symmetric &= (D - D.transpose()).norm() <= no_component * D.norm();
      blocks[i].dofs.assign(body.nodes[i].dofs.begin(), body.nodes[i].dofs.end());
      const auto &frame = body.nodes[i].frame;
      for (unsigned int a = 0; a < dim; ++a)
        for (unsigned int b = 0; b < dim; ++b) {
          double value = 0.;
          for (unsigned int k = 0; k < dim; ++k)
            for (unsigned int l = 0; l < dim; ++l)
              value -= frame[k][a] * D(k, l) * frame[l][b];
          blocks[i].values.push_back(body.nodes[i].weight * value);
        }
    }
    symmetric = Utilities::MPI::min(static_cast<unsigned int>(symmetric), body.communicator) > 0;
    residual(forces, elastic, used, left);
    ++result.iterations;
    if (!system.solve(blocks, symmetric, left, direction)) {
      result.remark = "a linear system could not be solved";
      return false;
    }
    const auto motion = local(direction);
    for (unsigned int i = 0; i < n; ++i)
      if (contacts.is_exact(i))
        step[i] += response.tangent[i] * motion[i];

    const ContinuumVector start = u;
    const auto centre = contacts.centre;
    const auto go = [&](const double length) {
      u = start;
      u.add(length, direction);
      for (unsigned int i = 0; i < n; ++i)
        contacts.centre[i] = centre[i] + length * step[i];
      return evaluate();
    };
    const HalvingResult step_taken = search_by_halving(go, before, 1e-3);
    stalls = step_taken.length < 0.01 || step_taken.merit > before ? stalls + 1 : 0;
    before = step_taken.merit;
  }
}

template class ContinuumNewton<2>;
template class ContinuumNewton<3>;

} // namespace frictionbeam
