// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/file/output_file.h"
#include "results/solid/solid_files.h"

#include <deal.II/numerics/data_out.h>
#include <deal.II/numerics/data_postprocessor.h>

#include <sstream>

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
      const SymmetricTensor<2, 3> s =
          WallLoads::stress(lame[pipe], gradient, free_strain[pipe]);
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

std::string write_wall_state(const WallLoads &loads, const ContinuumBody<3> &body,
                             const ContinuumState &state, const std::string &folder) {
  const unsigned int rank = this_process(body.communicator),
                     n_ranks = n_processes(body.communicator);
  const std::vector<DataComponentInterpretation::DataComponentInterpretation> vector(
      3, DataComponentInterpretation::component_is_part_of_vector);
  const WallStressOutput stress(loads, body, state.factors);
  ContinuumVector traction = nodal_tractions(body, state);
  traction.update_ghost_values();
  DataOut<3> out;
  out.attach_dof_handler(body.dof_handler);
  out.add_data_vector(state.displacement, std::vector<std::string>(3, "displacement"),
                      DataOut<3>::type_dof_data, vector);
  out.add_data_vector(state.displacement, stress);
  out.add_data_vector(traction, std::vector<std::string>(3, "contact_traction"),
                      DataOut<3>::type_dof_data, vector);
  out.build_patches(body.mapping, body.fe.degree, DataOut<3>::curved_inner_cells);
  const std::string name = "solid_" + std::to_string(state.step);
  const auto piece = [&](const unsigned int i) {
    return name + (n_ranks > 1 ? "_" + std::to_string(i) : "") + ".vtu";
  };
  std::ostringstream text; // deal.II has words of its own for a stream that fails
  out.write_vtu(text);
  write_file(folder + "/" + piece(rank), text.str());
  if (n_ranks == 1 || rank > 0)
    return piece(0);
  std::vector<std::string> pieces;
  for (unsigned int i = 0; i < n_ranks; ++i)
    pieces.push_back(piece(i));
  std::ostringstream record;
  out.write_pvtu_record(record, pieces);
  write_file(folder + "/" + name + ".pvtu", record.str());
  return name + ".pvtu";
}

} // namespace

void write_wall_vtu(const WallLoads &loads, const ContinuumBody<3> &body,
                    const std::vector<ContinuumState> &states, const std::string &folder) {
  std::vector<std::pair<double, std::string>> records;
  for (const ContinuumState &state : states)
    records.emplace_back(state.time, write_wall_state(loads, body, state, folder));
  if (this_process(body.communicator) > 0)
    return;
  std::ostringstream text;
  DataOutBase::write_pvd_record(text, records);
  write_file(folder + "/solid.pvd", text.str());
}

} // namespace frictionbeam
