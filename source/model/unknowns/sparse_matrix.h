// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/contact/matrix.h>

namespace frictionbeam {

using contact::add_to;
using contact::SparseMatrix;
using contact::Vector;

} // namespace frictionbeam
