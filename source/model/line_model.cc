// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/line_model.h"

#include "mesh/build_line_mesh.h"
#include "model/contact/finite_rigidity.h"

#include <algorithm>

namespace frictionbeam {

bool has_transient_step(const Scene &scene) {
  return std::any_of(scene.steps.begin(), scene.steps.end(),
                     [](const LoadStep &step) { return step.transient; });
}

LineModel::LineModel(const Scene &scene, const LawLibrary &laws)
    : LineModel(scene, build_line_mesh(scene), laws) {}

LineModel::LineModel(const Scene &scene, LineMesh line_mesh, const LawLibrary &laws,
                     std::vector<SolidPart> parts)
    : mesh(std::move(line_mesh)), discretization(scene, mesh, laws),
      space(scene, mesh, discretization), contacts(scene, mesh, discretization, space, laws),
      linear(scene, mesh, discretization, space, contacts, has_transient_step(scene),
             std::move(parts)),
      cells(make_line_cells(scene, mesh, discretization, space, linear)),
      whole{scene, mesh, discretization, space, contacts, linear, *cells} {
  if (!scene.solver.is_exact() && scene.solver.has_tangent() && !has_transient_step(scene) &&
      cells->is_linear())
    make_rigid_contacts_finite(linear.stiffness(), contacts);
}

void LineModel::take_laws_of(const Scene &other) {
  for (unsigned int i = 0; i < contacts.size(); ++i)
    contacts.set_parameters(i,
                            other.supports[contacts[i].support].parameters_of(contacts[i].place));
}

} // namespace frictionbeam
