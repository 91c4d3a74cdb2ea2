// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/algebra/coarse_multigrid.h"
#include "analysis/algebra/elastic_operator.h"

#include <deal.II/lac/diagonal_matrix.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_gmres.h>

#include <Eigen/LU>
#include <chrono>
#include <cstdlib>
#include <cstdio>

namespace frictionbeam {

using namespace dealii;

namespace {

double knob(const char *name, double value) { return getenv(name) ? atof(getenv(name)) : value; }
struct Clock {
  const char *what; std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
  ~Clock() { if (getenv("FB_TIME")) fprintf(stderr, "  %s %.3f s\n", what, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()); }
};

// Accepted though less than what was asked for, relative to the right-hand side: Newton's method
// makes up for what rounding leaves of a direction.
constexpr double margin = 1.1; ///< on the largest eigenvalue, which is approached from below
constexpr double least_accuracy = 1e-7;
constexpr unsigned int most_iterations = 300, most_failures = 2;
/// Of what a contact adds to the coarse stiffness, of the body's own there: more would only make
/// the couplings beside it look weak.
const double most_of_contact = knob("FB_CAP", 10.);
/// Of the contacts, up to which the coarse multigrid is kept while they change, and a change of one
/// that counts, of the body's own stiffness there.
const double few_changes = knob("FB_FEW", 0.03), small_change = 0.3;
/// Iterations, of those of the first system after a set-up, that call for the next one.
constexpr double many_iterations = 1.5;
constexpr types::global_dof_index most_by_fallback = 250000; ///< unknowns that are factored

/// Chebyshev's polynomial in D^-1 A, D being the diagonal, at contacts with the contact's tangent
/// (M. Adams, M. Brezina, J. Hu, R. Tuminaro, J. Comput. Phys. 188 (2003) 593-610).
class Smoother {
public:
  const unsigned int degree = knob("FB_DEGREE", 3); ///< products with A
  const double range = knob("FB_RANGE", 15.);      ///< of eigenvalues that are smoothed

  Smoother(const ContinuumVector &inverse_diagonal, const double largest_eigenvalue)
      : inverse(inverse_diagonal), largest(largest_eigenvalue), step(inverse_diagonal),
        left(inverse_diagonal) {}

  void set_contacts(const std::vector<StiffnessWithContacts::Contact> &contacts);
  /// x += S (b - A x). @param from_zero whether x is zero
  void smooth(const StiffnessWithContacts &A, ContinuumVector &x, const ContinuumVector &b,
              const bool from_zero);

  /// Times D^-1 D_K at contacts, D_K being the diagonal without them (or, transposed, D_K D^-1): what
  /// a coarse correction is multiplied by, so that it is none where a contact holds.
  void scale_contacts(ContinuumVector &vector, const bool transposed) const;

private:
  void scale(ContinuumVector &vector) const;

  const ContinuumVector inverse;
  const double largest;
  std::vector<StiffnessWithContacts::Contact> blocks; ///< inverses
  ContinuumVector step, left;
};

void Smoother::set_contacts(const std::vector<StiffnessWithContacts::Contact> &contacts) {
  blocks = contacts;
  for (StiffnessWithContacts::Contact &block : blocks) {
    for (unsigned int d = 0; d < 3; ++d)
      block.tangent(d, d) += block.is_free[d] ? 1. / inverse.local_element(block.dofs[d]) : 1.;
    block.tangent = Eigen::Matrix3d(block.tangent.inverse());
  }
}

void Smoother::scale(ContinuumVector &vector) const {
  std::vector<Eigen::Vector3d> at_contacts;
  at_contacts.reserve(blocks.size());
  for (const auto &block : blocks) {
    Eigen::Vector3d value;
    for (unsigned int d = 0; d < 3; ++d)
      value[d] = block.is_free[d] ? vector.local_element(block.dofs[d]) : 0.;
    at_contacts.push_back(block.tangent * value);
  }
  vector.scale(inverse);
  for (std::size_t i = 0; i < blocks.size(); ++i)
    for (unsigned int d = 0; d < 3; ++d)
      if (blocks[i].is_free[d])
        vector.local_element(blocks[i].dofs[d]) = at_contacts[i][d];
}

void Smoother::scale_contacts(ContinuumVector &vector, const bool transposed) const {
  for (const auto &block : blocks) {
    Eigen::Vector3d own, value;
    for (unsigned int d = 0; d < 3; ++d) {
      own[d] = block.is_free[d] ? 1. / inverse.local_element(block.dofs[d]) : 0.;
      value[d] = block.is_free[d] ? vector.local_element(block.dofs[d]) : 0.;
    }
    const Eigen::Vector3d scaled = transposed
                                       ? Eigen::Vector3d(own.asDiagonal() * (block.tangent * value))
                                       : Eigen::Vector3d(block.tangent * (own.asDiagonal() * value));
    for (unsigned int d = 0; d < 3; ++d)
      if (block.is_free[d])
        vector.local_element(block.dofs[d]) = scaled[d];
  }
}

void Smoother::smooth(const StiffnessWithContacts &A, ContinuumVector &x, const ContinuumVector &b,
                      const bool from_zero) {
  const double smallest = largest / range, theta = 0.5 * (largest + smallest),
               delta = 0.5 * (largest - smallest);
  double rho = delta / theta;
  if (from_zero)
    step = b;
  else {
    A.vmult(left, x);
    step = b;
    step -= left;
  }
  scale(step);
  step *= 1. / theta;
  x += step;
  for (unsigned int k = 1; k < degree; ++k) {
    A.vmult(left, x);
    left.sadd(-1., 1., b);
    scale(left);
    const double next = 1. / (2. * theta / delta - rho);
    step.sadd(next * rho, 2. * next / delta, left);
    x += step;
    rho = next;
  }
}

/// One cycle of multigrid: smoothed on the body's own elements, then those of degree one.
class Cycle {
public:
  Cycle(const ContinuumBody<3> &body, const ElasticOperator &stiffness);

  /// @return whether the coarse multigrid was set up anew: it is kept while few contacts change
  bool set_contacts(const std::vector<StiffnessWithContacts::Contact> &contacts);
  void set_up_next() { is_set_up = false; }
  void vmult(ContinuumVector &x, const ContinuumVector &b) const;

private:
  using Contact = StiffnessWithContacts::Contact;

  /// What contacts add to the coarse stiffness, on the body's dofs.
  std::vector<Eigen::Matrix3d> coarse_tangents(const std::vector<Contact> &contacts) const;
  /// Whether they differ from those of the last set-up, for all processes.
  bool differ(const std::vector<Eigen::Matrix3d> &tangents,
              const std::vector<Contact> &contacts) const;

  const ContinuumBody<3> &body;
  const ElasticOperator &stiffness;
  const LinearElements linear;
  const std::unique_ptr<CoarseMultigrid> multigrid;
  std::unique_ptr<StiffnessWithContacts> definite;
  mutable std::unique_ptr<Smoother> smoother;
  bool is_set_up = false;
  std::vector<Eigen::Matrix3d> last_tangents; ///< that the coarse multigrid was set up with
  mutable ContinuumVector left, correction, coarse, coarse_left;
};

/// Largest eigenvalue of D^-1 K, from what conjugate gradients learn of it. Contacts' tangents, on
/// both sides, do not make it larger.
double largest_eigenvalue(const ElasticOperator &stiffness, const ContinuumVector &inverse) {
  ContinuumVector right(inverse), x(inverse);
  for (unsigned int i = 0; i < right.locally_owned_size(); ++i)
    right.local_element(i) =
        inverse.local_element(i) == 0. ? 0. : (i * 7919U % 1009U) / 504. - 1.;
  x = 0.;
  DiagonalMatrix<ContinuumVector> jacobi;
  jacobi.reinit(inverse);
  IterationNumberControl control(14, 1e-10);
  SolverCG<ContinuumVector> solver(control);
  double largest = 1.;
  solver.connect_eigenvalues_slot([&](const std::vector<double> &eigenvalues) {
    for (const double value : eigenvalues)
      largest = std::max(largest, value);
  });
  solver.solve(stiffness, x, right, jacobi);
  return largest;
}

Cycle::Cycle(const ContinuumBody<3> &body, const ElasticOperator &stiffness)
    : body(body), stiffness(stiffness), linear(body),
      multigrid(make_coarse_multigrid(linear, body)) {
  ContinuumVector inverse(stiffness.diagonal());
  inverse.zero_out_ghost_values();
  for (unsigned int i = 0; i < inverse.locally_owned_size(); ++i) {
    const double entry = inverse.local_element(i);
    inverse.local_element(i) = entry > 0. ? 1. / entry : 0.;
  }
  smoother =
      std::make_unique<Smoother>(inverse, margin * largest_eigenvalue(stiffness, inverse));
  body.reinit(left);
  body.reinit(correction);
  linear.reinit(coarse);
  linear.reinit(coarse_left);
}

std::vector<Eigen::Matrix3d>
Cycle::coarse_tangents(const std::vector<Contact> &contacts) const {
  std::vector<Eigen::Matrix3d> result;
  for (const Contact &contact : contacts) {
    Eigen::Matrix3d most = Eigen::Matrix3d::Identity();
    for (unsigned int d = 0; d < 3; ++d)
      if (contact.is_free[d])
        most(d, d) = most_of_contact * stiffness.diagonal().local_element(contact.dofs[d]);
    // in series, so that it stays symmetric
    const Eigen::Matrix3d tangent = most * (contact.tangent + most).inverse() * contact.tangent;
    result.push_back(0.5 * (tangent + tangent.transpose()));
  }
  return result;
}

bool Cycle::differ(const std::vector<Eigen::Matrix3d> &tangents,
                   const std::vector<Contact> &contacts) const {
  unsigned int n_changed = 0;
  for (std::size_t i = 0; i < tangents.size(); ++i) {
    double own = 0.;
    for (unsigned int d = 0; d < 3; ++d)
      if (contacts[i].is_free[d])
        own = std::max(own, stiffness.diagonal().local_element(contacts[i].dofs[d]));
    n_changed += (tangents[i] - last_tangents[i]).norm() > small_change * own;
  }
  const double n = Utilities::MPI::sum(double(tangents.size()), body.communicator);
  return Utilities::MPI::sum(double(n_changed), body.communicator) > few_changes * n;
}

bool Cycle::set_contacts(const std::vector<Contact> &contacts) {
  definite = std::make_unique<StiffnessWithContacts>(stiffness, contacts);
  smoother->set_contacts(contacts);
  const std::vector<Eigen::Matrix3d> tangents = coarse_tangents(contacts);
  if (is_set_up && !differ(tangents, contacts))
    return false;
  std::vector<CoarseMultigrid::Entry> entries;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    std::array<std::vector<std::pair<types::global_dof_index, double>>, 3> rows;
    for (unsigned int d = 0; d < 3; ++d)
      if (contacts[i].is_free[d])
        rows[d] = linear.row(contacts[i].dofs[d]);
    for (unsigned int a = 0; a < 3; ++a)
      for (unsigned int b = 0; b < 3; ++b) {
        const double value = tangents[i](a, b);
        if (value == 0.)
          continue;
        for (const auto &[row, by_row] : rows[a])
          for (const auto &[column, by_column] : rows[b])
            entries.push_back({row, column, by_row * value * by_column});
      }
  }
  Clock clock{"coarse set-up"};
  multigrid->set_up(entries);
  last_tangents = tangents;
  is_set_up = true;
  return true;
}

void Cycle::vmult(ContinuumVector &x, const ContinuumVector &b) const {
  x = 0.;
  smoother->smooth(*definite, x, b, true);
  definite->vmult(left, x);
  left.sadd(-1., 1., b);
  smoother->scale_contacts(left, true);
  linear.restrict_to(coarse_left, left);
  multigrid->cycle(coarse, coarse_left);
  correction = 0.;
  linear.prolongate_add(correction, coarse);
  smoother->scale_contacts(correction, false);
  x += correction;
  smoother->smooth(*definite, x, b, false);
}


std::unique_ptr<ContinuumSystem> make_distributed_or_condensed(const ContinuumBody<3> &body) { return body.is_parallel ? make_distributed_system(body, false) : make_condensed_system(body); }
class IterativeSystem final : public ContinuumSystem {
public:
  explicit IterativeSystem(const ContinuumBody<3> &body);

  void multiply(const ContinuumVector &x, ContinuumVector &y) const override {
    stiffness.vmult(y, x);
  }
  double diagonal(const types::global_dof_index dof) const override {
    const double own = stiffness.diagonal()(dof);
    return own > 0. ? own : mean_diagonal;
  }
  bool solve(const std::vector<Block> &blocks, const bool symmetric, const ContinuumVector &b,
             ContinuumVector &x) override;
  void begin_increment() override { cycle.set_up_next(); }
  std::string description() const override;

private:
  using Contact = StiffnessWithContacts::Contact;

  bool iterate(const std::vector<Block> &blocks, const bool symmetric, const ContinuumVector &right,
               ContinuumVector &x);
  bool solve_directly(const std::vector<Block> &blocks, const bool symmetric,
                      const ContinuumVector &b, ContinuumVector &x);
  Contact contact(const Block &block, const std::vector<double> &values) const;

  const ContinuumBody<3> &body;
  const ElasticOperator stiffness;
  Cycle cycle;
  double mean_diagonal = 1.;
  std::unique_ptr<ContinuumSystem> direct; ///< where iterations fail
  double after_set_up = 0.; ///< iterations for a digit of the first system with the present cycle
};

IterativeSystem::IterativeSystem(const ContinuumBody<3> &body)
    : body(body), stiffness(body), cycle(body, stiffness) {
  if (getenv("FB_TIME")) fprintf(stderr, "system of %d made\n", int(body.dof_handler.n_dofs()));
  const double sum = stiffness.diagonal().mean_value();
  mean_diagonal = sum > 0. ? sum : 1.;
}

StiffnessWithContacts::Contact IterativeSystem::contact(const Block &block,
                                                        const std::vector<double> &values) const {
  Contact result;
  for (unsigned int a = 0; a < 3; ++a) {
    result.is_free[a] = !body.constraints.is_constrained(block.dofs[a]);
    result.dofs[a] =
        stiffness.diagonal().get_partitioner()->global_to_local(block.dofs[a]);
  }
  for (unsigned int a = 0; a < 3; ++a)
    for (unsigned int c = 0; c < 3; ++c)
      result.tangent(a, c) = result.is_free[a] && result.is_free[c] ? values[3 * a + c] : 0.;
  return result;
}

bool IterativeSystem::iterate(const std::vector<Block> &blocks, const bool symmetric,
                              const ContinuumVector &right, ContinuumVector &x) {
  std::vector<Contact> contacts, definite;
  for (const Block &block : blocks) {
    contacts.push_back(contact(block, block.values));
    definite.push_back(contact(block, block.definite));
  }
  const StiffnessWithContacts matrix(stiffness, contacts);
  const bool is_new = cycle.set_contacts(definite);
  Clock clock{"krylov"};
  const double size = right.l2_norm();
  SolverControl control(most_iterations, tolerance * size);
  try {
    if (symmetric)
      SolverCG<ContinuumVector>(control).solve(matrix, x, right, cycle);
    else
      SolverGMRES<ContinuumVector>(control, SolverGMRES<ContinuumVector>::AdditionalData(60, true))
          .solve(matrix, x, right, cycle);
  } catch (const SolverControl::NoConvergence &failure) {
    n_iterations += failure.last_step;
    return failure.last_residual <= std::max(tolerance, least_accuracy) * size;
  }
  n_iterations += control.last_step();
  if (getenv("FB_TIME")) fprintf(stderr, "%s %d its tol %g new %d\n", symmetric ? "cg" : "gmres", int(control.last_step()), tolerance, int(is_new));
  // Per digit, since tolerances differ.
  const double per_digit = control.last_step() / -std::log10(std::min(0.1, tolerance));
  if (is_new)
    after_set_up = per_digit;
  else if (per_digit > many_iterations * after_set_up)
    cycle.set_up_next();
  return true;
}

bool IterativeSystem::solve_directly(const std::vector<Block> &blocks, const bool symmetric,
                                     const ContinuumVector &b, ContinuumVector &x) {
  if (body.dof_handler.n_dofs() > most_by_fallback)
    return false;
  if (!direct)
    direct = body.is_parallel ? make_distributed_system(body, true) : make_condensed_system(body);
  const unsigned int before = direct->n_factorizations;
  const bool solved = direct->solve(blocks, symmetric, b, x);
  n_factorizations += direct->n_factorizations - before;
  return solved;
}

bool IterativeSystem::solve(const std::vector<Block> &blocks, const bool symmetric,
                            const ContinuumVector &b, ContinuumVector &x) {
  ++n_systems;
  if (getenv("FB_CHECK")) { // the operator against the assembled matrix
    const auto assembled = make_distributed_or_condensed(body);
    ContinuumVector r(b), k1(b), k2(b);
    for (unsigned int i = 0; i < r.locally_owned_size(); ++i) r.local_element(i) = std::sin(1. + i);
    body.constraints.set_zero(r);
    r.update_ghost_values(); r.zero_out_ghost_values();
    assembled->multiply(r, k1); stiffness.vmult(k2, r);
    body.constraints.set_zero(k1); body.constraints.set_zero(k2);
    const double n1 = k1.l2_norm(); k2 -= k1;
    double dd = 0., md = 0.; for (const auto dof : body.owned) if (!body.constraints.is_constrained(dof)) { dd = std::max(dd, std::abs(assembled->diagonal(dof) - diagonal(dof))); md = std::max(md, assembled->diagonal(dof)); }
    fprintf(stderr, "check: |K1 x| %g difference %g, diagonal %g of %g\n", n1, k2.l2_norm(), dd, md);
    // symmetry of the cycle, P
  }
  if (n_failures >= most_failures)
    return solve_directly(blocks, symmetric, b, x);
  ContinuumVector right(b);
  right.zero_out_ghost_values();
  body.constraints.set_zero(right);
  x = 0.;
  if (right.l2_norm() == 0. || iterate(blocks, symmetric, right, x))
    return true;
  ++n_failures;
  return solve_directly(blocks, symmetric, b, x);
}

std::string IterativeSystem::description() const {
  return "multigrid without a matrix, " + std::to_string(n_iterations) + " iterations for " +
         std::to_string(n_systems) + " systems" +
         (n_failures > 0 ? ", " + std::to_string(n_failures) +
                             " of which did not converge and went to a factorization"
                       : std::string());
}

} // namespace

std::unique_ptr<ContinuumSystem> make_iterative_system(const ContinuumBody<3> &body) {
  return std::make_unique<IterativeSystem>(body);
}

} // namespace frictionbeam
