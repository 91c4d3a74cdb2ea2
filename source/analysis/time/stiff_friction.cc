// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/time/stiff_friction.h"

#include "analysis/increment/time_step.h"
#include "analysis/time/time_integrator.h"
#include "base/number_text.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {

/// (h omega)^2 of the swing in a friction element's shear beyond which steps do not follow it.
constexpr double most_stiff_shear = 4.;

} // namespace

std::string warn_of_stiff_friction(const Model &model, const std::string &integrator,
                                   const bool with_rigid) {
  const double h = time_step(model);
  std::vector<unsigned int> supports;
  ContactResponse response;
  model.contacts.prepare(response);
  const ContactState at_rest = model.contacts.initial_state(Vector::Zero(model.space.n_dofs()));
  response.state.strain = at_rest.strain;
  for (unsigned int i = 0; i < model.contacts.size(); ++i) {
    const Contact &contact = model.contacts[i];
    if (!contact.law.has_closed_form() ||
        std::count(supports.begin(), supports.end(), contact.support) > 0)
      continue;
    const FrictionThreshold &law = contact.law.closed_form();
    if (law.static_friction == 0. || (std::isinf(law.shear_rigidity_y) && !with_rigid))
      continue;
    model.contacts.evaluate_law(i, at_rest, {}, LawTangent::elastic, response);
    for (unsigned int j = 0; j < contact.unknowns.size(); ++j) {
      const double b = contact.B.col(j).segment<2>(1).squaredNorm(),
                   m = model.linear.mass().coeff(contact.unknowns[j], contact.unknowns[j]);
      if (m > 0. && contact.weight * response.tangent[i](1, 1) * b * h * h > most_stiff_shear * m) {
        supports.push_back(contact.support);
        break;
      }
    }
  }
  if (supports.empty())
    return "";
  std::vector<std::string> names;
  for (const unsigned int support : supports)
    names.push_back(model.scene.supports[support].name);
  return integrator + " may not let stick where static friction holds: at " + first_of(names) +
         ", whose friction elements are too stiff for the time step, so that what has stopped goes "
         "on to swing in them. Take event, a Shear rigidity of 0 (rigid) with Solver/Method = "
         "exact, one that belongs to the support, or a shorter Time/Step.";
}

} // namespace frictionbeam
