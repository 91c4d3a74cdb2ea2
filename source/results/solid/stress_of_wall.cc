// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/solid/solid_files.h"

#include <deal.II/numerics/data_postprocessor.h>

namespace frictionbeam {

using namespace dealii;

namespace {

/// Stress of the wall, and what von Mises makes of it.
class WallStressOutput : public DataPostprocessor<3> {
public:
  WallStressOutput(const WallLoads &loads, const ContinuumBody<3> &body,
                   const std::vector<double> &factors) {
    for (unsigned int p = 0; p < body.continuum.materials.size(); ++p) {
      lame.push_back(lame_constants(body.continuum, p));
      free_strain.push_back(loads.free_strain(p, factors));
    }
  }

  std::vector<std::string> get_names() const override {
    return {"stress_xx", "stress_yy", "stress_xy", "stress_zz", "stress_yz", "stress_zx", "mises"};
  }
  UpdateFlags get_needed_update_flags() const override { return update_gradients; }
  std::vector<DataComponentInterpretation::DataComponentInterpretation>
  get_data_component_interpretation() const override {
    return std::vector<DataComponentInterpretation::DataComponentInterpretation>(
        get_names().size(), DataComponentInterpretation::component_is_scalar);
  }

  void evaluate_vector_field(const DataPostprocessorInputs::Vector<3> &inputs,
                             std::vector<dealii::Vector<double>> &values) const override {
    const unsigned int pipe = inputs.get_cell<3>()->material_id();
    for (unsigned int q = 0; q < values.size(); ++q) {
      Tensor<2, 3> gradient;
      for (unsigned int d = 0; d < 3; ++d)
        gradient[d] = inputs.solution_gradients[q][d];
      const SymmetricTensor<2, 3> s = WallLoads::stress(lame[pipe], gradient, free_strain[pipe]);
      values[q][0] = s[0][0];
      values[q][1] = s[1][1];
      values[q][2] = s[0][1];
      values[q][3] = s[2][2];
      values[q][4] = s[1][2];
      values[q][5] = s[2][0];
      values[q][6] = std::sqrt(1.5) * deviator(s).norm();
    }
  }

private:
  std::vector<LameConstants> lame;
  std::vector<double> free_strain;
};

} // namespace

std::unique_ptr<DataPostprocessor<3>> stress_of_wall(const WallLoads &loads,
                                                     const ContinuumBody<3> &body,
                                                     const std::vector<double> &factors) {
  return std::make_unique<WallStressOutput>(loads, body, factors);
}

} // namespace frictionbeam
