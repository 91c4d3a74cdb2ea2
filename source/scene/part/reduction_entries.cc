// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/part/parts.h"

#include <cmath>

namespace frictionbeam::parts {

namespace {
constexpr double usual_tolerance = 1e-3, share_of_accuracy = 0.1;
}

void declare_reduction(ParameterReader &in) {
  in.declare_text("Modes", "all", "all, auto, or a number",
                  "Reduction of transient steps to the nodes of the contacts and the lowest modes "
                  "of the line with these nodes held (Craig and Bampton), exact in statics. all: "
                  "nothing is reduced; auto: as many modes as Modes tolerance needs.");
  in.declare_number("Modes tolerance", 0., "-", 0., 0.5,
                    "Modes = auto: error of contact forces and monitored motions, relative, "
                    "against the line that is not reduced; 0: 1e-3, or a tenth of Accuracy where "
                    "that is demanded.");
}

void parse_reduction(const ParameterReader &in, Scene &scene) {
  using Modes = ReductionSettings::Modes;
  ReductionSettings &reduction = scene.time.reduction;
  const std::string modes = in.text("Modes");
  double number = 0.;
  if (modes == "auto")
    reduction.modes = Modes::automatic;
  else if (to_number(modes, number) && number >= 0. && number <= 1e6 &&
           number == std::floor(number)) {
    reduction.modes = Modes::number;
    reduction.n_modes = static_cast<unsigned int>(number);
  } else if (modes != "all")
    in.fail("Modes", "all, auto, or a number from 0 to 1000000", "'auto'");
  reduction.tolerance = in.number("Modes tolerance");
  if (reduction.tolerance == 0.)
    reduction.tolerance =
        scene.accuracy > 0. ? share_of_accuracy * scene.accuracy : usual_tolerance;
}

} // namespace frictionbeam::parts
