// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "import/import_pcf.h"

namespace frictionbeam {

/**
 * `frictionbeam import LINE.pcf`: write a parameter file of a piping component file, read and mesh
 * it as a run would, and list what was not understood on the standard error.
 * @return 0; what is wrong with the input is thrown as UserError
 */
int import_file(const import::ImportOptions &options);

} // namespace frictionbeam
