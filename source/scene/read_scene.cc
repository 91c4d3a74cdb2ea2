// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/catalogue/catalogue_entries.h"
#include "scene/doubt/idle_parts.h"
#include "scene/doubt/route_doubts.h"
#include "scene/file/parameter_notes.h"
#include "scene/generated/scene_kinds.h"
#include "scene/history_corners.h"
#include "scene/law_entries.h"
#include "scene/part/body_parts.h"
#include "scene/part/parts.h"
#include "scene/solid/solid_entries.h"
#include "scene/study/study_entries.h"
#include "scene/unused/unused_entries.h"

#include "base/user_error.h"
#include "scene/read_scene.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <functional>
#include <map>
#include <ostream>

namespace frictionbeam {

namespace {

/// Kinds of parts, in the order in which they are read: each may refer to those before it.
const std::vector<std::string> part_kinds = {
    "Material", "Section", "Point", "Pipe",    "Support", "Spring", "Mass",     "Joint",
    "Tee",      "Load",    "Step",  "Initial", "Hanger",  "Nozzle", "Spectrum", "Combination"};
const std::vector<std::string> settings = {
    "Catalogue", "Mesh",     "Continuum", "Solid", "Solver",     "Time",   "Output",
    "Modes",     "Response", "Stress",    "Exact", "Quantities", "Checks", "Study"};

std::string kind_of(const std::string &heading) { return heading.substr(0, heading.find(' ')); }

std::string name_of(const std::string &heading) {
  const auto blank = heading.find(' ');
  return blank == std::string::npos ? "" : heading.substr(blank + 1);
}

struct SimplePart {
  std::string kind;
  void (*declare)(ParameterReader &);
  void (*parse)(const ParameterReader &, const std::string &, Scene &);
};

/// Parts that need nothing but their section.
const std::vector<SimplePart> simple_parts = {
    {"Material", &parts::declare_material, &parts::parse_material},
    {"Point", &parts::declare_point, &parts::parse_point},
    {"Pipe", &parts::declare_pipe, &parts::parse_pipe},
    {"Spring", &parts::declare_spring, &parts::parse_spring},
    {"Mass", &parts::declare_mass, &parts::parse_mass},
    {"Joint", &parts::declare_joint, &parts::parse_joint},
    {"Tee", &parts::declare_tee, &parts::parse_tee},
    {"Step", &parts::declare_step, &parts::parse_step},
    {"Hanger", &parts::declare_hanger, &parts::parse_hanger},
    {"Nozzle", &parts::declare_nozzle, &parts::parse_nozzle},
    {"Spectrum", &parts::declare_spectrum, &parts::parse_spectrum},
    {"Combination", &parts::declare_combination, &parts::parse_combination}};

const SimplePart *simple_part(const std::string &kind) {
  const auto found = std::find_if(simple_parts.begin(), simple_parts.end(),
                                  [&](const SimplePart &part) { return part.kind == kind; });
  return found == simple_parts.end() ? nullptr : &*found;
}

void declare_part(ParameterReader &in, const LawLibrary &laws, const std::string &kind) {
  if (const SimplePart *const part = simple_part(kind))
    part->declare(in);
  else if (kind == "Support")
    parts::declare_support(in, laws);
  else if (kind == "Section")
    parts::declare_section(in, laws);
  else if (kind == "Load")
    parts::declare_load(in);
  else
    parts::declare_initial(in);
}

void parse_part(const ParameterReader &in, const LawLibrary &laws, const std::string &kind,
                const std::string &name, const double installation_temperature, Scene &scene) {
  if (const SimplePart *const part = simple_part(kind))
    part->parse(in, name, scene);
  else if (kind == "Support")
    parts::parse_support(in, laws, name, scene);
  else if (kind == "Section")
    parts::parse_section(in, laws, name, scene);
  else if (kind == "Load")
    parts::parse_load(in, name, installation_temperature, scene);
  else
    parts::parse_initial(in, scene);
}

/// What is wrong with a heading of a scene of that kind, if anything.
void check_heading(ParameterReader &in, const std::string &heading, const SceneKind &generator) {
  const std::string kind = kind_of(heading), name = name_of(heading);
  in.enter(heading);
  std::vector<std::string> allowed = settings;
  if (generator.is_generated() && heading == "Stress")
    in.fail_section("section " + heading, "this section with Scene = line only",
                    "removing it, or Scene = line");
  if (std::count(settings.begin(), settings.end(), heading) > 0)
    return;
  std::vector<std::string> users; // of a section of generated scenes
  for (const SceneKind &scene : scene_kinds())
    if (heading == scene.value)
      users.push_back(scene.word);
  if (!users.empty() && generator.value != heading)
    in.fail_section(heading, "this section with Scene = " + join(users) + " only",
                    "set Scene = " + users.front());
  if (!users.empty())
    return;
  std::vector<std::string> kinds = part_kinds;
  kinds.push_back(parts::variation_kind);
  if (std::count(kinds.begin(), kinds.end(), kind) == 0) {
    for (const std::string &part : kinds)
      allowed.push_back(part + " <name>");
    for (const SceneKind &scene : scene_kinds())
      if (scene.is_generated())
        allowed.emplace_back(scene.value);
    std::vector<std::string> candidates = settings;
    candidates.insert(candidates.end(), kinds.begin(), kinds.end());
    const std::string like = nearest(kind, candidates);
    in.fail_section("subsection " + heading, join(allowed),
                    like.empty() ? "one of these kinds of parts"
                                 : "'" + like + (name.empty() ? "" : " " + name) + "'");
  }
  if (generator.is_generated() && kind != parts::variation_kind)
    in.fail_section("subsection " + heading,
                    "no parts beside Scene = " + std::string(generator.word) +
                        ", which makes its own from section " + generator.value,
                    "removing this part, or Scene = line");
  if (name.empty() || name.find_first_of(" ,;/|'\"") != std::string::npos)
    in.fail_section(name.empty() ? "no name" : "'" + name + "'",
                    "subsection " + kind + " <name>, one word without , ; / | and quotes",
                    "'" + kind + " main'");
}

/// A --set option that names a part which the file does not have is a slip of the pen.
void check_overridden_headings(const ParameterFile &file,
                               const std::vector<std::string> &file_headings) {
  for (const ParameterFile::Section &section : file.sections()) {
    const bool in_file =
        std::count(file_headings.begin(), file_headings.end(), section.heading) > 0;
    const std::string kind = kind_of(section.heading);
    if (in_file || parts::is_support_place(file, section) ||
        (kind != parts::variation_kind &&
         std::count(part_kinds.begin(), part_kinds.end(), kind) == 0))
      continue;
    std::vector<std::string> parts;
    for (const std::string &heading : file_headings)
      if (!heading.empty())
        parts.push_back(heading);
    const std::string like = nearest(section.heading, parts);
    throw UserError(section.origin + ":\n  read:    section '" + section.heading +
                    "', which the file does not have\n  allowed: " + join(parts) +
                    "\n  try:     " + (like.empty() ? "one of these" : "'" + like + "'"));
  }
}

/// Names by which quantities find things must be unique.
void check_unique_names(const ParameterReader &in, const Scene &scene) {
  std::map<std::string, std::string> seen;
  const auto add = [&](const std::string &name, const std::string &what) {
    const auto [place, is_new] = seen.emplace(name, what);
    if (!is_new)
      throw UserError(in.file().name() + ": " + what + " '" + name + "'\n  read:    the name '" +
                      name + "' for a " + place->second + " and for a " + what +
                      "\n  allowed: different names for points, supports and springs\n"
                      "  try:     another name for one of the two");
  };
  for (const std::string &name : parts::point_names(scene))
    add(name, "point");
  for (const FrictionSupport &support : scene.supports)
    add(support.name, "support");
  for (const Restraint &restraint : scene.restraints)
    add(restraint.name, "support");
  for (const Spring &spring : scene.springs)
    add(spring.name, "spring");
}

struct SettingsSection {
  std::string heading;
  void (*declare)(ParameterReader &);
  void (*parse)(const ParameterReader &, Scene &);
};

/// Sections that need no part of the scene.
const std::vector<SettingsSection> settings_sections = {
    {"Catalogue", &parts::declare_catalogue, &parts::parse_catalogue},
    {"Mesh", &parts::declare_mesh, &parts::parse_mesh},
    {"Continuum", &parts::declare_continuum, &parts::parse_continuum},
    {"Solid", &parts::declare_solid, &parts::parse_solid},
    {"Solver", &parts::declare_solver, &parts::parse_solver},
    {"Time", &parts::declare_time, &parts::parse_time},
    {"Output", &parts::declare_output, &parts::parse_output},
    {"Checks", &parts::declare_checks, &parts::parse_checks},
    {"Modes", &parts::declare_modes, &parts::parse_modes},
    {"Response", &parts::declare_response, &parts::parse_response}};

void read_settings(ParameterReader &in, Scene &scene) {
  for (const SettingsSection &section : settings_sections) {
    in.enter(section.heading);
    section.declare(in);
    in.take();
    section.parse(in, scene);
  }
}

/// A scene made of the parts in the file.
void read_parts(ParameterReader &in, const LawLibrary &laws, const double installation_temperature,
                Scene &scene) {
  for (const std::string &kind : part_kinds)
    for (const ParameterFile::Section &section : in.file().sections())
      if (kind_of(section.heading) == kind && !parts::is_support_place(in.file(), section)) {
        in.enter(section.heading);
        declare_part(in, laws, kind);
        in.take();
        parse_part(in, laws, kind, name_of(section.heading), installation_temperature, scene);
      }
  parts::parse_support_places(in, laws, scene);
  in.enter("Modes");
  parts::check_modes(in, scene);
  in.enter("Response");
  parts::check_response(in, scene);
  in.enter("Stress");
  parts::declare_stress(in);
  in.take();
  parts::parse_stress(in, scene);
  in.enter("");
  if (scene.pipes.empty() && scene.points.empty())
    in.fail_section("no pipe and no point", "at least one part 'Pipe <name>' or 'Point <name>'",
                    "subsection Pipe main, with a Route");
  if (scene.steps.empty())
    in.fail_section("an empty load sequence: no part 'Step <name>'",
                    "at least one 'Step <name>', taken in the order of the file",
                    "subsection Step cold, with 'set Loads = <names of loads>'");
  parts::check_hangers(in, scene);
}

void read_units(ParameterReader &in, Scene &scene) {
  if (const auto units = UnitSystem::parse(in.text("Units")))
    scene.units = *units;
  else
    in.fail("Units",
            "si, or a length and a force, and a mass, a stress and a temperature if they "
            "are not those that follow: " +
                UnitSystem::known_words(),
            "'in lb psi F'");
  in.set_units(scene.units);
}

/// What of the scene's parts goes together, and what is asked of them.
void check_whole(ParameterReader &in, Scene &scene) {
  in.enter("");
  parts::check_model(in, scene);
  parts::parse_monitors(in, scene);
  parts::check_kinematics(in, scene);
  parts::check_inelastic(in, scene);
  parts::check_output(in, scene);
  in.enter("");
  parts::remark_on_free_motions(scene);
  remark_on_unused(in, scene);
  remark_on_idle_parts(scene);
  in.enter("");
  parts::check_histories(scene);
  parts::check_size(in, scene);
  doubt_routes(scene);
  in.enter("");
  check_unique_names(in, scene);
}

void read_quantities(ParameterReader &in, Scene &scene) {
  in.enter("Exact");
  parts::declare_exact(in);
  in.take();
  parts::parse_exact(in, scene);
  in.enter("Quantities");
  parts::declare_quantities(in);
  in.take();
  if (parts::has_line(scene))
    parts::parse_quantities(in, scene);
  if (scene.continuum && scene.model != ModelKind::line)
    parts::parse_continuum_quantities(in, scene);
}

} // namespace

Scene read_scene(const std::string &file, const std::vector<std::string> &overrides,
                 LawLibrary &laws) {
  ParameterFile text(file);
  std::vector<std::string> headings;
  for (const ParameterFile::Section &section : text.sections())
    headings.push_back(section.heading);
  for (const std::string &option : overrides)
    text.apply(option);

  ParameterReader in(text);
  parts::declare_global(in);
  in.take();
  const SceneKind &kind = scene_kind(in.text("Scene"));
  for (const ParameterFile::Section &section : text.sections())
    if (!section.heading.empty())
      check_heading(in, section.heading, kind);
  check_overridden_headings(text, headings);

  Scene scene;
  scene.name = std::filesystem::path(file).stem().string();
  scene.input = text.text();
  scene.overrides = overrides;
  for (const ParameterFile::Section &section : text.sections())
    if (!section.heading.empty())
      scene.origins.emplace_back(section.heading, section.origin);
  in.enter("");
  read_units(in, scene);
  load_laws(in, laws);
  parts::parse_global(in, scene);
  scene.installation_temperature = in.number("Installation temperature");
  if (kind.is_generated() &&
      (in.given("Free motions") || in.given("Installation temperature") || in.given("Units")))
    in.fail_section("'Free motions', 'Installation temperature' or 'Units'",
                    "none of them with Scene = " + std::string(kind.word) +
                        ", which sets them itself",
                    "removing the entry");
  read_settings(in, scene);
  if (kind.is_generated()) {
    in.enter(kind.value);
    kind.declare(in, laws);
    in.take();
    kind.build(in, laws, scene);
  } else
    read_parts(in, laws, scene.installation_temperature, scene);
  check_whole(in, scene);
  read_quantities(in, scene);
  parts::check_solid(in, scene);
  parts::read_study(in, scene.study);
  parts::add_preload(scene);
  find_corners(scene);
  return scene;
}

std::string with_place(const Scene &scene, const std::string &message) {
  std::string small = message;
  std::transform(small.begin(), small.end(), small.begin(),
                 [](const unsigned char c) { return std::tolower(c); });
  for (const auto &[heading, origin] : scene.origins) {
    const auto blank = heading.find(' ');
    if (blank == std::string::npos)
      continue;
    std::string kind = heading.substr(0, blank);
    kind[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(kind[0])));
    const std::string name = heading.substr(blank + 1);
    for (const std::string &form : {kind + " '" + name + "'", kind + " " + name}) {
      // The name as it is written, the kind with a small or large first letter.
      const auto at = message.find(form.substr(1));
      const auto end = at == std::string::npos ? at : at + form.size() - 1;
      const bool whole = at != std::string::npos && at > 0 && small[at - 1] == form[0] &&
                         (end == message.size() || std::isalnum(message[end]) == 0);
      if (whole)
        return origin + ": " + message;
    }
  }
  return message;
}

void print_parameters(std::ostream &out, const LawLibrary &laws) {
  out << parameter_notes();
  const ParameterFile empty;
  ParameterReader in(empty);
  parts::declare_global(in);
  for (const std::string &kind : part_kinds) {
    in.enter(kind + " name");
    declare_part(in, laws, kind);
  }
  for (const SettingsSection &section : settings_sections) {
    in.enter(section.heading);
    section.declare(in);
  }
  in.enter("Exact");
  parts::declare_exact(in);
  in.enter("Stress");
  parts::declare_stress(in);
  in.enter("Quantities");
  parts::declare_quantities(in);
  parts::declare_study(in);
  for (const SceneKind &kind : scene_kinds())
    if (kind.is_generated()) {
      in.enter(kind.value);
      kind.declare(in, laws);
    }
  in.print(out);
  parts::print_laws(out, laws);
}

} // namespace frictionbeam
