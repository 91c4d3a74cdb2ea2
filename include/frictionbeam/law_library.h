// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/law.h>

#include <map>
#include <string>
#include <vector>

namespace frictionbeam {

/**
 * Constitutive laws, each loaded from a shared library of its own and found by name. The laws that
 * come with the project and a user's own pass through the same door, load().
 *
 * The descriptions handed out live as long as the library object.
 */
class LawLibrary {
public:
  LawLibrary() = default;
  ~LawLibrary();
  LawLibrary(const LawLibrary &) = delete;
  LawLibrary &operator=(const LawLibrary &) = delete;

  /**
   * Load the law in the shared library @p file. Checked in this order: the library opens, it exports
   * `frictionbeam_law`, the interface version is equal, kind and sizes fit, the name is new, every
   * parameter has a unit and a meaning within its bounds, the reference is there. A library that is
   * loaded again is the same law.
   * @throws std::runtime_error saying what was found, what was expected and what to try.
   */
  const LawDescription &load(const std::string &file);

  /// Load every law that is installed beside this library (builtin_directory()).
  void load_builtin();

  /// The law called @p name. @throws std::runtime_error listing the laws that are loaded.
  const LawDescription &find(const std::string &name) const;

  /// Names of all loaded laws of one kind, in alphabetical order.
  std::vector<std::string> names(const LawKind kind) const;

  /// The folder of the laws that come with the project.
  static std::string builtin_directory();

private:
  std::map<std::string, const LawDescription *> laws;
  std::map<std::string, std::string> files; ///< by name of the law
  std::vector<void *> handles;
};

/// The default values of a law's parameters, in their order.
std::vector<double> default_parameters(const LawDescription &law);

/// Position of the parameter called @p name. @throws std::runtime_error naming those there are.
unsigned int parameter_index(const LawDescription &law, const std::string &name);

} // namespace frictionbeam
