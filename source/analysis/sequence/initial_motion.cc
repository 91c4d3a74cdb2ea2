// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/sequence/load_sequence.h"

#include <algorithm>

namespace frictionbeam {

using namespace dealii;

void LoadSequence::set_initial_motion(const bool displaced) {
  const VertexDofs &dofs = model.discretization.vertex_dofs();
  for (const InitialCondition &initial : model.scene.initial) {
    std::vector<unsigned int> vertices;
    for (const std::string &point : initial.points)
      vertices.push_back(model.mesh.points.at(point));
    for (unsigned int p = 0; p < model.mesh.pipes.size(); ++p)
      if (std::count(initial.pipes.begin(), initial.pipes.end(), model.scene.pipes[p].name) > 0)
        vertices.insert(vertices.end(), model.mesh.pipes[p].vertices.begin(),
                        model.mesh.pipes[p].vertices.end());
    const auto at = [&](Motion motion, const unsigned int vertex) {
      if (initial.about.empty())
        return motion;
      const Vector3 arm =
          model.mesh.vertices[vertex] - model.mesh.vertices[model.mesh.points.at(initial.about)];
      const Vector3 turned = cross_product_3d(Vector3({motion[3], motion[4], motion[5]}), arm);
      for (unsigned int d = 0; d < 3; ++d)
        motion[d] += turned[d];
      return motion;
    };
    for (const unsigned int vertex : vertices) {
      const Motion displacement = at(initial.displacement, vertex),
                   velocity = at(initial.velocity, vertex);
      for (unsigned int c = 0; c < 6; ++c)
        if (const auto dof = dofs.index(vertex, c); dof != numbers::invalid_dof_index)
          for (const auto &term : model.space.terms(dof)) {
            if (displaced)
              current.unknowns[term.unknown] = displacement[c];
            current.velocity[term.unknown] = velocity[c];
          }
    }
  }
}

} // namespace frictionbeam
