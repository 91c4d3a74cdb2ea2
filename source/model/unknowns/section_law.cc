// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/unknowns/section_law.h"

#include "base/number_text.h"
#include "base/user_error.h"

#include <algorithm>
#include <iterator>

namespace frictionbeam {

using namespace dealii;

namespace {

constexpr char bend_radius_of_law[] = "Bend radius";

struct KnownFigure {
  const char *parameter;
  double (*value)(const Section &, const Profile &);
  bool needs_diameter = false;
};
constexpr KnownFigure known_figures[] = {
    {"Young's modulus",
     [](const Section &, const Profile &profile) { return profile.material.youngs_modulus; }},
    {"Poisson ratio",
     [](const Section &, const Profile &profile) { return profile.material.poissons_ratio; }},
    {"Outside diameter",
     [](const Section &section, const Profile &) { return 2. * section.outer_radius; }, true},
    {"Wall thickness", [](const Section &section, const Profile &) { return section.wall; }, true},
    {"Axial rigidity", [](const Section &, const Profile &profile) { return profile.EA; }},
    {"Shear rigidity", [](const Section &, const Profile &profile) { return profile.GA; }},
    {"Torsional rigidity", [](const Section &, const Profile &profile) { return profile.GJ; }},
    {"Bending rigidity", [](const Section &, const Profile &profile) { return profile.EI; }}};

const KnownFigure *known_figure(const std::string &parameter) {
  const auto found =
      std::find_if(std::begin(known_figures), std::end(known_figures),
                   [&](const KnownFigure &figure) { return figure.parameter == parameter; });
  return found == std::end(known_figures) ? nullptr : found;
}

} // namespace

BoundLaw bind_section_law(const LawDescription &law, const Section &section, const Profile &profile,
                          const double bend_radius, const std::string &pipe) {
  std::vector<double> values;
  bool knows_bends = false;
  for (int i = 0; i < law.n_parameters; ++i) {
    const std::string name = law.parameters[i].name;
    const std::optional<double> given =
        section.law_parameters.empty() ? std::nullopt : section.law_parameters[i];
    const KnownFigure *const figure = known_figure(name);
    knows_bends = knows_bends || name == bend_radius_of_law || name == "Bending rigidity";
    if (given)
      values.push_back(*given);
    else if (name == bend_radius_of_law)
      values.push_back(bend_radius);
    else if (figure == nullptr)
      values.push_back(law.parameters[i].default_value);
    else if (figure->needs_diameter && section.wall == 0.)
      throw UserError("Section " + section.name + ": its law '" + law.name + "' needs '" + name +
                      "'.\n  read:    a section by its area and inertia\n  allowed: 'Outer "
                      "diameter' and 'Wall', or a 'Size'\n  try:     these, or '" +
                      name + "' itself");
    else
      values.push_back(figure->value(section, profile));
  }
  if (law.interface_version >= 2 && law.fault != nullptr)
    if (const char *const fault = law.fault(values.data()))
      throw UserError("Section " + section.name + ": its law '" + law.name +
                      "' cannot take these parameters.\n  allowed: " + fault);
  const double straight = profile.material.youngs_modulus * section.inertia;
  constexpr double rounding = 1e-9;
  if (!knows_bends && profile.EI < (1. - rounding) * straight)
    throw UserError("Pipe " + pipe + ": its bends are " + rounded_number(straight / profile.EI, 3) +
                    " times as flexible as a straight pipe, which the law '" + law.name +
                    "' of section " + section.name +
                    " knows nothing of.\n  read:    a law of straight pipes\n  allowed: bends with "
                    "a law that has 'Bend radius' or 'Bending rigidity'\n  try:     a section of "
                    "its own with Law = global_plastic for the bend, or 'Bend flexibility = none'");
  return {law, values};
}

Table<2, double> elastic_tangent(const BoundLaw &law) {
  const BoundLaw::Answer answer =
      law.answer_at_rest(std::vector<double>(n_section_strains, 0.), 1., LawTangent::elastic,
                         LawIncrement().temperature);
  Table<2, double> result(n_section_strains, n_section_strains);
  result.fill(answer.tangent.begin(), true);
  return result;
}

} // namespace frictionbeam
