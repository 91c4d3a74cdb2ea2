// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/law.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace frictionbeam {

class LawInC;

/**
 * Constitutive laws, each loaded from a shared library of its own or linked in, and found by name.
 * The laws that come with the project and a user's own pass through the same door, load().
 *
 * The descriptions handed out live as long as the library object.
 */
class LawLibrary {
public:
  LawLibrary();
  ~LawLibrary();
  LawLibrary(const LawLibrary &) = delete;
  LawLibrary &operator=(const LawLibrary &) = delete;

  /**
   * Load the law in the shared library @p file, one in C++ (law.h) or in C (law_c.h). Checked in
   * this order: the library opens, it exports `frictionbeam_law` or `frictionbeam_law_c`, the
   * interface version is one that this program knows, kind and sizes fit, the name is new, every
   * parameter has a unit and a meaning within its bounds, the reference is there, a closed form has
   * its places within the state. A library that is loaded again is the same law. That a closed form
   * is integrate()'s own law, closed_form_faults() checks, for it depends on the parameters.
   * @throws std::runtime_error saying what was found, what was expected and what to try.
   */
  const LawDescription &load(const std::string &file);

  /**
   * Add a law that is linked into the program, which needs no shared library. It must outlive this.
   * Checked as load() does.
   */
  const LawDescription &add(const LawDescription &law);

  /// Load every law that is installed beside this library (builtin_directory()).
  void load_builtin();

  /// The law called @p name. @throws std::runtime_error listing the laws that are loaded.
  const LawDescription &find(const std::string &name) const;

  /// Names of all loaded laws of one kind, in alphabetical order.
  std::vector<std::string> names(const LawKind kind) const;

  /// The folder of the laws that come with the project.
  static std::string builtin_directory();

private:
  struct Entry {
    const LawDescription *law;
    std::string whence; ///< it is: loaded from a file, or linked in
  };

  /// @param function frictionbeam_law_c() of a library
  const LawDescription &take_law_in_c(void *function, const std::string &origin,
                                      const std::string &whence);
  /// @param origin, whence  of the law, as messages say it
  const LawDescription &take(const LawDescription &law, const std::string &origin,
                             const std::string &whence);

  std::map<std::string, Entry> laws; ///< by name
  std::vector<void *> handles;
  std::vector<std::unique_ptr<LawInC>> laws_in_c;
};

/// The default values of a law's parameters, in their order.
std::vector<double> default_parameters(const LawDescription &law);

/**
 * The default values, but for those given by name:
 * law_parameters(law, {{"Friction coefficient", 0.3}}).
 * @throws std::runtime_error naming the parameters there are, or the bounds of one.
 */
std::vector<double> law_parameters(const LawDescription &law,
                                   const std::map<std::string, double> &values);

/// Position of the parameter called @p name. @throws std::runtime_error naming those there are.
unsigned int parameter_index(const LawDescription &law, const std::string &name);

} // namespace frictionbeam
