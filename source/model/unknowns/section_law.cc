// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/unknowns/section_law.h"

#include "base/number_text.h"
#include "base/user_error.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace frictionbeam {

using namespace dealii;

namespace {

constexpr char bend_radius_of_law[] = "Bend radius";

/// How a section has to be given for a figure to be known.
enum class By { any, diameter, area };
struct KnownFigure {
  const char *parameter;
  double (*value)(const Section &, const Profile &);
  By by = By::any;
};
constexpr KnownFigure known_figures[] = {
    {"Young's modulus",
     [](const Section &, const Profile &profile) { return profile.material.youngs_modulus; }},
    {"Poisson ratio",
     [](const Section &, const Profile &profile) { return profile.material.poissons_ratio; }},
    {"Outside diameter",
     [](const Section &section, const Profile &) { return 2. * section.outer_radius; },
     By::diameter},
    {"Wall thickness", [](const Section &section, const Profile &) { return section.wall; },
     By::diameter},
    // Of the rectangle with this area and inertia.
    {"Height",
     [](const Section &section, const Profile &) {
       return std::sqrt(12. * section.inertia / section.area);
     },
     By::area},
    {"Width",
     [](const Section &section, const Profile &) {
       return section.area / std::sqrt(12. * section.inertia / section.area);
     },
     By::area},
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

/// What a law says of parameters that it cannot take: what is allowed, ": ", what to try.
[[noreturn]] void refuse_parameters(const std::string &section, const std::string &law,
                                    const std::string &fault) {
  const auto colon = fault.find(": ");
  throw UserError("Section " + section + ": its law '" + law +
                  "' cannot take these parameters together.\n  allowed: " + fault.substr(0, colon) +
                  (colon == std::string::npos ? "" : "\n  try:     " + fault.substr(colon + 2)));
}

void check_figure(const KnownFigure &figure, const Section &section, const std::string &law) {
  const bool is_pipe = section.wall > 0.;
  if (figure.by == By::any || is_pipe == (figure.by == By::diameter))
    return;
  const std::string by_diameter = "'Outer diameter' and 'Wall', or a 'Size'",
                    by_area = "'Area' and 'Inertia'", own = figure.parameter;
  throw UserError("Section " + section.name + ": its law '" + law + "' needs '" + own +
                  "'.\n  read:    a section by its " +
                  (is_pipe ? "diameter and wall\n  allowed: " + by_area +
                                 "\n  try:     " + by_area + ", or Law = fibre_pipe"
                           : "area and inertia\n  allowed: " + by_diameter +
                                 "\n  try:     these, or '" + own + "' itself"));
}

/// @throws UserError if the law is not made for it.
double known_value(const KnownFigure &figure, const LawParameter &parameter, const Section &section,
                   const Profile &profile) {
  const double value = figure.value(section, profile);
  if (!(value >= parameter.minimum && value <= parameter.maximum))
    throw UserError(
        "Section " + section.name + ": '" + parameter.name +
        "' of its law is taken from section and material.\n  read:    " + rounded_number(value, 6) +
        "\n  allowed: " + rounded_number(parameter.minimum, 6) + " to " +
        rounded_number(parameter.maximum, 6) +
        "\n  try:     another material or "
        "section, or '" +
        parameter.name + "' itself");
  return value;
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
    if (figure != nullptr && (!given || figure->by == By::area))
      check_figure(*figure, section, law.name);
    if (given)
      values.push_back(*given);
    else if (name == bend_radius_of_law)
      values.push_back(bend_radius);
    else if (figure == nullptr)
      values.push_back(law.parameters[i].default_value);
    else
      values.push_back(known_value(*figure, law.parameters[i], section, profile));
  }
  if (law.interface_version >= 2 && law.fault != nullptr)
    if (const char *const fault = law.fault(values.data()))
      refuse_parameters(section.name, law.name, fault);
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

void take_section_law(const BoundLaw &law, const std::string &pipe, Profile &profile) {
  profile.tangent = elastic_tangent(law);
  profile.law = law;
  const Table<2, double> &D = profile.tangent;
  constexpr double rounding = 1e-9;
  if (profile.arc_centre && std::abs(D(4, 4) - D(5, 5)) > rounding * D(4, 4))
    throw UserError(
        "Pipe " + pipe +
        ": its section bends differently about its two axes, by its "
        "law '" +
        law.name() +
        "', and stands in a bend.\n  read:    a bend of such a section\n  "
        "allowed: straight pipes of it\n  try:     'Bends = straight pieces' in section "
        "Mesh, or a pipe of its own for the bend");
  const auto take = [&](double &rigidity, const unsigned int component) {
    if (D(component, component) > 0.)
      rigidity = D(component, component);
  };
  const double EA = profile.EA;
  take(profile.EA, 0);
  take(profile.GA, 1);
  take(profile.GJ, 3);
  take(profile.EI, 4);
  profile.pressure_strain *= EA / profile.EA;
}

} // namespace frictionbeam
