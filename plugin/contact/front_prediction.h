// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/contact/check.h>
#include <frictionbeam/contact/site_list.h>

#include <Eigen/Core>

namespace frictionbeam::contact {

/**
 * Which contacts of a line stick, slip or are open next, from what the last choice led to.
 *
 * An active set by itself moves the front between sticking and slipping contacts by one contact an
 * iteration, since the first that sticks holds what all behind it let go. Here friction beyond the
 * limit of a sticking contact, |T| - f P, is passed on to its neighbours, from each to the next, by
 * the stiffness that couples them, until others have carried it: all on the way slip. Where that
 * was too far, the contacts on the front's side slide against their friction, over twice the
 * distance that it was (u = k x (x - 2 d) behind a front that is d ahead of its place, with u = u'
 * = 0 there): the half of such a group next to the sticking ones stops; a group without slip beyond
 * it, as of a load that turns, stops as a whole.
 */
class FrontPrediction {
public:
  /// @param unknowns of each contact, places in S
  FrontPrediction(const SparseMatrix &S, const SiteList &contacts,
                  const std::vector<std::vector<int>> &unknowns);

  /**
   * @param points of all contacts in equilibrium on these branches; in: forces, gaps and slips;
   * out: friction as it is passed on
   * @param branch `open`, `stick` or `slip` of exact contacts, `none` of others
   * @param uncertain excess up to which a contact slips by itself: nothing is passed on [N]
   * @return number of contacts that change theirs
   */
  unsigned int advance(std::vector<Check::Point> &points, std::vector<ContactStatus> &branch,
                       const double uncertain = 0.);

  /**
   * Move each front that the last advance() has moved on, further on or back.
   * @param branch as advance() has left it
   * @param n_contacts that begin to slip, or stick after all if it is negative
   * @return number of contacts at fronts
   */
  unsigned int move(std::vector<ContactStatus> &branch, const int n_contacts);

  /// Friction coefficient from which on contact @p i alone has several states, all others held:
  /// K_tt/|K_tn| of its stiffness.
  double limit_of_uniqueness(const unsigned int i) const { return limits[i]; }

private:
  /// A contact to which another's friction is passed on by this.
  struct Neighbour {
    unsigned int contact;
    Eigen::Matrix2d passes;
  };
  /// Friction that comes to a contact [N].
  struct Wave {
    unsigned int contact;
    Eigen::Vector2d friction;
  };

  void open_and_close();
  void stop_wrong_slip();
  void stop_group(const std::vector<unsigned int> &group);
  void pass_excess_on(const double uncertain);
  void pass_on(const unsigned int first);
  double spread(const unsigned int from, const Eigen::Vector2d &friction);
  bool holds_too_much(const unsigned int i) const;
  Eigen::Vector2d excess(const unsigned int i) const;
  bool slides_wrongly(const unsigned int i) const;

  const SiteList &contacts;
  std::vector<std::vector<Neighbour>> neighbours;
  std::vector<Eigen::Matrix2d> flexibility; ///< of each contact, across, all others held [m/N]
  std::vector<double> limits;

  // of the present choice
  std::vector<Check::Point> *points = nullptr;
  std::vector<ContactStatus> before, next;
  std::vector<unsigned int> visited; ///< by which group or wave
  unsigned int n_visits = 0;
  std::vector<Wave> wave;
};

} // namespace frictionbeam::contact
