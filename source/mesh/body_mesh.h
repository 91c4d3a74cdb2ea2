// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/scene.h"

#include <deal.II/grid/manifold.h>
#include <deal.II/grid/tria_description.h>

#include <map>
#include <memory>

namespace frictionbeam {

/// A body's first mesh: quadrilaterals or hexahedra, with the named parts of its boundary.
template <int dim>
struct ContinuumMesh {
  struct Face {
    std::vector<unsigned int> vertices; ///< sorted
    dealii::types::boundary_id part;
  };

  std::vector<dealii::Point<dim>> vertices;
  std::vector<dealii::CellData<dim>> cells; ///< consistently ordered for deal.II
  std::vector<Face> faces;                  ///< of named parts
  std::vector<std::string> parts;           ///< by boundary id - 1; id 0 is all the rest
  std::map<std::string, dealii::Point<dim>> points;
  /// By the cells' manifold id; none: all is flat.
  std::vector<std::unique_ptr<dealii::Manifold<dim>>> manifolds;
  unsigned int geometry_degree = 1; ///< of the cells
  std::vector<std::string> remarks; ///< on what of a file is hardly meant

  /// Id of a named part. @throws UserError that lists those there are.
  dealii::types::boundary_id part(const std::string &name) const;
};

/// Mesh the scene's box in equal cells, or read or mesh Mesh/File with gmsh. @throws UserError
template <int dim>
ContinuumMesh<dim> build_continuum_mesh(const Scene &scene);

} // namespace frictionbeam
