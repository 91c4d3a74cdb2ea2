// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/contact/solver.h>
#include <frictionbeam/contact/tolerances.h>

#include "host_sites.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

namespace frictionbeam::contact {

namespace {

/// Translations of a point: up to three, each another.
void check_translations(const std::vector<unsigned int> &dofs) {
  const std::set<unsigned int> different(dofs.begin(), dofs.end());
  if (dofs.size() > 3 || different.size() < dofs.size()) {
    std::string list;
    for (const unsigned int dof : dofs)
      list += (list.empty() ? "" : ", ") + std::to_string(dof);
    throw std::invalid_argument(
        "A contact of a point with the dofs {" + list +
        "}\n  allowed: its translations along x, y and z, each another dof\n  try:     "
        "translations_at_vertex(), or the Contact itself with a row for each dof");
  }
}

System checked(System system) {
  if (!system.condense)
    throw std::invalid_argument(
        "A system of " + std::to_string(system.n_unknowns()) +
        " unknowns without a way to condense it\n  allowed: a function in `condense`\n  try:     "
        "complete(), where there is a matrix, or condense_by_inverse()");
  return system;
}

Contact contact_of(const std::vector<unsigned int> &first, const std::vector<unsigned int> &second,
                   const Vector3 &normal, const LawDescription &law,
                   const std::vector<double> &parameters) {
  check_translations(first);
  check_translations(second);
  Contact contact;
  for (unsigned int d = 0; d < first.size(); ++d) {
    contact.dofs.push_back(first[d]);
    contact.rows.push_back(-Vector3::Unit(d));
  }
  for (unsigned int d = 0; d < second.size(); ++d) {
    contact.dofs.push_back(second[d]);
    contact.rows.push_back(Vector3::Unit(d));
  }
  contact.normal = normal;
  contact.law = &law;
  contact.parameters = parameters;
  return contact;
}

Settings checked(const Settings &settings) {
  for (const double tolerance : {settings.tolerance, settings.contact_tolerance})
    if (!(tolerance > 0. && tolerance < 1.))
      throw std::invalid_argument("A tolerance of " + std::to_string(tolerance) +
                                  "\n  allowed: above 0 and below 1\n  try:     1e-10 of the "
                                  "forces, 1e-8 of the contact laws, which are the defaults");
  return settings;
}

void check_increment(const Increment &increment, const std::size_t n_contacts) {
  if (!std::isfinite(increment.time) || !(increment.length >= 0.) ||
      !std::isfinite(increment.length))
    throw std::invalid_argument(
        "An increment to the time " + std::to_string(increment.time) + " s of length " +
        std::to_string(increment.length) +
        " s\n  allowed: numbers, the length 0 or above\n  try:     a length "
        "of 0 in statics");
  const std::vector<double> &temperatures = increment.temperatures;
  if (!temperatures.empty() && temperatures.size() != n_contacts)
    throw std::invalid_argument(
        "An increment with " + std::to_string(temperatures.size()) +
        " temperatures\n  allowed: " + std::to_string(n_contacts) +
        ", one for each contact, or none\n  try:     none, where laws do not depend on it");
  for (std::size_t i = 0; i < temperatures.size(); ++i)
    if (!std::isfinite(temperatures[i]))
      throw std::invalid_argument("The temperature of contact " + std::to_string(i) +
                                  " (counted from 0) is " + std::to_string(temperatures[i]) +
                                  "\n  allowed: numbers [degC]\n  try:     the temperature at the "
                                  "end of the increment");
}

/// Stored in the elastic part of a contact whose law has a closed form [J].
double stored_in(const Site &site, const Strains &stress) {
  const FrictionThreshold &law = site.law.closed_form();
  return site.weight / 2. *
         (stress[0] * stress[0] / law.axial_rigidity +
          stress[1] * stress[1] / law.shear_rigidity_y +
          stress[2] * stress[2] / law.shear_rigidity_z);
}

} // namespace

Contact on_ground(const std::vector<unsigned int> &translations, const Vector3 &normal,
                  const LawDescription &law, const std::vector<double> &parameters) {
  return contact_of(translations, {}, normal, law, parameters);
}

Contact between(const std::vector<unsigned int> &first, const std::vector<unsigned int> &second,
                const Vector3 &normal, const LawDescription &law,
                const std::vector<double> &parameters) {
  return contact_of(first, second, normal, law, parameters);
}

class Solver::Implementation {
public:
  Implementation(System of_host, const std::vector<Contact> &contacts, const Settings &settings)
      : system(checked(std::move(of_host))), host(system, contacts), sites(host.sites),
        exact(checked(settings), sites, system.condense(host.unknowns()), system.diagonal),
        ground(contacts.size(), Strains::Zero()) {}

  /// Unknowns of a vector on the host's dofs.
  Vector unknowns_of(const Vector &on_dofs) const;
  /// Dofs of unknowns; those of a motion have no given values.
  Vector dofs_of(const Vector &unknowns, const bool is_motion) const;
  Vector product(const Vector &unknowns) const {
    return system.multiply ? system.multiply(unknowns) : Vector(system.matrix * unknowns);
  }
  Problem problem_of(const Vector &right_hand_side, const Increment &increment) const;
  ImposedMotion imposed_motion() const;
  std::vector<Strains> strains_at(const Vector &unknowns, const ImposedMotion &imposed) const;
  Report report_of(const Result &result) const;
  ContactState state_of(const unsigned int i, const State &before, const Response &response) const;
  EnergyAccount account(const Vector &f, const Vector &q_before, const Vector &q,
                        const ContactMemory &before, const Response &response) const;
  /// @throws std::invalid_argument if a memory is not one of these contacts and laws
  void check_memory(const ContactMemory &memory) const;
  /// What the memory holds beside what laws return: wear.
  void remember(const Vector &f, const Report &report, const ContactMemory &before,
                const Response &response, ContactMemory &after) const;

  const System system;
  const HostSites host;
  const SiteList sites;
  ExactSolver exact;
  std::vector<Strains> ground; ///< its motion
};

Solver::Solver(System system, const std::vector<Contact> &contacts, const Settings &settings)
    : implementation(std::make_unique<Implementation>(std::move(system), contacts, settings)) {}

Solver::~Solver() = default;
Solver::Solver(Solver &&) = default;
Solver &Solver::operator=(Solver &&) = default;

Vector Solver::Implementation::unknowns_of(const Vector &on_dofs) const {
  if (on_dofs.size() == 0)
    return Vector::Zero(system.n_unknowns());
  if (on_dofs.size() != static_cast<Eigen::Index>(system.dofs.size()))
    throw std::invalid_argument(
        "A vector of " + std::to_string(on_dofs.size()) +
        " entries\n  allowed: " + std::to_string(system.dofs.size()) +
        ", one for each dof of the host\n  try:     a vector without ghosts");
  Vector result(system.n_unknowns());
  for (int u = 0; u < result.size(); ++u)
    if (result[u] = on_dofs[system.dof_of[u]]; !std::isfinite(result[u]))
      throw std::invalid_argument("A vector whose entry of dof " +
                                  std::to_string(system.dof_of[u]) + " is " +
                                  std::to_string(result[u]) +
                                  "\n  allowed: numbers\n  try:     the right hand side as it was "
                                  "assembled, before the solver");
  return result;
}

Vector Solver::Implementation::dofs_of(const Vector &unknowns, const bool is_motion) const {
  Vector result(system.dofs.size());
  for (std::size_t d = 0; d < system.dofs.size(); ++d) {
    result[d] = is_motion ? 0. : system.dofs[d].given;
    for (const System::Term &term : system.dofs[d].terms)
      result[d] += term.weight * unknowns[term.unknown];
  }
  return result;
}

Problem Solver::Implementation::problem_of(const Vector &right_hand_side,
                                           const Increment &increment) const {
  Problem problem{system.matrix, right_hand_side, increment};
  if (system.multiply)
    problem.unbalanced = [this, right_hand_side](const Vector &unknowns, const Vector &low) {
      return Vector(right_hand_side -
                    system.multiply(low.size() > 0 ? Vector(unknowns + low) : unknowns));
    };
  return problem;
}

ImposedMotion Solver::Implementation::imposed_motion() const {
  ImposedMotion imposed{host.given, 0.};
  for (std::size_t i = 0; i < ground.size(); ++i) {
    imposed.strain[i] += ground[i];
    imposed.displacement =
        std::max(imposed.displacement, imposed.strain[i].lpNorm<Eigen::Infinity>());
  }
  return imposed;
}

std::vector<Strains> Solver::Implementation::strains_at(const Vector &unknowns,
                                                        const ImposedMotion &imposed) const {
  std::vector<Strains> strain = imposed.strain;
  for (unsigned int i = 0; i < sites.size(); ++i)
    strain[i] += sites[i].strain_by_unknowns(unknowns);
  return strain;
}

void Solver::Implementation::check_memory(const ContactMemory &memory) const {
  const State &state = memory.sites, fresh = sites.initial_state(imposed_motion().strain);
  const std::size_t n = sites.size();
  if (memory.stress.size() != n || state.strain.size() != n || state.touch.size() != n ||
      state.dissipated.size() != n || state.wear.size() != n || state.impulse.size() != n ||
      state.internal.size() != fresh.internal.size())
    throw std::invalid_argument(
        "A memory of " + std::to_string(memory.stress.size()) +
        " contacts whose State::internal has " + std::to_string(state.internal.size()) +
        " entries\n  allowed: one of this solver's " + std::to_string(n) + " contacts, with " +
        std::to_string(fresh.internal.size()) +
        " entries, the last of which is spare\n  try:     initial_memory()");
}

ContactMemory Solver::initial_memory(const Vector &u) const {
  const Implementation &of = *implementation;
  return {of.sites.initial_state(of.strains_at(of.unknowns_of(u), of.imposed_motion())),
          std::vector<Strains>(of.sites.size(), Strains::Zero())};
}

void Solver::move_ground(const std::vector<Vector3> &displacement) {
  Implementation &of = *implementation;
  if (!displacement.empty() && displacement.size() != of.ground.size())
    throw std::invalid_argument(
        "Ground moves at " + std::to_string(displacement.size()) +
        " contacts\n  allowed: " + std::to_string(of.ground.size()) +
        ", one displacement for each contact\n  try:     zeros where it rests");
  for (std::size_t i = 0; i < of.ground.size(); ++i) {
    of.ground[i].setZero();
    if (displacement.empty())
      continue;
    if (!displacement[i].allFinite())
      throw std::invalid_argument("The ground of contact " + std::to_string(i) +
                                  " (counted from 0) moves by what is no number\n  allowed: "
                                  "numbers [m]\n  try:     zeros where it rests");
    of.ground[i].head<3>() = of.host.frames[i] * displacement[i];
  }
}

Report Solver::Implementation::report_of(const Result &result) const {
  Report report;
  report.converged = result.converged;
  report.no_equilibrium = result.no_equilibrium;
  report.residual = result.residual;
  if (result.check)
    report.check = *result.check;
  report.iterations = result.iterations;
  report.factorizations = result.factorizations;
  report.remark = result.remark;
  if (result.free_motion.size() > 0)
    report.free_motion = dofs_of(result.free_motion, true);
  return report;
}

ContactState Solver::Implementation::state_of(const unsigned int i, const State &before,
                                              const Response &response) const {
  const Site &site = sites[i];
  const Strains &stress = response.stress[i], &strain = response.state.strain[i];
  ContactState state;
  state.status = response.status[i];
  state.normal_force = -site.share() * stress[0];
  state.force = site.share() * host.frames[i].transpose() * stress.head<3>();
  state.gap = strain[0];
  if (site.law.has_closed_form()) {
    const FrictionThreshold &law = site.law.closed_form();
    state.gap += law.gap - stress[0] / law.axial_rigidity;
    const double *const old_slip = before.internal.data() + site.state_offset;
    if (state.status != ContactStatus::open)
      state.slip = host.frames[i].transpose() *
                   Vector3(0., strain[1] - old_slip[law.slip_y] - stress[1] / law.shear_rigidity_y,
                           strain[2] - old_slip[law.slip_z] - stress[2] / law.shear_rigidity_z);
  }
  return state;
}

EnergyAccount Solver::Implementation::account(const Vector &f, const Vector &q_before,
                                              const Vector &q, const ContactMemory &before,
                                              const Response &response) const {
  EnergyAccount energy;
  const Vector motion = q - q_before, K_before = product(q_before), K_after = product(q);
  Vector f_before = K_before;
  for (unsigned int i = 0; i < sites.size(); ++i) {
    sites[i].add_to(f_before, before.stress[i]);
    const Strains mean = (before.stress[i] + response.stress[i]) / 2.;
    const double dissipated = response.state.dissipated[i] - before.sites.dissipated[i];
    energy.dissipated += dissipated;
    const Strains opened = response.state.strain[i] - before.sites.strain[i];
    energy.ground += sites[i].weight * mean.dot(opened - sites[i].strain_by_unknowns(motion));
    energy.in_contacts +=
        sites[i].law.has_closed_form()
            ? stored_in(sites[i], response.stress[i]) - stored_in(sites[i], before.stress[i])
            : sites[i].weight * mean.dot(opened) - dissipated;
  }
  energy.external = (f_before + f).dot(motion) / 2.;
  energy.stored = (K_before + K_after).dot(motion) / 2.;
  return energy;
}

void Solver::Implementation::remember(const Vector &f, const Report &report,
                                      const ContactMemory &before, const Response &response,
                                      ContactMemory &after) const {
  const double largest =
      std::max({before.largest_force, f.lpNorm<Eigen::Infinity>(), sites.largest_force(response)});
  ContactMemory next{response.state, response.stress, largest};
  next.sites.wear = before.sites.wear;
  next.sites.impulse = before.sites.impulse;
  for (unsigned int i = 0; i < sites.size(); ++i)
    next.sites.wear[i] += report.contacts[i].normal_force * report.contacts[i].slip.norm();
  after = std::move(next); // which may be the one before
}

Report Solver::solve(const Vector &f, const ContactMemory &before, Vector &u, ContactMemory &after,
                     const Increment &increment) {
  Implementation &of = *implementation;
  of.check_memory(before);
  check_increment(increment, of.sites.size());
  const Vector forces = of.unknowns_of(f), q_before = of.unknowns_of(u);
  Vector q = q_before;
  Response response;
  Problem problem = of.problem_of(forces, increment);
  problem.largest_force = least_force * before.largest_force;
  problem.force_so_far = before.largest_force;
  const Result result = of.exact.solve(problem, of.imposed_motion(), before.sites, q, response);
  Report report = of.report_of(result);
  if (!report.converged)
    return report;
  for (unsigned int i = 0; i < of.sites.size(); ++i)
    report.contacts.push_back(of.state_of(i, before.sites, response));
  report.energy = of.account(forces, q_before, q, before, response);
  if (of.sites.size() <= most_contacts_for_uniqueness)
    report.not_unique = of.exact.beyond_uniqueness(response.status);
  of.remember(forces, report, before, response, after);
  u = of.dofs_of(q, false);
  return report;
}

Report Solver::strike(const Vector &momentum, const std::vector<bool> &takes_part,
                      const double restitution, Vector &v) {
  constexpr double far = 1e30; // [m]
  Implementation &of = *implementation;
  const unsigned int n = of.sites.size();
  if (takes_part.size() != n || !(restitution >= 0. && restitution <= 1.))
    throw std::invalid_argument("An impact at " + std::to_string(takes_part.size()) +
                                " contacts with restitution " + std::to_string(restitution) +
                                "\n  allowed: " + std::to_string(n) +
                                " contacts, and 0 to 1\n  try:     a flag for each contact");
  const Vector impulse = of.unknowns_of(momentum), before = of.unknowns_of(v);
  const State at_rest = of.sites.initial_state(std::vector<Strains>(n, Strains::Zero()));
  Overrides overrides{std::vector<double>(n, far), std::vector<double>(n, 1.)};
  for (unsigned int i = 0; i < n; ++i) {
    const BoundLaw &law = of.sites[i].law;
    if (!law.is_rigid_along_normal() || std::isfinite(law.closed_form().shear_rigidity_y))
      throw std::invalid_argument("Contact " + std::to_string(i) + " (counted from 0): its law '" +
                                  law.name() +
                                  "' is not rigid, and an impact takes no time\n  allowed: rigid "
                                  "laws\n  try:     rigidities of 0 of the law coulomb");
    if (takes_part[i])
      overrides.gap[i] = restitution * std::min(0., of.sites[i].strain_by_unknowns(before)[0]);
  }
  Problem problem = of.problem_of(impulse, {});
  problem.overrides = &overrides;
  Vector after = before;
  Response response;
  const Result result = of.exact.solve(problem, {}, at_rest, after, response);
  Report report = of.report_of(result);
  if (!report.converged)
    return report;
  for (unsigned int i = 0; i < n; ++i)
    report.contacts.push_back(of.state_of(i, at_rest, response));
  const Vector motion = after - before, mean = (before + after) / 2.;
  report.energy.external = (impulse - of.product(before)).dot(mean);
  report.energy.stored = of.product(motion).dot(mean);
  report.energy.dissipated = report.energy.external - report.energy.stored;
  v = of.dofs_of(after, true);
  return report;
}

} // namespace frictionbeam::contact
