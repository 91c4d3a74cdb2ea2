// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/line/spring_extension.h"

#include "base/user_error.h"

namespace frictionbeam {

SpringExtension::SpringExtension(const Spring &spring, const unsigned int c, const LineMesh &mesh,
                                 const VertexDofs &vertex_dofs) {
  std::vector<double> list;
  const Motion &direction = spring.directions[c];
  for (const bool is_other : {false, true}) {
    const std::string &point = is_other ? spring.other : spring.point;
    for (unsigned int d = 0; d < 6 && !point.empty(); ++d) {
      if (direction[d] == 0.)
        continue;
      dofs.push_back(vertex_dofs.index(mesh.points.at(point), d));
      list.push_back(is_other ? -direction[d] : direction[d]);
      if (dofs.back() == dealii::numbers::invalid_dof_index)
        throw UserError("Spring " + spring.name +
                        " has a rotational stiffness or damping at a point without rotations. "
                        "Set it to 0.");
    }
  }
  weights = Eigen::Map<const Eigen::VectorXd>(list.data(), list.size());
}

} // namespace frictionbeam
