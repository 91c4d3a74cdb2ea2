// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/part/body_parts.h"

#include "scene/law_entries.h"

#include <algorithm>

namespace frictionbeam {

namespace generated {

namespace {

double number_of(const ParameterReader &in, const std::string &entry, const std::string &text) {
  double value;
  if (!to_number(text, value))
    in.fail(entry, "numbers", "a number in place of '" + text + "'");
  return value;
}

/// "left x; bottom x y"
std::vector<ContinuumHold> parse_holds(const ParameterReader &in) {
  std::vector<ContinuumHold> holds;
  for (const std::string &item : split(in.text("Held"), ';')) {
    const std::vector<std::string> words = split(item, ' ');
    if (words.size() < 2)
      in.fail("Held", "a part or point and the directions x y z in which it is held, between ;",
              item.empty() ? "leaving the ; out that nothing follows" : "'" + item + " x'",
              "'" + item + "'");
    ContinuumHold hold;
    hold.part = words[0];
    for (std::size_t i = 1; i < words.size(); ++i) {
      const std::size_t axis = std::string("xyz").find(words[i]);
      if (words[i].size() != 1 || axis == std::string::npos)
        in.fail("Held", "a part or point and the directions x y z in which it is held, between ;",
                "'left x; bottom y'", "'" + item + "'");
      hold.fixed[axis] = true;
    }
    holds.push_back(hold);
  }
  return holds;
}

/// "top 0 -1e6; side pressure 5e6"
std::vector<ContinuumTraction> parse_tractions(const ParameterReader &in) {
  std::vector<ContinuumTraction> tractions;
  for (const std::string &item : split(in.text("Loaded"), ';')) {
    const std::vector<std::string> words = split(item, ' ');
    ContinuumTraction traction;
    if (!words.empty())
      traction.part = words[0];
    if (words.size() == 3 && words[1] == "pressure")
      traction.pressure = number_of(in, "Loaded", words[2]);
    else if (words.size() == 3 || words.size() == 4)
      for (std::size_t i = 1; i < words.size(); ++i)
        traction.vector[i - 1] = number_of(in, "Loaded", words[i]);
    else
      in.fail("Loaded", "a part and its traction tx ty (tz), or 'pressure' and p [Pa], between ;",
              "'top 0 -1e6; side pressure 5e6'", "'" + item + "'");
    tractions.push_back(traction);
  }
  return tractions;
}

/// A plane body knows nothing of z.
void check_plane(const ParameterReader &in, const ContinuumScene &body) {
  for (const ContinuumHold &hold : body.holds)
    if (hold.fixed[2])
      in.fail("Held", "x and y in a plane body", "Continuum/Dimension = 3, or without z",
              "'z' of '" + hold.part + "'");
  for (const ContinuumTraction &traction : body.tractions)
    if (traction.vector[2] != 0.)
      in.fail("Loaded", "tx ty in a plane body", "Continuum/Dimension = 3, or without the third",
              "three numbers of '" + traction.part + "'");
}

} // namespace

void declare_body(ParameterReader &in, const LawLibrary &laws) {
  in.declare_number("Young's modulus", 2.1e11, "Pa", positive, 1e300, "Of the body.");
  in.declare_number("Poisson", 0.3, "-", 0., 0.4999, "Ratio of the body.");
  in.declare_choice("Plane", false, plane_kinds, "Kind of plane problem.");
  in.declare_number("Thickness", 1., "m", positive, 1e300, "Of a plane body.");
  in.declare_text("Held", "", "parts or points with directions, 'left x; bottom y'",
                  "Displacements held at zero.");
  in.declare_text("Loaded", "", "parts with tractions [Pa], 'top 0 -1e6; side pressure 5e6'",
                  "Loads at a factor of one.");
  in.declare_text("Frictional", "", "names of parts, separated by commas",
                  "Parts on a foundation with friction.");
  in.declare_number("Pressure", 0., "Pa", 0., 1e300,
                    "That presses frictional parts on, from the start; 0: unilateral contact.");
  in.declare_text("Factors", "1", "numbers [-]",
                  "Of the loads, at the ends of the steps step_1, step_2, ...");
  in.declare_text("Law", "coulomb", join(laws.names(LawKind::support)),
                  "Of friction, a law of supports: its elements are those on one square metre, 1 m "
                  "long.");
  declare_parameters(in, find_law(in, laws, LawKind::support, "coulomb"));
}

void build_body(const ParameterReader &in, const LawLibrary &laws, Scene &scene) {
  ContinuumScene body;
  body.dimension = scene.continuum_settings.dimension;
  body.plane_strain = in.choice("Plane", plane_kinds);
  body.thickness = in.number("Thickness");
  body.youngs_modulus = in.number("Young's modulus");
  body.poissons_ratio = in.number("Poisson");
  if (scene.mesh.file.empty())
    in.fail_section("no Mesh/File", "a mesh of the body's own, a .geo or .msh file",
                    "subsection Mesh, set File = body.geo");
  body.holds = parse_holds(in);
  body.tractions = parse_tractions(in);
  if (body.dimension == 2)
    check_plane(in, body);
  const LawDescription &law = laws.find(in.text("Law"));
  if (std::string(law.name) == "snubber")
    in.fail("Law", "a law that holds in static steps, which are all that bodies have", "coulomb");
  ContinuumContact contact;
  contact.law = law.name;
  for (int i = 0; i < law.n_parameters; ++i)
    contact.parameters.push_back(in.number(law.parameters[i].name));
  check_closed_form(in, law, contact.parameters);
  remark_on_units(in, "Body", law, scene.remarks);
  if (in.number("Pressure") > 0.)
    contact.pressure = in.number("Pressure");
  for (const std::string &part : in.list("Frictional")) {
    contact.part = part;
    body.contacts.push_back(contact);
  }
  if (body.contacts.empty())
    in.fail("Frictional", "at least one part of the mesh's boundary", "'top'");
  for (const double factor : in.numbers("Factors"))
    body.steps.push_back({"step_" + std::to_string(body.steps.size() + 1), factor,
                          scene.continuum_settings.increments});
  if (body.steps.empty())
    in.fail("Factors", "at least one number", "1");
  scene.continuum = body;
}

} // namespace generated

namespace parts {

namespace {

/// "ux uy uz at POINT; ...", as the table has them.
std::string body_forms() {
  using At = BodyQuantityKind::At;
  constexpr Word<At> places[] = {{"POINT", At::point}, {"PART", At::part}, {"X [m]", At::x}};
  std::string text;
  for (const Word<At> &place : places) {
    for (const BodyQuantityKind &kind : body_quantity_kinds)
      if (kind.at == place.value)
        text += std::string(kind.word) + " ";
    text += std::string("at ") + place.word + "; ";
  }
  return text;
}

[[noreturn]] void fail_form(const ParameterReader &in, const std::string &entry,
                            const std::string &read) {
  in.fail(entry, "of a continuum: " + body_forms() + "then '; reference R; source TEXT'",
          "'mean_ux at left; reference 0.012; source hand calculation'", "'" + read + "'");
}

/// What is asked of a surface with friction shall be one.
void check_contact_part(const ParameterReader &in, const std::string &entry,
                        const ContinuumQuantity &quantity, const ContinuumScene &body) {
  if (!row_of(body_quantity_kinds, quantity.kind).of_friction)
    return;
  std::string known;
  for (const ContinuumContact &contact : body.contacts) {
    if (contact.part == quantity.where)
      return;
    known += (known.empty() ? "" : ", ") + contact.part;
  }
  in.fail(entry, "a part of the boundary with friction: " + known, "another part",
          "'" + quantity.where + "'");
}

/// `what at where`
void parse_subject(const ParameterReader &in, const std::string &text, const ContinuumScene &body,
                   ContinuumQuantity &quantity) {
  const std::vector<std::string> words = split(text, ' ');
  const auto kind = find_word(body_quantity_kinds, words[0]);
  if (kind == std::end(body_quantity_kinds) || words.size() != 3 || words[1] != "at")
    fail_form(in, quantity.name, text);
  quantity.kind = kind->value;
  quantity.where = words[2];
  quantity.component = kind->component;
  if (kind->at == BodyQuantityKind::At::x && !to_number(words[2], quantity.x))
    fail_form(in, quantity.name, text);
  if (quantity.component >= body.dimension)
    in.fail(quantity.name, "ux and uy in a plane body",
            "mean_uy, or Continuum/Dimension = 3 of a body in space", "'" + words[0] + "'");
  check_contact_part(in, quantity.name, quantity, body);
}

/// `reference R` or `source TEXT` @param counts whether the reference does
void parse_attribute(const ParameterReader &in, const std::string &piece, const bool counts,
                     std::set<std::string> &keys, ContinuumQuantity &quantity) {
  const auto blank = piece.find(' ');
  const std::string key = piece.substr(0, blank),
                    value = blank == std::string::npos ? "" : piece.substr(blank + 1);
  in.say_once(quantity.name, key, keys);
  double number;
  if (key == "reference" && to_number(value, number)) {
    if (counts)
      quantity.reference = number;
  } else if (key == "source")
    quantity.source = value;
  else
    fail_form(in, quantity.name, piece);
}

} // namespace

void parse_continuum_quantities(const ParameterReader &in, Scene &scene) {
  const ParameterFile::Section *const section = in.file().find("Quantities");
  if (section == nullptr)
    return;
  auto &quantities = scene.continuum->quantities;
  for (const ParameterFile::Entry &entry : section->entries) {
    if (entry.name == "Source")
      continue;
    const std::vector<std::string> pieces = split(entry.value, ';');
    const std::vector<std::string> words =
        pieces.empty() ? std::vector<std::string>() : split(pieces[0], ' ');
    if (words.empty())
      fail_form(in, entry.name, entry.value);
    // A quantity of the generated scene is given a reference by its name alone.
    const auto known =
        std::find_if(quantities.begin(), quantities.end(),
                     [&](const ContinuumQuantity &other) { return other.name == entry.name; });
    const bool is_reference = known != quantities.end() && words[0] == "reference";
    if (has_line(scene) && !is_reference)
      continue; // a quantity of the line
    ContinuumQuantity quantity;
    quantity.name = entry.name;
    if (is_reference)
      quantity = *known;
    else
      parse_subject(in, pieces[0], *scene.continuum, quantity);
    const bool counts = !in.scene_changed() || entry.is_override; // the reference
    std::set<std::string> keys;
    for (std::size_t i = is_reference ? 0 : 1; i < pieces.size(); ++i)
      parse_attribute(in, pieces[i], counts, keys, quantity);
    if (quantity.reference && quantity.source.empty())
      quantity.source = in.text("Source");
    if (known != quantities.end())
      *known = quantity;
    else
      quantities.push_back(quantity);
  }
}

} // namespace parts

} // namespace frictionbeam
