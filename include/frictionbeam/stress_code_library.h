// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/stress_code.h>

#include <map>
#include <string>
#include <vector>

namespace frictionbeam {

/**
 * Stress codes, each loaded from a shared library of its own and found by name. Those that come
 * with the project and a user's own pass through the same door, load().
 *
 * The descriptions handed out live as long as the library object.
 */
class StressCodeLibrary {
public:
  StressCodeLibrary() = default;
  ~StressCodeLibrary();
  StressCodeLibrary(const StressCodeLibrary &) = delete;
  StressCodeLibrary &operator=(const StressCodeLibrary &) = delete;

  /**
   * Load the code in the shared library @p file. Checked in this order: the library opens, exports
   * `frictionbeam_stress_code`, was compiled for this version of the interface, has a name of its
   * own, an edition and a code.
   * @throws std::runtime_error saying what was found, what was expected and what to try.
   */
  const StressCodeDescription &load(const std::string &file);

  /// Load every code that is installed beside this library (builtin_directory()).
  void load_builtin();

  /// The code called @p name; null if there is none.
  const StressCodeDescription *find(const std::string &name) const;

  /// Names of all loaded codes, in alphabetical order.
  std::vector<std::string> names() const;

  /// The folder of the codes that come with the project.
  static std::string builtin_directory();

private:
  struct Entry {
    const StressCodeDescription *code;
    std::string file;
  };
  std::map<std::string, Entry> codes; ///< by name
  std::vector<void *> handles;
};

/**
 * What a code does at a place that no code may: factors, limits or stresses that are not finite or
 * negative, stresses that depend on the sign of a moment or are not convex in the forces. Tried at
 * forces up to those that reach the allowable stress. Empty: nothing was found.
 */
std::vector<std::string> stress_code_faults(const StressCodeDescription &code,
                                            const StressPoint &point, const StressRules &rules);

} // namespace frictionbeam
