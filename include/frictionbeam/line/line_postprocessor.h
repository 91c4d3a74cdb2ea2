// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/line/line_stations.h>

#include <deal.II/base/thread_local_storage.h>
#include <deal.II/numerics/data_postprocessor.h>

#include <memory>
#include <string>
#include <vector>

namespace frictionbeam {

/**
 * Strains and section forces for DataOut<1, 3>, twelve scalars: eps, gamma_y, gamma_z, chi,
 * kappa_y, kappa_z, N, V_y, V_z, M_x, M_y, M_z, as those of a LineStation, in local axes.
 * Subdivisions of build_patches() show what is between the nodes.
 * @code
 *   const LinePostprocessor forces(points, increment);
 *   data_out.add_data_vector(dof_handler, solution, forces);
 * @endcode
 * Both arguments must outlive it, and assemble_line() must have seen the solution.
 */
class LinePostprocessor : public dealii::DataPostprocessor<3> {
public:
  LinePostprocessor(const LawPointData &points, const LineIncrement &increment);
  LinePostprocessor(const LawPointData &points, LineIncrement &&increment) = delete;

  void
  evaluate_vector_field(const dealii::DataPostprocessorInputs::Vector<3> &inputs,
                        std::vector<dealii::Vector<double>> &computed_quantities) const override;
  std::vector<std::string> get_names() const override;
  std::vector<dealii::DataComponentInterpretation::DataComponentInterpretation>
  get_data_component_interpretation() const override;
  dealii::UpdateFlags get_needed_update_flags() const override;

private:
  /// Shape functions of a thread, for as long as the elements stay the same objects.
  struct Kept {
    explicit Kept(const dealii::hp::FECollection<1, 3> &fes, const unsigned int n_points)
        : fes(fes), values(this->fes, n_points) {}

    const dealii::hp::FECollection<1, 3> fes; ///< the handler's own may go with its dofs
    LineValues values;
  };
  LineValues &values_for(const dealii::hp::FECollection<1, 3> &fes) const;

  mutable dealii::Threads::ThreadLocalStorage<std::shared_ptr<Kept>> kept;
  const LawPointData &points;
  const LineIncrement &increment;
};

} // namespace frictionbeam
