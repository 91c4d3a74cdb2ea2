// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <string>

namespace frictionbeam {

/// What a child process may take.
struct ChildLimits {
  double seconds = 100.; ///< of computing
  double bytes = 8e9;    ///< of addresses, those of this process included
};

/// What became of it.
struct ChildEnd {
  std::string text;    ///< what the task returned
  std::string trouble; ///< why it did not return, such as "was ended by the system (Aborted)"
};

/**
 * Carry out @p task in a child process, a copy of this one, and wait for it. For libraries that
 * believe what damaged files say, and may end the process or overwrite its memory: here they do it
 * to the child. What the task changes is lost, but for the files that it writes.
 *
 * @param task must throw nothing but std::bad_alloc
 */
ChildEnd run_in_child(const std::function<std::string()> &task, const ChildLimits &limits = {});

} // namespace frictionbeam
