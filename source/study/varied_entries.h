// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/file/parameter_file.h"
#include "scene/scene.h"
#include <frictionbeam/law_library.h>

#include <map>
#include <set>

namespace frictionbeam::study {

/// Number of places of each support that has a law, by its name in the file.
using PlacesOfSupports = std::map<std::string, unsigned int>;

/// An entry of the file that gets a number of a study.
struct VariedEntry {
  std::string path;   ///< "Section/Entry", as of --set
  double factor = 1.; ///< by which the number is multiplied: what the file says, or 1
};

/// End the study for a section Vary.
[[noreturn]] void refuse_variation(const Variation &variation, const std::string &read,
                                   const std::string &allowed, const std::string &hint);

/// Finds what the paths of a study stand for.
class VariedEntries {
public:
  VariedEntries(const Scene &scene, const ParameterFile &file, const LawLibrary &laws,
                const PlacesOfSupports &places)
      : scene(scene), file(file), laws(laws), places(places) {}

  /// The entries that a path stands for, each place of a support on its own if that is asked for.
  /// @throws UserError for what cannot vary
  std::vector<VariedEntry> of(const Variation &variation, const std::string &path) const;
  /// Supports without friction that a star has not taken.
  const std::set<std::string> &without_friction() const { return left_out; }

private:
  static bool is_friction(const std::string &entry);
  /// Whether it has friction, at one of its places at least.
  bool slides(const FrictionSupport &support) const;
  /// All friction supports that have the entry, for a star: but for those without friction, as
  /// rods, where it is a coefficient of friction.
  std::vector<std::string> headings(const Variation &variation, const std::string &path) const;
  bool has_parameter(const FrictionSupport &support, const std::string &entry) const;
  int parameter(const FrictionSupport &support, const std::string &entry) const;
  const FrictionSupport *support_of(const std::string &heading) const;
  /// A support, or one of its places, as in "Support rests.3".
  struct Place {
    const FrictionSupport *support; ///< null: the heading is of no such support
    unsigned int number;            ///< from 1 on; 0: all of them
  };
  Place place_of(const std::string &heading) const;
  void refuse_place_beyond(const Variation &variation, const std::string &heading,
                           const std::string &path) const;
  bool varies_by_itself(const std::string &heading, const std::string &entry) const;
  bool is_given(const std::string &heading, const std::string &entry) const;
  unsigned int n_places(const std::string &heading, const std::string &entry) const;
  /// In the file's units.
  double value_in_file(const Variation &variation, const std::string &heading,
                       const std::string &entry) const;

  const Scene &scene;
  const ParameterFile &file;
  const LawLibrary &laws;
  const PlacesOfSupports &places;
  mutable std::set<std::string> left_out;
};

} // namespace frictionbeam::study
