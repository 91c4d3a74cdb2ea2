// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/unused/unused_row.h"

namespace frictionbeam::unused {

namespace {

/// Whether some section of the file has one of these numbers above 0.
bool any_section_has(const Place &at, const std::vector<std::string> &entries) {
  return any(at.in.file().sections(), [&](const ParameterFile::Section &section) {
    return section.heading.rfind("Section ", 0) == 0 && any(entries, [&](const auto &entry) {
             const ParameterFile::Entry *const found = section.find(entry);
             double value = 0.;
             return found != nullptr && to_number(found->value, value) && value > 0.;
           });
  });
}

bool is_hanger(const std::string &heading) { return heading.rfind("Hanger ", 0) == 0; }

/// Whether a part has an item of the catalogue, of those whose heading and Kind are so.
template <typename Property>
bool any_has_item(const Place &at, const Property &is_so) {
  return any(at.in.file().sections(), [&](const ParameterFile::Section &section) {
    const ParameterFile::Entry *const kind = section.find("Kind");
    return section.find("Item") != nullptr &&
           is_so(section.heading, kind == nullptr ? "" : kind->value);
  });
}

} // namespace

const Rows &rows_of_settings() {
  static const Rows rows = {
      {"",
       {"Friction multipliers", "Monitors"},
       [](const Place &at) { return unless(!at.is_body(), at.with_model()); }},
      {"",
       {"Installation temperature"},
       [](const Place &at) {
         const bool has_heat = any(
             at.scene.loads, [](const Load &load) { return load.kind == Load::Kind::temperature; });
         return unless(has_heat || at.scene.yields(), "without a load of temperature");
       }},
      {"Output",
       {"Write contact problems", "Every increment", "Stations"},
       [](const Place &at) { return unless(!at.is_body() && !at.is_wall(), at.with_model()); }},
      {"Output",
       {"VTU frames"},
       [](const Place &at) { return unless(at.has_motion(), "without a transient step"); }},
      {"Catalogue",
       {"Hangers"},
       [](const Place &at) {
         return unless(any_has_item(at,
                                    [](const std::string &heading, const std::string &kind) {
                                      return is_hanger(heading) && kind != "constant";
                                    }),
                       "without a hanger that has an Item");
       }},
      {"Catalogue",
       {"Constant hangers"},
       [](const Place &at) {
         return unless(any_has_item(at,
                                    [](const std::string &heading, const std::string &kind) {
                                      return is_hanger(heading) && kind == "constant";
                                    }),
                       "without a constant hanger that has an Item");
       }},
      {"Catalogue",
       {"Components"},
       [](const Place &at) {
         return unless(any_has_item(at, [](const std::string &heading,
                                           const std::string &) { return !is_hanger(heading); }),
                       "without a pipe or mass that has an Item");
       }},
      {"Continuum",
       {},
       [](const Place &at) { return unless(at.scene.continuum.has_value(), at.with_model()); }},
      {"Continuum",
       {"Tolerance", "Fraction", "Max refinements", "Max unknowns"},
       [](const Place &at) {
         return unless(at.raw("Refinement", "adaptive") != "none", "with Refinement = none");
       }},
      {"Continuum",
       {"Cells"},
       [](const Place &at) {
         return unless(at.scene.mesh.file.empty(), "beside the File of section Mesh");
       }},
      {"Continuum",
       {"Dimension"},
       [](const Place &at) {
         return unless(at.scene_word() != "long bar", "with Scene = long bar, which is plane");
       }},
      {"Mesh",
       {"File"},
       [](const Place &at) {
         return unless(!at.is_body() || at.scene_word() == "body",
                       "with a Scene that makes its own mesh");
       }},
      {"Slab",
       {"Increments", "Poisson squeeze", "Shear lag"},
       [](const Place &at) { return unless(!at.is_body(), at.with_model()); }},
      {"Solid",
       {},
       [](const Place &at) {
         const bool has_wall = at.scene.is_solid() || at.scene.model == ModelKind::automatic ||
                               !solid_places(at.scene).empty();
         return unless(has_wall, at.with_model());
       }},
      {"Solid",
       {"Reach"},
       [](const Place &at) { return unless(!solid_places(at.scene).empty(), "without At"); }},
      {"Mesh",
       {"Cell length", "Mesher", "Bends", "Cells per bend", "Cells per reducer", "Refinements",
        "Section points"},
       [](const Place &at) { return unless(!at.is_body() && !at.is_wall(), at.with_model()); }},
      {"Mesh",
       {"Cell length", "Mesher", "Bends", "Cells per bend", "Cells per reducer", "Refinements"},
       [](const Place &at) { return unless(!at.scene.pipes.empty(), "without a pipe"); }},
      {"Mesh",
       {"Mesher"},
       [](const Place &at) {
         return unless(at.scene.mesh.file.empty(), "beside a File, which gmsh reads anyhow");
       }},
      {"Mesh",
       {"Bends", "Cells per bend"},
       [](const Place &at) {
         return !any(at.scene.pipes, has_bend)
                    ? std::string("without a bend")
                    : unless(
                          any(at.scene.pipes,
                              [&](const Pipe &pipe) { return has_bend_of_beams(at.scene, pipe); }),
                          "where all bends are solids");
       }},
      {"Mesh",
       {"Cells per bend"},
       [](const Place &at) {
         const bool has_chords = at.has_motion() && at.scene.kinematics == Kinematics::corotational;
         return unless(!at.scene.mesh.arcs || has_chords,
                       "with Bends = arcs, each of which is one");
       }},
      {"Mesh",
       {"Cells per reducer"},
       [](const Place &at) {
         return unless(any(at.scene.pipes, [](const Pipe &pipe) { return !!pipe.end_section; }),
                       "without a reducer");
       }},
      {"Mesh",
       {"Section points", "Refine hinges"},
       [](const Place &at) {
         return unless(
             any(at.scene.sections, [](const Section &one) { return one.is_inelastic(); }),
             "without a section that yields or creeps");
       }},
      {"Solver",
       {"Creep tolerance"},
       [](const Place &at) {
         return unless(any_section_has(at, {"Creep coefficient", "Primary creep coefficient"}),
                       "without a section that creeps");
       }},
      {"Solver",
       {"Contact tolerance"},
       [](const Place &at) { return unless(at.scene.solver.is_exact(), at.with_method()); }},
      {"Solver",
       {"Max iterations"},
       [](const Place &at) {
         return unless(at.scene.solver.method == SolverMethod::newton || !at.is_linear(),
                       at.with_method() + " of a line that neither yields nor turns");
       }},
      {"Solver",
       {"Max elastic iterations"},
       [](const Place &at) {
         return unless(at.scene.solver.method == SolverMethod::elastic, at.with_method());
       }},
      {"Time",
       {"Integrator", "Step", "Most steps", "Tolerance", "Output interval", "Beta", "Gamma",
        "Spectral radius", "Theta", "Mass damping", "Stiffness damping", "Modal damping", "Modes",
        "Modes tolerance"},
       [](const Place &at) { return unless(at.has_motion(), "without a transient step"); }},
      {"Time",
       {"Tolerance"},
       [](const Place &at) {
         return unless(!at.scene.time.is_exact(),
                       "with Integrator = " + std::string(at.scene.time.row().word) +
                           ", which is exact with any step");
       }},
      {"Time",
       {"Modes tolerance"},
       [](const Place &at) {
         const bool is_automatic =
             at.scene.time.reduction.modes == ReductionSettings::Modes::automatic;
         return unless(is_automatic, "without Modes = auto");
       }},
      {"Stress",
       {"Code libraries", "Sustained", "Expansion", "Occasional", "Cycles factor", "Liberal",
        "Occasional factor"},
       [](const Place &at) { return unless(!at.scene.stress.code.empty(), "without a Code"); }},
      {"Stress",
       {"Cycles factor", "Liberal"},
       [](const Place &at) {
         return unless(!at.scene.stress.expansion.empty(), "without an Expansion");
       }},
      {"Stress",
       {"Occasional factor"},
       [](const Place &at) {
         return unless(!at.scene.stress.occasional.empty(), "without an Occasional step");
       }},
      {"Modes",
       {"Mass", "Step", "Friction"},
       [](const Place &at) {
         return unless(at.scene.modal.n_modes > 0, "without a Number of modes");
       }},
      {"Modes",
       {"Friction"},
       [](const Place &at) {
         return unless(at.scene.spectra.empty(), "with a Spectrum: it is off");
       }},
      {"Response",
       {"Modes", "Directions", "Groups", "First", "Interpolation", "Damping", "Duration",
        "Missing mass", "Rigid part", "Rigid frequencies", "Write modes"},
       [](const Place &at) { return unless(!at.scene.spectra.empty(), "without a Spectrum"); }},
      {"Response",
       {"Damping"},
       [](const Place &at) {
         const SpectrumSettings &response = at.scene.response;
         return unless(response.modes == SpectrumSettings::Modes::cqc || response.is_double_sum(),
                       "but with Modes = cqc and double sums");
       }},
      {"Response",
       {"Duration"},
       [](const Place &at) {
         return unless(at.scene.response.is_double_sum(), "but with Modes = double sums");
       }},
      {"Response",
       {"Groups"},
       [](const Place &at) {
         return unless(
             any(at.scene.spectra, [](const Spectrum &one) { return !one.supports.empty(); }),
             "without a Spectrum of a group of Supports");
       }},
      {"Exact",
       {"Motion", "History", "Scale"},
       [](const Place &at) { return unless(!at.raw("At").empty(), "without At"); }},
      {"Quantities",
       {"Source"},
       [](const Place &at) {
         return unless(at.in.file().find("Quantities")->entries.size() > 1, "without a quantity");
       }},
      {"Study",
       {},
       [](const Place &at) {
         return unless(any(at.in.file().sections(),
                           [](const auto &one) { return one.heading.rfind("Vary ", 0) == 0; }),
                       "without a Vary");
       }},
  };
  return rows;
}

} // namespace frictionbeam::unused
