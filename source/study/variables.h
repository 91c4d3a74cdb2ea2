// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "study/sampling.h"
#include "study/varied_entries.h"

#include <functional>
#include <optional>

namespace frictionbeam::study {

/// One independent number of a study: entries of the file that get it.
struct Variable {
  std::string name;
  std::vector<VariedEntry> entries;
  /// By which a factor is multiplied to be a value, where that is the same for all entries.
  std::optional<double> of_all;
  unsigned int variation = 0; ///< the section Vary that it comes from, in the order of the file
};

/**
 * The variables of a study, made of the sections Vary. Each is given by its probability u between 0
 * and 1: a distribution's quantile, or of n values in a list the one at u n.
 */
class Variables {
public:
  /// @param file that the scene was read from, with the options --set
  /// @throws UserError for entries that cannot vary, or do so twice
  Variables(const Scene &scene, const ParameterFile &file, const LawLibrary &laws,
            const PlacesOfSupports &places, const Sampling &sampling);

  std::size_t size() const { return list.size(); }
  const Variable &operator[](const std::size_t i) const { return list[i]; }
  const Variation &variation(const std::size_t i) const { return variations[list[i].variation]; }

  /// Supports without friction, which no star gives any.
  const std::set<std::string> &without_friction() const { return frictionless; }

  /// The number at this probability, in the unit of the entry; of a list of words its place. A
  /// factor of entries that differ stays a factor.
  double value(const std::size_t i, const double u) const;
  /// The same as it stands in the file.
  std::string text(const std::size_t i, const double u) const;
  /// Options of --set that put such values, as numbers and texts, into the file.
  std::vector<std::string> settings(const std::vector<double> &values,
                                    const std::vector<std::string> &texts) const;

  /// Reads the scene with further options of --set.
  using Read = std::function<void(const std::vector<std::string> &)>;
  /// Try what a method takes of each section Vary: all of a list and of levels, else the outermost
  /// values and one between, which is not allowed where an entry is a whole number.
  /// @throws UserError that names the section, if an entry does not allow one of them
  void check(const Read &read, const StudyMethod method) const;

private:
  /// Of one section Vary alone.
  std::vector<std::string> settings_of(const unsigned int v, const double u) const;
  double quantile(const unsigned int v, const double u) const;

  std::vector<Variation> variations;
  std::vector<std::function<double(double)>> quantiles; ///< of each section Vary; none of a list
  std::vector<Variable> list;
  std::set<std::string> frictionless;
};

/// Probabilities of a variable's levels in a factorial design; of a list, of its values.
std::vector<double> levels_of(const Variation &variation);

/// "normal, mean 0.3, deviation 0.05, cut at 0.1 and 0.5", for a table.
std::string in_words(const Variation &variation);

} // namespace frictionbeam::study
