// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/file/body_vtu.h"
#include "results/file/output_file.h"

#include <deal.II/numerics/data_out.h>
#include <deal.II/numerics/data_postprocessor.h>

#include <sstream>

namespace frictionbeam {

using namespace dealii;

namespace {

/// Stress of plane or solid bodies, components xx, yy, xy (zz, yz, zx).
template <int dim>
class StressOutput : public DataPostprocessor<dim> {
public:
  explicit StressOutput(const LameConstants &lame) : lame(lame) {}

  std::vector<std::string> get_names() const override {
    if (dim == 2)
      return {"stress_xx", "stress_yy", "stress_xy"};
    return {"stress_xx", "stress_yy", "stress_xy", "stress_zz", "stress_yz", "stress_zx"};
  }
  UpdateFlags get_needed_update_flags() const override { return update_gradients; }
  std::vector<DataComponentInterpretation::DataComponentInterpretation>
  get_data_component_interpretation() const override {
    return std::vector<DataComponentInterpretation::DataComponentInterpretation>(
        get_names().size(), DataComponentInterpretation::component_is_scalar);
  }

  void evaluate_vector_field(const DataPostprocessorInputs::Vector<dim> &inputs,
                             std::vector<dealii::Vector<double>> &values) const override {
    for (unsigned int q = 0; q < values.size(); ++q) {
      const auto &g = inputs.solution_gradients[q];
      double trace = 0.;
      for (unsigned int d = 0; d < dim; ++d)
        trace += g[d][d];
      const auto stress = [&](const unsigned int i, const unsigned int j) {
        return (i == j ? lame.lambda * trace : 0.) + lame.mu * (g[i][j] + g[j][i]);
      };
      values[q][0] = stress(0, 0);
      values[q][1] = stress(1, 1);
      values[q][2] = stress(0, 1);
      if (dim == 3) {
        values[q][3] = stress(2, 2);
        values[q][4] = stress(1, dim - 1);
        values[q][5] = stress(dim - 1, 0);
      }
    }
  }

private:
  const LameConstants lame;
};

/// Where the pieces of a state are written.
struct StateFile {
  std::string folder, name;
  unsigned int rank, n_ranks;
  std::string piece(const unsigned int i) const {
    return name + (n_ranks > 1 ? "_" + std::to_string(i) : "") + ".vtu";
  }
};

/// Write one state, each process its part. @return the file that has, or knows, all of it
template <int dim>
std::string write_state(const ContinuumBody<dim> &body, const ContinuumState &state,
                        const DataPostprocessor<dim> &stress, const StateFile &file) {
  const std::vector<DataComponentInterpretation::DataComponentInterpretation> vector(
      dim, DataComponentInterpretation::component_is_part_of_vector);
  ContinuumVector traction = nodal_tractions(body, state);
  traction.update_ghost_values();
  DataOut<dim> out;
  out.attach_dof_handler(body.dof_handler);
  out.add_data_vector(state.displacement, std::vector<std::string>(dim, "displacement"),
                      DataOut<dim>::type_dof_data, vector);
  out.add_data_vector(state.displacement, stress);
  if (!body.continuum.contacts.empty())
    out.add_data_vector(traction, std::vector<std::string>(dim, "contact_traction"),
                        DataOut<dim>::type_dof_data, vector);
  out.build_patches(body.mapping, body.fe.degree,
                    body.mesh.manifolds.empty() ? DataOut<dim>::curved_boundary
                                                : DataOut<dim>::curved_inner_cells);
  std::ostringstream text; // deal.II has words of its own for a stream that fails
  out.write_vtu(text);
  write_file(file.folder + "/" + file.piece(file.rank), text.str());
  if (file.n_ranks == 1 || file.rank > 0)
    return file.piece(0);
  std::vector<std::string> pieces;
  for (unsigned int i = 0; i < file.n_ranks; ++i)
    pieces.push_back(file.piece(i));
  std::ostringstream record;
  out.write_pvtu_record(record, pieces);
  write_file(file.folder + "/" + file.name + ".pvtu", record.str());
  return file.name + ".pvtu";
}

} // namespace

template <int dim>
std::unique_ptr<DataPostprocessor<dim>> stress_of_body(const ContinuumBody<dim> &body) {
  return std::make_unique<StressOutput<dim>>(lame_constants(body.continuum));
}

template <int dim>
void write_body_vtu(const ContinuumBody<dim> &body, const std::vector<ContinuumState> &states,
                    const std::string &name, const StressOf<dim> &stress_of,
                    const std::string &folder) {
  std::vector<std::pair<double, std::string>> records;
  for (const ContinuumState &state : states)
    records.emplace_back(
        state.time, write_state(body, state, *stress_of(state),
                                {folder, name + "_" + std::to_string(state.step),
                                 this_process(body.communicator), n_processes(body.communicator)}));
  if (this_process(body.communicator) > 0)
    return;
  std::ostringstream text;
  DataOutBase::write_pvd_record(text, records);
  write_file(folder + "/" + name + ".pvd", text.str());
}

template std::unique_ptr<DataPostprocessor<2>> stress_of_body(const ContinuumBody<2> &);
template std::unique_ptr<DataPostprocessor<3>> stress_of_body(const ContinuumBody<3> &);
template void write_body_vtu<2>(const ContinuumBody<2> &, const std::vector<ContinuumState> &,
                                const std::string &, const StressOf<2> &, const std::string &);
template void write_body_vtu<3>(const ContinuumBody<3> &, const std::vector<ContinuumState> &,
                                const std::string &, const StressOf<3> &, const std::string &);

} // namespace frictionbeam
