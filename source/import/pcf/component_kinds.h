// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace frictionbeam::import {

/// What a component of a piping component file becomes.
enum class Shape {
  pipe,    ///< a straight run
  bend,    ///< an arc between two tangents that meet at CENTRE-POINT
  tee,     ///< a run with one or two branches at CENTRE-POINT
  olet,    ///< a branch on a pipe, at CENTRE-POINT
  reducer, ///< a cone from one bore to another
  rigid,   ///< a valve, a flange, an instrument: much stiffer than pipe, by CENTRE-POINT if given
  end,     ///< a cap, a blind flange: the line ends in it
  support, ///< what the user's table makes of it
  joint,   ///< a connection to what is not in the file
  none     ///< without mechanics: a weld, a text
};

struct ComponentKind {
  const char *word;
  Shape shape;
  bool may_be_point = false;      ///< its ends may be at one place
  const char *remark = nullptr;   ///< what is taken for granted of it
  const char *tee_kind = nullptr; ///< Tee/Kind of a branch
};

/// The kind of that word, in capitals; null if it is not known.
const ComponentKind *find_component_kind(const std::string &word);

} // namespace frictionbeam::import
