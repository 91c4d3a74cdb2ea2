// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

/// A steel pipe of 4 m from A, where it is clamped, to B: what scenes of tests begin with.
inline const std::string small_bar = R"(
subsection Material steel
end
subsection Section round
  set Outer diameter = 0.1
  set Wall = 0.005
end
subsection Pipe bar
  set Route = A 0 0 0; B 4 0 0
end
subsection Support anchor
  set Kind = anchor
  set At = A
end
)";
