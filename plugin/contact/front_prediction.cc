// SPDX-License-Identifier: LGPL-2.1-or-later
#include "front_prediction.h"
#include <frictionbeam/disc_projection.h>

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace frictionbeam::contact {

namespace {

constexpr double at_the_limit = 1e-9; // of the friction that a contact can hold

double limit_of(const Check::Point &point) { return point.friction * std::max(0., point.P); }

/// Stiffness of the line between a contact and another, along the strains of both [N/m].
struct Coupling {
  Eigen::Matrix3d by_unknowns_in_common = Eigen::Matrix3d::Zero(),
                  by_others = by_unknowns_in_common;
};

/// Unit vectors round half a turn.
using Directions = std::array<Eigen::Vector2d, 60>;

Directions directions_across() {
  constexpr double half_turn = 3.14159265358979323846;
  Directions directions;
  for (unsigned int k = 0; k < directions.size(); ++k) {
    const double angle = k * half_turn / directions.size();
    directions[k] = {std::cos(angle), std::sin(angle)};
  }
  return directions;
}

/// Moore and Penrose's: K^-1, and K^T/|K|^2 of one direction alone.
Eigen::Matrix2d pseudo_inverse(const Eigen::Matrix2d &K) {
  const double size = K.squaredNorm();
  if (std::abs(K.determinant()) > 4. * std::numeric_limits<double>::epsilon() * size)
    return K.inverse();
  return size > 0. ? Eigen::Matrix2d(K.transpose() / size) : Eigen::Matrix2d(K);
}

/// Least K_tt/|K_tn| of all directions t across the normal n.
double unique_below(const Eigen::Matrix3d &K, const Directions &directions) {
  constexpr double rounding = 1e-6;
  double least = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector2d &t : directions) {
    const double along = t.dot(K.bottomRightCorner<2, 2>() * t),
                 coupled = std::abs(t.dot(K.bottomLeftCorner<2, 1>()));
    if (along > 0. && coupled > rounding * along)
      least = std::min(least, along / coupled);
  }
  return least;
}

} // namespace

FrontPrediction::FrontPrediction(const SparseMatrix &S, const SiteList &contacts,
                                 const std::vector<std::vector<int>> &unknowns)
    : contacts(contacts), neighbours(contacts.size()), flexibility(contacts.size()),
      limits(contacts.size()), visited(contacts.size(), 0) {
  struct Place {
    unsigned int contact;
    Eigen::Vector3d moves; ///< its strains times its length
  };
  const Directions directions = directions_across();
  std::vector<std::vector<Place>> places(S.rows());
  for (unsigned int i = 0; i < contacts.size(); ++i)
    for (unsigned int k = 0; k < unknowns[i].size(); ++k)
      places[unknowns[i][k]].push_back({i, contacts[i].length * contacts[i].B.col(k).head<3>()});
  for (unsigned int i = 0; i < contacts.size(); ++i) {
    std::map<unsigned int, Coupling> couplings;
    for (unsigned int k = 0; k < unknowns[i].size(); ++k) {
      const Eigen::Vector3d moves = contacts[i].length * contacts[i].B.col(k).head<3>();
      for (SparseMatrix::InnerIterator entry(S, unknowns[i][k]); entry; ++entry)
        for (const Place &place : places[entry.col()]) {
          Coupling &coupling = couplings[place.contact];
          (entry.col() == unknowns[i][k] ? coupling.by_unknowns_in_common : coupling.by_others) +=
              entry.value() * place.moves * moves.transpose();
        }
    }
    for (const auto &[j, coupling] : couplings)
      if (j != i) // what moves along with it is pushed its way, what is held against it
        neighbours[i].push_back(
            {j, (coupling.by_unknowns_in_common - coupling.by_others).bottomRightCorner<2, 2>()});
    const Eigen::Matrix3d K = couplings[i].by_unknowns_in_common + couplings[i].by_others;
    flexibility[i] = pseudo_inverse(K.bottomRightCorner<2, 2>());
    limits[i] = unique_below(K, directions);
  }
}

unsigned int FrontPrediction::advance(std::vector<Check::Point> &list,
                                      std::vector<ContactStatus> &branch, const double uncertain) {
  points = &list;
  before = next = branch;
  open_and_close();
  stop_wrong_slip();
  pass_excess_on(uncertain);
  unsigned int n_changes = 0;
  for (unsigned int i = 0; i < next.size(); ++i)
    n_changes += next[i] != branch[i] ? 1 : 0;
  branch = next;
  return n_changes;
}

unsigned int FrontPrediction::move(std::vector<ContactStatus> &branch, const int n_contacts) {
  const auto has_begun = [&](const unsigned int i) {
    return before[i] == ContactStatus::stick && branch[i] == ContactStatus::slip;
  };
  const auto sticks = [&](const unsigned int i) { return branch[i] == ContactStatus::stick; };
  const auto is_beside = [&](const unsigned int i, const auto &has) {
    return std::any_of(neighbours[i].begin(), neighbours[i].end(),
                       [&](const Neighbour &neighbour) { return has(neighbour.contact); });
  };
  std::vector<unsigned int> layer; // to change next
  const auto take = [&](const unsigned int i) {
    if (n_contacts >= 0 ? sticks(i) && is_beside(i, has_begun)
                        : has_begun(i) && is_beside(i, sticks))
      layer.push_back(i);
  };
  for (unsigned int i = 0; i < branch.size(); ++i)
    take(i);
  const unsigned int n_fronts = layer.size();
  for (int k = 0; k < std::abs(n_contacts); ++k) {
    std::vector<unsigned int> changed;
    changed.swap(layer);
    ++n_visits;
    for (const unsigned int i : changed)
      branch[i] = n_contacts > 0 ? ContactStatus::slip : ContactStatus::stick;
    for (const unsigned int i : changed)
      for (const Neighbour &neighbour : neighbours[i])
        if (visited[neighbour.contact] != n_visits) {
          visited[neighbour.contact] = n_visits;
          take(neighbour.contact);
        }
  }
  return n_fronts;
}

void FrontPrediction::open_and_close() {
  for (unsigned int i = 0; i < next.size(); ++i) {
    const Check::Point &point = (*points)[i];
    if (before[i] == ContactStatus::open) {
      if (point.gap < -point.rounding)
        next[i] = ContactStatus::stick;
    } else if (before[i] != ContactStatus::none && point.P < 0.)
      next[i] = ContactStatus::open;
  }
}

bool FrontPrediction::slides_wrongly(const unsigned int i) const {
  const Check::Point &point = (*points)[i];
  return before[i] == ContactStatus::slip && next[i] == ContactStatus::slip &&
         point.T[0] * point.slip[0] + point.T[1] * point.slip[1] <
             -point.rounding * length_of(point.T[0], point.T[1]);
}

void FrontPrediction::stop_wrong_slip() {
  ++n_visits;
  std::vector<unsigned int> group;
  for (unsigned int first = 0; first < next.size(); ++first) {
    if (visited[first] == n_visits || !slides_wrongly(first))
      continue;
    group.assign(1, first);
    visited[first] = n_visits;
    for (std::size_t k = 0; k < group.size(); ++k)
      for (const Neighbour &neighbour : neighbours[group[k]])
        if (visited[neighbour.contact] != n_visits && slides_wrongly(neighbour.contact)) {
          visited[neighbour.contact] = n_visits;
          group.push_back(neighbour.contact);
        }
    stop_group(group);
  }
}

void FrontPrediction::stop_group(const std::vector<unsigned int> &group) {
  const auto is_beside = [&](const unsigned int i, const ContactStatus status) {
    return std::any_of(neighbours[i].begin(), neighbours[i].end(), [&](const Neighbour &n) {
      return before[n.contact] == status && !slides_wrongly(n.contact);
    });
  };
  std::vector<unsigned int> nearest;
  bool slip_goes_on = false;
  for (const unsigned int i : group) {
    if (is_beside(i, ContactStatus::stick))
      nearest.push_back(i);
    slip_goes_on = slip_goes_on || is_beside(i, ContactStatus::slip);
  }
  if (nearest.empty() || !slip_goes_on) {
    for (const unsigned int i : group)
      next[i] = ContactStatus::stick;
    return;
  }
  const std::size_t half = (group.size() + 1) / 2;
  for (const unsigned int i : nearest)
    next[i] = ContactStatus::stick;
  for (std::size_t k = 0; k < nearest.size() && nearest.size() < half; ++k)
    for (const Neighbour &neighbour : neighbours[nearest[k]])
      if (slides_wrongly(neighbour.contact) && nearest.size() < half) {
        next[neighbour.contact] = ContactStatus::stick;
        nearest.push_back(neighbour.contact);
      }
}

Eigen::Vector2d FrontPrediction::excess(const unsigned int i) const {
  const Check::Point &point = (*points)[i];
  const double size = length_of(point.T[0], point.T[1]), limit = limit_of(point);
  if (!(size > (1. + at_the_limit) * limit + point.shear_scale * point.rounding))
    return {0., 0.};
  return contacts[i].share() * (1. - limit / size) * Eigen::Vector2d(point.T[0], point.T[1]);
}

bool FrontPrediction::holds_too_much(const unsigned int i) const {
  return before[i] == ContactStatus::stick && next[i] == ContactStatus::stick &&
         !excess(i).isZero(0.);
}

void FrontPrediction::pass_excess_on(const double uncertain) {
  // What slid too far pushes on those beside it.
  std::vector<unsigned int> pushed;
  std::vector<bool> is_pushed(next.size(), false);
  for (unsigned int i = 0; i < next.size(); ++i)
    if (before[i] == ContactStatus::slip && next[i] == ContactStatus::stick)
      pushed.push_back(i);
  for (std::size_t k = 0; k < pushed.size(); ++k)
    for (const Neighbour &neighbour : neighbours[pushed[k]])
      if (!is_pushed[neighbour.contact] && holds_too_much(neighbour.contact)) {
        is_pushed[neighbour.contact] = true;
        pushed.push_back(neighbour.contact);
      }
  std::vector<std::pair<double, unsigned int>> sources; // the largest first: others lie on its way
  for (unsigned int i = 0; i < next.size(); ++i)
    if (!is_pushed[i] && holds_too_much(i))
      sources.emplace_back(-excess(i).norm(), i);
  std::sort(sources.begin(), sources.end());
  for (const auto &[size, i] : sources)
    if (-size <= uncertain)
      next[i] = ContactStatus::slip;
    else if (next[i] == ContactStatus::stick)
      pass_on(i);
}

void FrontPrediction::pass_on(const unsigned int first) {
  ++n_visits;
  visited[first] = n_visits;
  next[first] = ContactStatus::slip;
  wave.clear();
  double returned = spread(first, excess(first)); // from an end of the line, to the other side
  for (std::size_t k = 0; k < wave.size(); ++k) {
    const unsigned int i = wave[k].contact;
    Eigen::Vector2d friction = wave[k].friction;
    friction *= 1. + returned / friction.norm();
    returned = 0.;
    if (before[i] == ContactStatus::stick) {
      Check::Point &point = (*points)[i];
      point.T[0] += friction[0] / contacts[i].share();
      point.T[1] += friction[1] / contacts[i].share();
      friction = excess(i);
      if (friction.isZero(0.))
        continue;
      next[i] = ContactStatus::slip;
    }
    returned = spread(i, friction);
  }
}

double FrontPrediction::spread(const unsigned int from, const Eigen::Vector2d &friction) {
  constexpr double most_amplified = 4.; // by what slides already
  const double size = friction.norm();
  // How far it moves among held neighbours, and what they and the rest of the line then hold.
  const Eigen::Vector2d motion = flexibility[from] * friction;
  double held = 0., carried = 0.;
  const auto carries = [&](const unsigned int i) {
    return visited[i] != n_visits &&
           (before[i] == ContactStatus::stick || before[i] == ContactStatus::open);
  };
  bool is_end = true;
  for (const Neighbour &neighbour : neighbours[from]) {
    const double part = (neighbour.passes * motion).norm();
    held += part;
    if (carries(neighbour.contact)) {
      carried += part;
      is_end = is_end && part == 0.;
    }
  }
  carried += std::max(0., size - held);
  if (is_end)
    return std::max(0., size - carried);
  for (const Neighbour &neighbour : neighbours[from])
    if (carries(neighbour.contact)) {
      visited[neighbour.contact] = n_visits;
      const Eigen::Vector2d part =
          std::min(most_amplified, size / carried) * neighbour.passes * motion;
      if (!part.isZero(0.))
        wave.push_back({neighbour.contact, part});
    }
  return 0.;
}

} // namespace frictionbeam::contact
