// SPDX-License-Identifier: LGPL-2.1-or-later
// The travelling front. Of contacts in a row, so many shall slip as it takes to carry what the
// first holds too much; where slip has gone too far, half of what slides backwards shall stop, all
// of it where the load turns. Chains that are pulled at several places, to and fro, under normal
// forces that vary, across: the number that slips is by adding up friction from the end, and a
// front of any length shall cost no more than eight factorizations.
#include "../check.h"

#include "../../plugin/contact/front_prediction.h"

#include <frictionbeam/contact/solver.h>
#include <frictionbeam/law_library.h>

#include <cmath>
#include <numeric>

using namespace frictionbeam;

namespace {

constexpr double friction = 0.3;
constexpr unsigned int most_factorizations = 8;

contact::SparseMatrix chain(const unsigned int n, const std::vector<double> &stiffness) {
  const unsigned int d = stiffness.size();
  std::vector<Eigen::Triplet<double>> entries;
  for (unsigned int i = 0; i + 1 < n; ++i)
    for (unsigned int c = 0; c < d; ++c) {
      const unsigned int a = d * i + c, b = a + d;
      entries.emplace_back(a, a, stiffness[c]);
      entries.emplace_back(b, b, stiffness[c]);
      entries.emplace_back(a, b, -stiffness[c]);
      entries.emplace_back(b, a, -stiffness[c]);
    }
  contact::SparseMatrix K(d * n, d * n);
  K.setFromTriplets(entries.begin(), entries.end());
  return K;
}

/// Contacts that hold 5 N each, in a row: the first holds 57, so that ten more slip and one is left
/// with 2; the front is at its place then.
void predict() {
  constexpr unsigned int n = 100;
  std::vector<contact::Site> sites(n);
  std::vector<std::vector<int>> unknowns;
  for (unsigned int i = 0; i < n; ++i) {
    sites[i].unknowns = {static_cast<int>(i)};
    sites[i].B.setZero(contact::n_strains, 1);
    sites[i].B(1, 0) = 1.;
    unknowns.push_back(sites[i].unknowns);
  }
  const contact::SiteList list(sites);
  contact::FrontPrediction front(chain(n, {1e6}), list, unknowns);
  const contact::Check::Point holds{10., {0., 0.}, 0., {0., 0.}, 0.5, 1e6, 1e6, 1e-15};
  std::vector<contact::Check::Point> points(n, holds);
  std::vector<ContactStatus> branch(n, ContactStatus::stick);
  points[0].T[0] = 57.;
  CHECK(front.advance(points, branch) == 11);
  CHECK(std::count(branch.begin(), branch.begin() + 11, ContactStatus::slip) == 11);
  CHECK(branch[11] == ContactStatus::stick);
  CHECK_NEAR(points[11].T[0], 2., 1e-9);

  // Of ten contacts that slide backwards ahead of slip the five next to the front stop.
  points.assign(n, holds);
  branch.assign(n, ContactStatus::stick);
  for (unsigned int i = 0; i < 20; ++i) {
    branch[i] = ContactStatus::slip;
    points[i].T[0] = 5.;
    points[i].slip[0] = i < 10 ? 1e-3 : -1e-3;
  }
  CHECK(front.advance(points, branch) == 5);
  CHECK(branch[14] == ContactStatus::slip && branch[15] == ContactStatus::stick);

  // The load turns: all stop.
  for (unsigned int i = 0; i < n; ++i)
    points[i].slip[0] = branch[i] == ContactStatus::slip ? -1e-3 : 0.;
  CHECK(front.advance(points, branch) == 15);
  CHECK(std::count(branch.begin(), branch.end(), ContactStatus::slip) == 0);

  // All hold what they can, one of them too much by what a branch has yielded: it slips alone.
  points.assign(n, holds);
  for (contact::Check::Point &point : points)
    point.T[0] = 5.;
  points[7].T[0] += 1e-6;
  branch.assign(n, ContactStatus::stick);
  CHECK(front.advance(points, branch, 1e-5) == 1);
  CHECK(branch[7] == ContactStatus::slip);

  // Too much by rounding of where it is: it stays.
  points[7].rounding = 1e-11;
  branch.assign(n, ContactStatus::stick);
  CHECK(front.advance(points, branch) == 0);
}

/// Nodes on a floor, coupled by springs along, across and upwards, pressed on it.
class Chain {
public:
  Chain(const unsigned int n, const std::vector<double> &press, const LawLibrary &laws)
      : n(n), press(press), solver(contact::system_of(chain(n, {1e6, 1e6, 1e4})), contacts(laws)),
        memory(solver.initial_memory()) {
    solver.most_contacts_for_uniqueness = 0;
  }

  /// Forces along and across on some nodes. @return how many contacts slip in this increment
  unsigned int load(const std::vector<std::pair<unsigned int, Eigen::Vector2d>> &forces) {
    contact::Vector f = contact::Vector::Zero(3 * n);
    for (unsigned int i = 0; i < n; ++i)
      f[3 * i + 2] = -press[i];
    for (const auto &[node, force] : forces)
      f.segment<2>(3 * node) += force;
    const contact::Report report = solver.solve(f, memory, u, memory);
    CHECK(report.converged && report.check.natural_map <= 1e-8);
    CHECK(report.factorizations <= most_factorizations);
    unsigned int n_slip = 0;
    for (const contact::ContactState &state : report.contacts)
      n_slip += state.slip.norm() > 1e-12 ? 1 : 0;
    return n_slip;
  }

private:
  std::vector<contact::Contact> contacts(const LawLibrary &laws) const {
    const LawDescription &law = laws.find("coulomb");
    std::vector<double> parameters = default_parameters(law);
    parameters[parameter_index(law, "Friction coefficient")] = friction;
    std::vector<contact::Contact> list;
    for (unsigned int i = 0; i < n; ++i)
      list.push_back(
          contact::on_ground({3 * i, 3 * i + 1, 3 * i + 2}, {0., 0., -1.}, law, parameters));
    return list;
  }

  const unsigned int n;
  const std::vector<double> press;
  contact::Solver solver;
  contact::ContactMemory memory;
  contact::Vector u;
};

/// Contacts from the end that slip so that the next can hold the rest.
unsigned int n_to_carry(const double force, const std::vector<double> &press) {
  unsigned int k = 0;
  double held = 0.;
  while (held + friction * press[press.size() - 1 - k] < force)
    held += friction * press[press.size() - 1 - k++];
  return k;
}

} // namespace

int front_prediction(int, char **) {
  predict();

  LawLibrary laws;
  laws.load_builtin();
  constexpr unsigned int n = 400, middle = 150;
  const std::vector<double> even(n, 100.); // 30 N hold each
  using Force = Eigen::Vector2d;

  // Three fronts at once: 40 contacts at one end, 25 at the other, 2 * 10 + 1 around the middle.
  Chain several(n, even, laws);
  several.load({});
  const double right = 30. * 40 + 15., left = 30. * 25 + 15., within = 30. * 21 + 20.;
  for (const double share : {0.25, 0.5, 0.75})
    several.load({{n - 1, Force(share * right, 0.)}, {0, Force(-share * left, 0.)}});
  CHECK(several.load(
            {{n - 1, Force(right, 0.)}, {0, Force(-left, 0.)}, {middle, Force(within, 0.)}}) ==
        40 + 25 + 21);
  // Back by half: friction turns where twice its limit has been given up.
  CHECK(several.load({{n - 1, Force(right / 2., 0.)},
                      {0, Force(-left / 2., 0.)},
                      {middle, Force(within, 0.)}}) == 10 + 6);

  // Normal forces that vary from node to node.
  std::vector<double> uneven(n);
  for (unsigned int i = 0; i < n; ++i)
    uneven[i] = 100. + 80. * std::sin(i);
  Chain varied(n, uneven, laws);
  varied.load({});
  for (const double force : {1000., 2500., 4000.}) {
    CHECK(varied.load({{n - 1, Force(force, 0.)}}) == n_to_carry(force, uneven));
  }

  // Askew: springs as stiff across as along, so that it is the same along the force.
  Chain askew(n, even, laws);
  askew.load({});
  const Force direction(std::cos(0.7), std::sin(0.7));
  for (const double force : {900., 2000., 3100.})
    CHECK(askew.load({{n - 1, force * direction}}) == n_to_carry(force, even));
  return check::report();
}
