// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/statics/linear_statics.h"
#include "analysis/statics/nonlinear_statics.h"

namespace frictionbeam {

std::unique_ptr<Statics> make_statics(const Model &model) {
  if (model.cells.is_linear())
    return std::make_unique<LinearStatics>(model);
  return std::make_unique<NonlinearStatics>(model);
}

} // namespace frictionbeam
