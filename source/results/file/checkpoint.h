// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/body/body.h"
#include "results/results.h"

#include <chrono>

namespace frictionbeam {

/// Raised whenever a transfer() goes through other values than before, so that what a build of an
/// other layout wrote is refused and not misread.
inline constexpr unsigned int checkpoint_layout = 18;

/**
 * The file `checkpoint.bin` in the folder of a run's results, from which the run goes on where it
 * was killed. It is written beside and renamed, so that at every moment there is a whole one. It
 * names its layout, the program, the parameter file, the options and a hash of the model's numbers,
 * of a body the number of processes as well, and is of no use to any other case.
 */
class Checkpoint {
public:
  explicit Checkpoint(const Model &model); ///< of a line
  template <int dim>
  explicit Checkpoint(const ContinuumBody<dim> &body);

  /// Whether the interval of wall time since the last one has passed.
  bool is_due() const;

  /// Put @p archive in the place of the last one. @throws UserError if it cannot be written.
  void write(const Archive &archive);

  /// The last one, to be read; none if there is no file.
  /// @throws UserError if it is damaged or of another case.
  std::optional<Archive> read() const;

  static bool is_in(const std::string &folder);
  static void remove(const std::string &folder);

private:
  using Identity = std::vector<std::pair<std::string, std::string>>; ///< what, and its text

  Checkpoint(const Scene &scene, const std::string &hash);
  /// Compare with what a file says of itself. @throws UserError
  void check(const Identity &found) const;

  const double interval; ///< [s]
  const std::string path;
  Identity identity;
  std::chrono::steady_clock::time_point last;
};

} // namespace frictionbeam
