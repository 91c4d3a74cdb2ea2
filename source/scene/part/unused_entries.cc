// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/part/parts.h"

#include <algorithm>
#include <map>

namespace frictionbeam::parts {

namespace {

/// Of a section's entries those that were given, in a remark that says why they are not used.
void remark_on(const ParameterReader &in, const std::string &section,
               const std::vector<std::string> &entries, const std::string &why, Scene &scene) {
  for (const std::string &entry : entries)
    if (in.given(entry))
      scene.remarks.push_back(section + ": its " + entry + " is not used " + why + ".");
}

/// Entries of Time that belong to other integrators than the one that is taken.
void remark_on_integrator(ParameterReader &in, Scene &scene) {
  in.enter("Time");
  const IntegratorRow &taken = scene.time.row();
  std::map<std::string, std::vector<std::string>> users; // of each entry that is not of this one
  for (const IntegratorRow &row : integrators)
    for (const char *const entry : row.entries)
      if (entry != nullptr && in.given(entry) &&
          std::none_of(taken.entries.begin(), taken.entries.end(), [&](const char *const own) {
            return own != nullptr && std::string(own) == entry;
          }))
        users[entry].push_back(row.word);
  for (const auto &[entry, words] : users)
    scene.remarks.push_back("Time/" + entry + " is of " + join(words) +
                            " and is not used with Integrator = " + taken.word + ".");
  for (const LoadStep &step : scene.steps)
    if (step.transient && !scene.time.is_exact() && scene.time.step > step.duration)
      scene.remarks.push_back("Time/Step is longer than step " + step.name +
                              ", all of which is one time step.");
  if (scene.time.is_exact())
    remark_on(in, "Time", {"Tolerance"},
              "with Integrator = " + std::string(taken.word) + ", which is exact with any step",
              scene);
  const bool maps_back =
      taken.value == Integrator::newmark || taken.value == Integrator::generalized_alpha;
  if (!maps_back || scene.solver.is_exact())
    return;
  for (const FrictionSupport &support : scene.supports)
    if (support.restitution > 0.)
      scene.remarks.push_back("Support " + support.name +
                              ": its Restitution is not used with Integrator = " + taken.word +
                              " and Solver/Method = " + scene.solver.row().word +
                              ", which know no impulses; Method = exact does.");
}

/// What an Initial wants of a point in directions in which a load moves it.
void remark_on_moved_points(Scene &scene) {
  for (const InitialCondition &initial : scene.initial) {
    std::vector<std::string> points = initial.points;
    for (const Pipe &pipe : scene.pipes)
      if (std::count(initial.pipes.begin(), initial.pipes.end(), pipe.name) > 0)
        for (const RoutePoint &point : pipe.route)
          if (std::count(points.begin(), points.end(), point.name) == 0)
            points.push_back(point.name);
    for (const Load &load : scene.loads)
      for (const Load::AtPoint &moved : load.at)
        for (unsigned int c = 0; c < 6; ++c)
          if (const Motion axis = unit_motion(moved.axes, c);
              load.kind == Load::Kind::displacement && moved.given[c] &&
              (product(initial.velocity, axis) != 0. ||
               product(initial.displacement, axis) != 0.) &&
              std::count(points.begin(), points.end(), moved.point) > 0)
            scene.remarks.push_back("The Initial of " + moved.point + " has a part along " +
                                    motions[c] + ", in which load " + load.name +
                                    " moves it: it does nothing there.");
  }
}

/// What an Initial wants in directions that Free motions holds.
void remark_on_initial(Scene &scene) {
  for (const InitialCondition &initial : scene.initial)
    for (unsigned int c = 0; c < 6 && initial.about.empty(); ++c)
      if (!scene.free_motions[c] && (initial.velocity[c] != 0. || initial.displacement[c] != 0.)) {
        const std::string &where =
            initial.points.empty() ? initial.pipes.front() : initial.points.front();
        scene.remarks.push_back("The Initial of " + where + " has a part along " + motions[c] +
                                ", which is not one of the Free motions: it does nothing.");
      }
}

/// The number that the file gives for an entry of the section; 0 where it gives none.
double number_of(const ParameterReader &in, const std::string &entry) {
  double value = 0.;
  return to_number(in.raw(entry, "0"), value) ? value : 0.;
}

bool is_on(const ParameterReader &in, const std::string &entry) {
  const std::string word = in.raw(entry, "false");
  return word == "true" || word == "yes" || word == "on";
}

/// What of a support's law another of its entries leaves without effect.
void remark_on_support(const ParameterReader &in, const std::string &section, const bool has_motion,
                       Scene &scene) {
  const std::string rigidity = "Torsional rigidity";
  if (!is_on(in, "Torsion"))
    remark_on(in, section, {rigidity, "Patch radius"}, "without Torsion = true", scene);
  else if (in.raw("Law", "coulomb") == "coulomb" && number_of(in, rigidity) == 0.) {
    scene.remarks.push_back(section + ": its Torsion does nothing without a " + rigidity +
                            " > 0 [N m2], whose default is 0.");
    remark_on(in, section, {"Patch radius"}, "without a " + rigidity, scene);
  }
  if (scene.solver.is_exact() && number_of(in, "Shear rigidity") == 0.)
    remark_on(in, section, {"Shear rigidity ratio"},
              "without a Shear rigidity: the contact is rigid across its normal", scene);
  if (in.given("Friction coefficient"))
    remark_on(in, section, {"Pad"}, "beside a Friction coefficient", scene);
  if (in.raw("Kind", "") == "rod")
    remark_on(in, section, {"Rotations", "Shear rigidity"},
              "with Kind = rod, which swings with the pipe", scene);
  if (std::any_of(scene.restraints.begin(), scene.restraints.end(),
                  [&](const Restraint &one) { return "Support " + one.name == section; }))
    remark_on(in, section, {"Rotations"}, "where nothing rubs", scene);
  if (in.raw("Ground motion", "").empty())
    remark_on(in, section, {"Ground motion time"}, "without a Ground motion", scene);
  if (!has_motion && number_of(in, "Restitution") > 0.)
    remark_on(in, section, {"Restitution"}, "without a transient step", scene);
}

/// What of creep a coefficient that is not there leaves without effect.
void remark_on_creep(const ParameterReader &in, const std::string &section, Scene &scene) {
  const bool secondary = number_of(in, "Creep coefficient") > 0.,
             primary = number_of(in, "Primary creep coefficient") > 0.;
  if (!secondary)
    remark_on(in, section, {"Creep exponent"}, "without a Creep coefficient", scene);
  if (!primary)
    remark_on(in, section, {"Primary creep exponent", "Primary time exponent", "Primary hardening"},
              "without a Primary creep coefficient", scene);
  if (!secondary && !primary)
    remark_on(in, section, {"Creep activation temperature", "Creep reference temperature"},
              "without a coefficient of creep", scene);
  else if (number_of(in, "Creep activation temperature") == 0.)
    remark_on(in, section, {"Creep reference temperature"},
              "without a Creep activation temperature", scene);
}

/// Corners of a route that are to be rounded, and at which it goes straight on.
void remark_on_straight_bends(const Pipe &pipe, Scene &scene) {
  constexpr double no_angle = 1e-9; // as PipePath has it [rad]
  for (unsigned int i = 1; i + 1 < pipe.route.size(); ++i) {
    const RoutePoint &point = pipe.route[i];
    const Vector3 before = point.position - pipe.route[i - 1].position,
                  after = pipe.route[i + 1].position - point.position;
    if (point.bend_radius > 0. && before * after > 0. &&
        cross_product_3d(before, after).norm() <= no_angle * before.norm() * after.norm())
      scene.remarks.push_back("Pipe " + pipe.name + ": the route goes straight on at point " +
                              (point.name.empty() ? std::to_string(i + 1) : point.name) +
                              ", where it has a bend, and there is none.");
  }
}

/// Entries of parts that another entry of the part leaves without effect.
void remark_on_parts(ParameterReader &in, const bool has_motion, Scene &scene) {
  for (const ParameterFile::Section &section : in.file().sections()) {
    const std::string &heading = section.heading, kind = heading.substr(0, heading.find(' '));
    in.enter(heading);
    if (kind == "Support")
      remark_on_support(in, heading, has_motion, scene);
    else if (kind == "Section") {
      constexpr double widest = 20.; // that anybody has built [m]
      const double diameter = number_of(in, "Outer diameter") * in.si("m");
      if (diameter > widest)
        scene.remarks.push_back(heading + ": its Outer diameter is " + to_text(diameter) +
                                " m. Entries are in m where Units does not say otherwise.");
      if (number_of(in, "Insulation") == 0.)
        remark_on(in, heading, {"Insulation density"}, "without Insulation", scene);
      else if (number_of(in, "Insulation density") == 0.)
        scene.remarks.push_back(heading +
                                ": its Insulation has no weight without an Insulation density.");
      remark_on_creep(in, heading, scene);
      if (scene.stress.code.empty() && number_of(in, "Corrosion allowance") > 0.)
        remark_on(in, heading, {"Corrosion allowance"}, "without a stress code", scene);
    } else if (kind == "Pipe") {
      const auto pipe = std::find_if(scene.pipes.begin(), scene.pipes.end(), [&](const Pipe &one) {
        return "Pipe " + one.name == heading;
      });
      if (pipe != scene.pipes.end())
        remark_on_straight_bends(*pipe, scene);
      if (scene.mesh.file.empty() && pipe != scene.pipes.end() && !pipe->has_bend())
        remark_on(in, heading, {"Bend flexibility", "Stiffening pressure"}, "without a bend",
                  scene);
    } else if (kind == "Spring") {
      const auto spring =
          std::find_if(scene.springs.begin(), scene.springs.end(),
                       [&](const Spring &one) { return "Spring " + one.name == heading; });
      if (spring != scene.springs.end() && spring->stiffness == Motion{} &&
          (!has_motion || spring->damping == Motion{}))
        scene.remarks.push_back(heading + " has no stiffness, and does nothing.");
      else if (!has_motion)
        remark_on(in, heading, {"Damping"}, "without a transient step", scene);
    } else if (kind == "Joint") {
      const auto joint =
          std::find_if(scene.joints.begin(), scene.joints.end(),
                       [&](const Joint &one) { return "Joint " + one.name == heading; });
      if (joint != scene.joints.end() &&
          std::min({joint->axial, joint->lateral, joint->bending, joint->torsion}) >= Joint::rigid)
        scene.remarks.push_back(heading + " is rigid in all its motions, and does nothing.");
    } else if (kind == "Hanger" && number_of(in, "Cold load") > 0.)
      remark_on(in, heading, {"Weight step"}, "beside a Cold load: the hanger is not sized", scene);
    else if (kind == "Mass" &&
             std::any_of(scene.masses.begin(), scene.masses.end(), [&](const PointMass &one) {
               return "Mass " + one.name == heading && one.mass == 0.;
             }))
      scene.remarks.push_back(heading + " is of 0 kg, and does nothing.");
    else if (kind == "Tee" && in.raw("Kind", "welding tee") != "reinforced")
      remark_on(in, heading, {"Pad"}, "but with Kind = reinforced", scene);
  }
}

/// Tables of the catalogue that no part has an item of.
void remark_on_catalogue(ParameterReader &in, Scene &scene) {
  bool hangers = false, constant = false, components = false;
  for (const ParameterFile::Section &section : in.file().sections()) {
    in.enter(section.heading);
    const bool is_hanger = section.heading.rfind("Hanger ", 0) == 0;
    const bool is_constant = is_hanger && in.text("Kind") == "constant";
    hangers = hangers || (is_hanger && !is_constant && in.given("Item"));
    constant = constant || (is_constant && in.given("Item"));
    components = components || (!is_hanger && in.given("Item"));
  }
  in.enter("Catalogue");
  if (!hangers)
    remark_on(in, "Catalogue", {"Hangers"}, "without a hanger that has an Item", scene);
  if (!constant)
    remark_on(in, "Catalogue", {"Constant hangers"}, "without a constant hanger that has an Item",
              scene);
  if (!components)
    remark_on(in, "Catalogue", {"Components"}, "without a pipe or mass that has an Item", scene);
}

/// Entries of sections that another section, or an entry that turns it on, leaves without effect.
void remark_on_sections(ParameterReader &in, Scene &scene) {
  const auto any = [&](const auto &is) {
    return std::any_of(scene.sections.begin(), scene.sections.end(), is);
  };
  if (!any([&](const Section &section) {
        in.enter("Section " + section.name);
        return has_creep(in);
      })) {
    in.enter("Solver");
    remark_on(in, "Solver", {"Creep tolerance"}, "without a section that creeps", scene);
  }
  if (!scene.continuum)
    for (const ParameterFile::Section &section : in.file().sections())
      if (section.heading == "Continuum" && !section.entries.empty())
        scene.remarks.push_back("Section Continuum is not used with Model = " +
                                std::string(row_of(model_kinds, scene.model).word) + ".");
  in.enter("Mesh");
  if (!scene.continuum && scene.mesh.file.empty()) {
    if (scene.mesh.arcs)
      remark_on(in, "Mesh", {"Cells per bend"}, "with Bends = arcs, each of which is one", scene);
    else if (!scene.has_bend())
      remark_on(in, "Mesh", {"Cells per bend"}, "without a bend", scene);
  }
  if (!any([](const Section &section) { return section.is_inelastic(); }))
    remark_on(in, "Mesh", {"Section points"}, "without a section that yields or creeps", scene);
  in.enter("Stress");
  if (scene.stress.code.empty())
    remark_on(in, "Stress",
              {"Code libraries", "Sustained", "Expansion", "Occasional", "Cycles factor", "Liberal",
               "Occasional factor"},
              "without a Code", scene);
  in.enter("Modes");
  if (scene.modal.n_modes == 0)
    remark_on(in, "Modes", {"Mass", "Step", "Friction"}, "without a Number of modes", scene);
  in.enter("Response");
  if (scene.spectra.empty())
    remark_on(in, "Response",
              {"Modes", "Directions", "Groups", "First", "Interpolation", "Damping", "Duration",
               "Missing mass", "Rigid part", "Rigid frequencies", "Write modes"},
              "without a Spectrum", scene);
}

/// What a body has no use of, though the file may have it.
void remark_on_body(ParameterReader &in, Scene &scene) {
  in.enter("");
  if (in.raw("Scene", "") != "body")
    return;
  for (const char *const entry : {"Friction multipliers", "Monitors"})
    if (in.given(entry))
      scene.remarks.push_back(std::string(entry) + " is not used with Scene = body.");
  in.enter("Output");
  if (scene.output.contact_problems)
    remark_on(in, "Output", {"Write contact problems"}, "with Scene = body", scene);
  in.enter("Body");
  remark_on(in, "Body", {"Torsional rigidity", "Patch radius"},
            "of a surface, whose nodes do not turn", scene);
  if (scene.continuum_settings.dimension == 2)
    remark_on(in, "Body", {"Shear rigidity ratio"}, "in the plane, across which nothing slides",
              scene);
  else
    remark_on(in, "Body", {"Plane", "Thickness"}, "in space", scene);
  if (number_of(in, "Pressure") > 0.)
    remark_on(in, "Body", {"Gap"}, "beside a Pressure, which presses from the start", scene);
}

} // namespace

bool has_creep(const ParameterReader &in) {
  return number_of(in, "Creep coefficient") > 0. || number_of(in, "Primary creep coefficient") > 0.;
}

void remark_on_unused(ParameterReader &in, Scene &scene) {
  const bool has_motion = std::any_of(scene.steps.begin(), scene.steps.end(),
                                      [](const LoadStep &step) { return step.transient; });
  if (has_motion)
    remark_on_integrator(in, scene);
  else {
    in.enter("Time");
    remark_on(in, "Time",
              {"Integrator", "Step", "Mass damping", "Stiffness damping", "Modal damping", "Modes"},
              "without a transient step", scene);
  }
  remark_on_parts(in, has_motion, scene);
  remark_on_sections(in, scene);
  remark_on_body(in, scene);
  remark_on_catalogue(in, scene);
  remark_on_initial(scene);
  remark_on_moved_points(scene);
  for (unsigned int l = 0; l < scene.loads.size(); ++l) {
    const auto names_it = [&](const LoadStep &step) {
      return std::any_of(step.loads.begin(), step.loads.end(),
                         [&](const auto &load) { return load.first == l; });
    };
    Load &load = scene.loads[l];
    if (std::none_of(scene.steps.begin(), scene.steps.end(), names_it)) {
      if (load.kind == Load::Kind::displacement)
        load.at.clear(); // or it would hold its points
      scene.remarks.push_back("Load " + load.name +
                              " is in the Loads of no step, and does nothing.");
    }
  }
}

} // namespace frictionbeam::parts
