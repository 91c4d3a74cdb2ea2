// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/contact/site.h>

#include <array>

namespace frictionbeam::contact {

/// Committed or trial state of all sites: internal variables, strains, what was dissipated.
struct State {
  std::vector<double> internal; ///< of all sites in turn, and a spare one behind them
  std::vector<Strains> strain;
  std::vector<Strains> touch;     ///< strain at which the contact began
  std::vector<double> dissipated; ///< [J]
  std::vector<double> wear;       ///< integral of normal force times sliding velocity [J]
  std::vector<double> impulse;    ///< of the normal force, impacts included [N s]
};

/// The increment at whose end sites are evaluated.
struct Increment {
  double time = 0., length = 0.;         ///< its end, and how long it is: 0 in statics [s]
  std::vector<double> temperatures = {}; ///< of sites, at its end; empty: of installation [degC]
};

/// What one evaluation of all sites gives.
struct Response {
  std::vector<Strains> stress;
  std::vector<Block> tangent;
  std::vector<ContactStatus> status;
  State state; ///< at the end of the increment, if it is committed
  bool failed = false;
};

/// Sites that stand elsewhere and stay there as long as this lives.
class SiteList {
public:
  SiteList() = default;
  template <typename Sites>
  explicit SiteList(const Sites &sites) {
    refer_to(sites);
  }

  unsigned int size() const { return sites.size(); }
  const Site &operator[](const unsigned int i) const { return *sites[i]; }

  /// Size a response for all sites.
  void prepare(Response &response) const;
  /// Evaluate the law of site @p i at response.state.strain[i].
  void evaluate_law(const unsigned int i, const State &committed, const Increment &increment,
                    const LawTangent tangent, Response &response) const;
  /// forces += weight B^T stress, on the unknowns.
  void add_forces(const Response &response, Vector &forces) const;
  /// matrix += weight B^T D B; the pattern has the entries.
  void add_tangent(const Response &response, SparseMatrix &matrix) const;
  /// The state at the start: no shear force at these strains.
  State initial_state(const std::vector<Strains> &strain) const;
  /// Largest force or moment of a response [N, N m].
  double largest_force(const Response &response) const;

protected:
  template <typename Sites>
  void refer_to(const Sites &list) {
    sites.clear();
    n_internal = 0;
    for (const Site &site : list) {
      sites.push_back(&site);
      n_internal += site.law.n_internal_variables();
    }
  }

private:
  std::vector<const Site *> sites;
  unsigned int n_internal = 0;
};

/**
 * The halves of a rigid stop: rigid sites at the same unknowns with opposite normals. Both may
 * press at once, with a force in common that nothing determines, and friction would count it on
 * both.
 */
std::vector<std::array<unsigned int, 2>> rigid_pairs(const SiteList &sites);

} // namespace frictionbeam::contact
