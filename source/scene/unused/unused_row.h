// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/file/parameter_reader.h"
#include "scene/scene.h"
#include "scene/solid/mixed_entries.h"

#include <algorithm>
#include <string>
#include <vector>

/// @file Rows of the two tables that say which entries a scene does not use, and why.
namespace frictionbeam::unused {

/// A section of the file, as it is asked whether it uses its entries.
struct Place {
  const ParameterReader &in; ///< within the section
  const Scene &scene;
  const std::string &heading;

  std::string raw(const std::string &entry, const std::string &otherwise = "") const {
    return in.raw(entry, otherwise);
  }
  /// The number that the file gives for an entry; 0 where it gives none.
  double number(const std::string &entry) const {
    double value = 0.;
    return to_number(raw(entry, "0"), value) ? value : 0.;
  }
  bool is_on(const std::string &entry) const {
    const std::string word = raw(entry, "false");
    return word == "true" || word == "yes" || word == "on";
  }
  bool has_motion() const {
    return std::any_of(scene.steps.begin(), scene.steps.end(),
                       [](const LoadStep &step) { return step.transient; });
  }
  bool has_modes() const { return scene.modal.n_modes > 0 || !scene.spectra.empty(); }
  bool is_body() const { return scene.continuum && scene.model == ModelKind::continuum; }
  /// Whether cells answer by more than a matrix, so that statics iterate on them.
  bool is_linear() const { return scene.kinematics == Kinematics::linear && !scene.yields(); }
  /// Whether all that is solved are walls of pipes.
  bool is_wall() const { return scene.model == ModelKind::solid; }
  /// The kind of scene, as the file names it.
  std::string scene_word() const {
    const ParameterFile::Entry *const given = in.file().find("")->find("Scene");
    return given == nullptr ? "" : given->value;
  }
  std::string with_model() const {
    return "with Model = " + std::string(row_of(model_kinds, scene.model).word);
  }
  std::string with_method() const {
    return "with Method = " + std::string(scene.solver.row().word);
  }
  /// The scene's part of the section; null if it has become another one.
  template <typename Part>
  const Part *part(const std::vector<Part> &parts) const {
    const std::string name = heading.substr(heading.find(' ') + 1);
    const auto found =
        std::find_if(parts.begin(), parts.end(), [&](const Part &one) { return one.name == name; });
    return found == parts.end() ? nullptr : &*found;
  }
};

/// No reason if it is used.
inline std::string unless(const bool is_used, const std::string &why) { return is_used ? "" : why; }

template <typename Items, typename Property>
bool any(const Items &items, const Property &property) {
  return std::any_of(items.begin(), items.end(), property);
}

/// Whether a pipe has a bend, of its route or as a curve of a mesh file.
inline bool has_bend(const Pipe &pipe) { return pipe.has_bend() || pipe.bend_radius > 0.; }

/// Whether a pipe has a bend that Solid/At leaves to beams.
inline bool has_bend_of_beams(const Scene &scene, const Pipe &pipe) {
  const std::vector<std::string> places = solid_places(scene);
  const auto is_solid = [&](const std::string &place) {
    return std::count(places.begin(), places.end(), place) > 0;
  };
  return !is_solid(all_bends) &&
         (pipe.bend_radius > 0. || any(pipe.route, [&](const RoutePoint &point) {
            return point.bend_radius > 0. && !is_solid(point.name);
          }));
}

/// Entries of sections of a kind, and why a scene that has them does not use them: nothing if it
/// does. Of several rows that have an entry the first one with a reason is said.
struct Row {
  std::string kind;                 ///< of sections; empty: outside of any
  std::vector<std::string> entries; ///< empty: the whole section
  std::string (*why_not)(const Place &at);
};

using Rows = std::vector<Row>;

const Rows &rows_of_parts();
const Rows &rows_of_settings();

} // namespace frictionbeam::unused
