// SPDX-License-Identifier: LGPL-2.1-or-later
#include "free_motion.h"

#include "tangent_factors.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace frictionbeam::contact {

namespace {

constexpr double shift = 1e-12; ///< of the diagonal: what is softer is not strained
constexpr double soft = 1e-10;  ///< of the diagonal's energy, that such a motion may store
constexpr double excused = 1e-4;
constexpr unsigned int most_iterations = 3000, checked_every = 100;
/// Of few contacts more, times their number: forces that hold may be large beside the loads, which
/// takes long to come to.
constexpr unsigned int most_of_balanced = 100000;

/// Forces [N] of one contact on its strains times their length.
using Force = Eigen::Vector4d;

class FreeMotion {
public:
  FreeMotion(const SiteList &contacts, const std::vector<std::vector<int>> &unknowns,
             const SparseMatrix &S, const Vector &diagonal, const Vector &loads)
      : contacts(contacts), unknowns(unknowns), S(S), diagonal(diagonal), loads(loads) {}

  FreeMotionProof find();
  std::optional<std::vector<Strains>> find_balanced();

private:
  /// Allowed forces that leave ever less of the loads, until what they leave is enough.
  /// @return the last ones, or nothing if they never do
  template <typename Enough>
  std::optional<std::vector<Force>> approach(const unsigned int most, const Enough &is_enough);
  /// Whether contacts with friction can be pressed together by a motion that strains nothing: only
  /// then can their normal forces be anything.
  bool normals_are_free() const;
  bool factorize();
  /// A times forces.
  Vector without_strain(const Vector &forces) const {
    return factors.solve(Vector(shift * forces));
  }
  Force motion_of(const unsigned int i, const Vector &w) const {
    return contacts[i].length * contacts[i].strain_by_unknowns(w, unknowns[i]);
  }
  Vector left_by(const std::vector<Force> &forces) const;
  Force allowed(const unsigned int i, const Force &force) const;
  double friction(const unsigned int i) const {
    return contacts[i].law.closed_form().static_friction;
  }
  double largest_of_contacts() const;
  bool proves(const Vector &w) const;

  const SiteList &contacts;
  const std::vector<std::vector<int>> &unknowns;
  const SparseMatrix &S;
  const Vector &diagonal, &loads;
  TangentFactors factors;
};

bool FreeMotion::factorize() {
  SparseMatrix shifted = S;
  for (int i = 0; i < shifted.rows(); ++i)
    shifted.coeffRef(i, i) += shift * diagonal[i];
  factors.analyze(shifted, {});
  return factors.factorize({});
}

Vector FreeMotion::left_by(const std::vector<Force> &forces) const {
  Vector left = loads;
  for (unsigned int i = 0; i < contacts.size(); ++i) {
    const Strains stress = forces[i] * (contacts[i].length / contacts[i].weight);
    contacts[i].add_to(left, stress, -1., unknowns[i]);
  }
  return left;
}

Force FreeMotion::allowed(const unsigned int i, const Force &force) const {
  if (!contacts[i].law.has_closed_form())
    return force;
  // Compression is negative.
  Force result = force;
  const double mu = friction(i), T = force.segment<2>(1).norm(), P = -force[0];
  if (T > mu * P) {
    const double part = std::max(0., (P + mu * T) / (1. + mu * mu)); // on the cone, or its tip
    result[0] = -part;
    result.segment<2>(1) *= T > 0. ? mu * part / T : 0.;
  }
  if (!(contacts[i].law.closed_form().torsional_rigidity > 0.))
    result[3] = 0.;
  return result;
}

double FreeMotion::largest_of_contacts() const {
  // The largest eigenvalue of H A H^T, by its power.
  std::vector<Force> forces(contacts.size(), Force(1., 0.7, -0.4, 0.2));
  double largest = 0.;
  const auto norm = [&]() {
    double sum = 0.;
    for (const Force &force : forces)
      sum += force.squaredNorm();
    return std::sqrt(sum);
  };
  for (int k = 0; k < 30; ++k) {
    const double size = norm();
    if (!(size > 0.))
      break;
    for (Force &force : forces)
      force /= size;
    const Vector w = without_strain(loads - left_by(forces));
    for (unsigned int i = 0; i < contacts.size(); ++i)
      forces[i] = motion_of(i, w);
    largest = norm();
  }
  return largest;
}

bool FreeMotion::proves(const Vector &w) const {
  const double work = loads.dot(w);
  if (!(work > 0.) || w.dot(S * w) > soft * w.dot(diagonal.cwiseProduct(w)))
    return false;
  double largest = 0., violation = 0.;
  for (unsigned int i = 0; i < contacts.size(); ++i) {
    const Force d = motion_of(i, w);
    const bool is_cone = contacts[i].law.has_closed_form();
    largest = std::max(largest, d.head<3>().norm());
    violation = std::max(violation, is_cone ? friction(i) * d.segment<2>(1).norm() - d[0]
                                            : d.head<3>().norm());
  }
  // What is next to nothing beside the motion itself is rounding of it.
  const double size = w.lpNorm<Eigen::Infinity>();
  return violation <= excused * std::max(largest, 1e-6 * size);
}

bool FreeMotion::normals_are_free() const {
  constexpr double held = 1e-9; // of what is free altogether
  std::vector<Force> forces(contacts.size(), Force::Zero());
  std::minstd_rand random; // always the same sequence
  for (unsigned int i = 0; i < contacts.size(); ++i)
    if (!contacts[i].law.has_closed_form() || friction(i) > 0.)
      forces[i][0] = random() % 2 == 0 ? 1. : -0.7;
  const Vector pressed = loads - left_by(forces);
  const double altogether = pressed.cwiseAbs2().cwiseQuotient(diagonal).sum();
  return pressed.dot(without_strain(pressed)) > held * altogether;
}

template <typename Enough>
std::optional<std::vector<Force>> FreeMotion::approach(const unsigned int most,
                                                       const Enough &is_enough) {
  const double largest = largest_of_contacts();
  std::vector<Force> forces(contacts.size(), Force::Zero()), ahead = forces;
  double momentum = 1.;
  for (unsigned int k = 1; k <= most; ++k) {
    const Vector w = without_strain(left_by(ahead));
    const double next = (1. + std::sqrt(1. + 4. * momentum * momentum)) / 2.;
    double turned = 0.;
    std::vector<Force> moved(contacts.size());
    for (unsigned int i = 0; i < contacts.size() && largest > 0.; ++i) {
      moved[i] = allowed(i, ahead[i] + motion_of(i, w) / largest);
      turned += (ahead[i] - moved[i]).dot(moved[i] - forces[i]);
    }
    if (largest > 0.) {
      const bool restarts = turned > 0.; // B. O'Donoghue, E. Candes: momentum that goes uphill
      for (unsigned int i = 0; i < contacts.size(); ++i) {
        ahead[i] = moved[i] + (restarts ? 0. : (momentum - 1.) / next) * (moved[i] - forces[i]);
        forces[i] = moved[i];
      }
      momentum = restarts ? 1. : next;
    }
    if (k % checked_every == 0 || largest == 0.) {
      if (is_enough(without_strain(left_by(forces))))
        return forces;
      if (largest == 0.)
        return {};
    }
  }
  return {};
}

FreeMotionProof FreeMotion::find() {
  FreeMotionProof proof;
  if (loads.size() == 0 || !factorize())
    return proof;
  proof.is_any_force = normals_are_free();
  if (!proof.is_any_force)
    return proof;
  if (const auto forces =
          approach(most_iterations, [&](const Vector &left) { return proves(left); }))
    proof.motion = without_strain(left_by(*forces));
  return proof;
}

std::optional<std::vector<Strains>> FreeMotion::find_balanced() {
  constexpr double nothing_left = 1e-6; // of what the loads do without contacts
  if (loads.size() == 0 || !factorize() || !normals_are_free())
    return {};
  const double without = without_strain(loads).lpNorm<Eigen::Infinity>();
  const unsigned int most =
      std::max(most_iterations, most_of_balanced / std::max(1u, contacts.size()));
  const auto forces = approach(most, [&](const Vector &left) {
    return left.lpNorm<Eigen::Infinity>() <= nothing_left * without;
  });
  if (!forces)
    return {};
  std::vector<Strains> stress;
  for (unsigned int i = 0; i < contacts.size(); ++i)
    stress.push_back((*forces)[i] * (contacts[i].length / contacts[i].weight));
  return stress;
}

} // namespace

FreeMotionProof find_free_motion(const SiteList &contacts,
                                 const std::vector<std::vector<int>> &unknowns,
                                 const SparseMatrix &S, const Vector &diagonal,
                                 const Vector &loads) {
  return FreeMotion(contacts, unknowns, S, diagonal, loads).find();
}

std::optional<std::vector<Strains>>
find_balanced_forces(const SiteList &contacts, const std::vector<std::vector<int>> &unknowns,
                     const SparseMatrix &S, const Vector &diagonal, const Vector &loads) {
  return FreeMotion(contacts, unknowns, S, diagonal, loads).find_balanced();
}

} // namespace frictionbeam::contact
