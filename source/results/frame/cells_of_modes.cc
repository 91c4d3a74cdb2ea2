// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/frame/cells_of_modes.h"

#include <cmath>

namespace frictionbeam {

double frequency_error_of_cells(const Model &model, const Vector &motion,
                                const double angular_frequency) {
  const VertexDofs &dofs = model.discretization.vertex_dofs();
  const auto at = [&](const unsigned int vertex, const unsigned int first) {
    Vector3 result;
    for (unsigned int d = 0; d < 3; ++d)
      if (const auto dof = dofs.index(vertex, first + d); dof != dealii::numbers::invalid_dof_index)
        result[d] = motion[dof];
    return result;
  };
  double error = 0., lumped = 0.; // of the squared frequency; kinetic energy that lumping adds
  for (unsigned int i = 0; i < model.discretization.pipe_cells().size(); ++i) {
    const auto cell = model.discretization.pipe_cell(i);
    const Profile &profile = model.discretization.profiles()[cell->material_id()];
    const Vector3 way = cell->vertex(1) - cell->vertex(0);
    const double l = way.norm();
    const Vector3 t = way / l;
    double along[2];
    Vector3 across[2], slope[2];
    for (const unsigned int end : {0, 1}) {
      const Vector3 u = at(cell->vertex_index(end), 0);
      along[end] = u * t;
      across[end] = u - along[end] * t;
      slope[end] = dealii::cross_product_3d(at(cell->vertex_index(end), 3), t);
    }
    const Vector3 middle = (across[0] + across[1]) / 2. + l / 8. * (slope[0] - slope[1]);
    const double m = profile.mass, w2 = angular_frequency * angular_frequency,
                 bending = m * l / 6. *
                           (across[0].norm_square() + 4. * middle.norm_square() +
                            across[1].norm_square()),
                 stretching =
                     m * l / 3. * (along[0] * along[0] + along[0] * along[1] + along[1] * along[1]);
    error += bending * w2 * m * std::pow(l, 4) / (720. * profile.EI) +
             stretching * w2 * m * l * l / (12. * profile.EA);
    if (model.scene.modal.lumped)
      lumped += m * l / 2. *
                    (across[0].norm_square() + across[1].norm_square() + along[0] * along[0] +
                     along[1] * along[1]) -
                bending - stretching;
  }
  error = std::abs(error - lumped);
  return 1. - 1. / std::sqrt(1. + error);
}

} // namespace frictionbeam
