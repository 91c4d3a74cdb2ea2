// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/body/held_section.h"

#include <deal.II/dofs/dof_tools.h>

#include <map>
#include <set>

namespace frictionbeam {

using namespace dealii;

void hold_section(const MappingQ<3> &mapping, const DoFHandler<3> &dof_handler,
                  const HeldSection &section, AffineConstraints<double> &constraints) {
  constexpr double in_plane = 1e-6, of_radius = 1.01;
  std::map<types::global_dof_index, Point<3>> places;
  DoFTools::map_dofs_to_support_points(mapping, dof_handler, places);
  std::vector<types::global_dof_index> dofs(dof_handler.get_fe().n_dofs_per_cell());
  std::set<types::global_dof_index> done;
  for (const auto &cell : dof_handler.active_cell_iterators()) {
    if (cell->is_artificial())
      continue;
    cell->get_dof_indices(dofs);
    for (unsigned int i = 0; i < dofs.size(); ++i) {
      const unsigned int node = dof_handler.get_fe().system_to_component_index(i).second;
      if (dof_handler.get_fe().system_to_component_index(i).first > 0)
        continue;
      const Tensor<1, 3> arm = places.at(dofs[i]) - section.centre;
      if (std::abs(arm * section.normal) > in_plane * section.radius ||
          arm.norm() > of_radius * section.radius || !done.insert(dofs[i]).second)
        continue;
      const Tensor<1, 3> out = arm / arm.norm();
      unsigned int largest = 0;
      for (unsigned int d = 1; d < 3; ++d)
        if (std::abs(out[d]) > std::abs(out[largest]))
          largest = d;
      const auto dof_of = [&](const unsigned int d) {
        return dofs[dof_handler.get_fe().component_to_system_index(d, node)];
      };
      for (unsigned int d = 0; d < 3; ++d)
        if (!(section.breathes && d == largest)) {
          constraints.add_line(dof_of(d));
          if (section.breathes) // u = w out
            constraints.add_entry(dof_of(d), dof_of(largest), out[d] / out[largest]);
        }
    }
  }
}

} // namespace frictionbeam
