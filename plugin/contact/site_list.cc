// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/contact/site_list.h>

#include <algorithm>
#include <map>

namespace frictionbeam::contact {

Strains Site::strain_by_unknowns(const Vector &values, const std::vector<int> &places) const {
  Strains result = Strains::Zero();
  for (unsigned int j = 0; j < places.size(); ++j)
    result += values[places[j]] * B.col(j);
  return result;
}

void Site::add_to(Vector &forces, const Strains &stress, const double factor,
                  const std::vector<int> &places) const {
  for (unsigned int j = 0; j < places.size(); ++j)
    forces[places[j]] += factor * weight * B.col(j).dot(stress);
}

void SiteList::prepare(Response &response) const {
  const unsigned int n = size();
  response.stress.resize(n);
  response.tangent.resize(n);
  response.status.resize(n);
  response.failed = false;
  response.state.internal.resize(n_internal + 1);
  response.state.strain.resize(n);
  response.state.touch.resize(n);
  response.state.dissipated.resize(n);
  response.state.wear.resize(n);
  response.state.impulse.resize(n);
}

void SiteList::evaluate_law(const unsigned int i, const State &committed,
                            const Increment &increment, const LawTangent tangent,
                            Response &response) const {
  const Site &site = *sites[i];
  const Strains &strain = response.state.strain[i];
  Strains rate = Strains::Zero();
  if (increment.length > 0.)
    rate = (strain - committed.strain[i]) / increment.length;
  const double temperature =
      increment.temperatures.empty() ? site.installation_temperature : increment.temperatures[i];
  LawOutput output{response.stress[i].data(), response.tangent[i].data(),
                   response.state.internal.data() + site.state_offset, 0., ContactStatus::none};
  if (site.law.integrate(
          strain.data(), rate.data(), site.length, {increment.time, increment.length, temperature},
          committed.internal.data() + site.state_offset, tangent, output) != LawStatus::ok)
    response.failed = true;
  response.status[i] = output.contact;
  response.state.touch[i] = output.contact == ContactStatus::open ? strain : committed.touch[i];
  response.state.dissipated[i] = committed.dissipated[i] + site.weight * output.dissipation;
}

void SiteList::add_forces(const Response &response, Vector &forces) const {
  for (unsigned int i = 0; i < size(); ++i)
    sites[i]->add_to(forces, response.stress[i]);
}

void SiteList::add_tangent(const Response &response, SparseMatrix &matrix) const {
  for (unsigned int i = 0; i < size(); ++i) {
    const Site &site = *sites[i];
    const auto local = (site.weight * site.B.transpose() * response.tangent[i] * site.B).eval();
    for (unsigned int j = 0; j < site.unknowns.size(); ++j)
      for (unsigned int k = 0; k < site.unknowns.size(); ++k)
        contact::add_to(matrix, site.unknowns[j], site.unknowns[k], local(j, k));
  }
}

State SiteList::initial_state(const std::vector<Strains> &strain) const {
  State state;
  state.internal.assign(n_internal + 1, 0.);
  state.strain = state.touch = strain;
  state.dissipated.assign(size(), 0.);
  state.wear = state.impulse = state.dissipated;
  if (std::all_of(strain.begin(), strain.end(), [](const Strains &e) { return e.isZero(0.); }))
    return state;
  // Touch down there: evaluated as if lifted off by one length, whatever is irreversible follows.
  for (unsigned int i = 0; i < size(); ++i) {
    const Site &site = *sites[i];
    const BoundLaw::Answer answer =
        site.law.answer_at_rest({1., strain[i][1], strain[i][2], strain[i][3]}, site.length,
                                LawTangent::none, site.installation_temperature);
    std::copy(answer.state.begin(), answer.state.end() - 1,
              state.internal.begin() + site.state_offset);
  }
  return state;
}

double SiteList::largest_force(const Response &response) const {
  double largest = 0.;
  for (unsigned int i = 0; i < size(); ++i)
    largest = std::max(largest, sites[i]->largest_force(response.stress[i]));
  return largest;
}

std::vector<std::array<unsigned int, 2>> rigid_pairs(const SiteList &sites) {
  constexpr double same = 1e-12;
  std::vector<std::array<unsigned int, 2>> pairs;
  std::map<std::vector<int>, std::vector<unsigned int>> rigid; // by their unknowns
  for (unsigned int i = 0; i < sites.size(); ++i) {
    const Site &site = sites[i];
    if (!site.law.is_rigid_along_normal())
      continue;
    const Eigen::RowVectorXd normal = site.length * site.B.row(0);
    auto &others = rigid[site.unknowns];
    for (const unsigned int k : others) {
      const Eigen::RowVectorXd other = sites[k].length * sites[k].B.row(0);
      if ((normal + other).norm() <= same * normal.norm())
        pairs.push_back({k, i});
    }
    others.push_back(i);
  }
  return pairs;
}

} // namespace frictionbeam::contact
