// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "mesh/line_mesh.h"
#include "model/unknowns/cell_matrices.h"
#include "model/unknowns/profile.h"
#include <frictionbeam/fe_friction_beam.h>
#include <frictionbeam/law_library.h>
#include <frictionbeam/line_triangulation.h>
#include <frictionbeam/vertex_dofs.h>

#include <deal.II/hp/fe_collection.h>

namespace frictionbeam {

/// Joints at the two ends of a pipe cell, in the order of its deal.II vertices.
struct CellJoints {
  dealii::Tensor<2, 6> flexibility[2]; ///< relative motion per force and moment, global axes
  dealii::Tensor<1, 6> thrust[2];      ///< free relative motion per pressure [1/Pa]
};

/// A cell of a pipe.
struct PipeCell {
  unsigned int pipe = 0, position = 0; ///< place in Scene::pipes and in the pipe's chain
  bool reversed = false;               ///< its vertices stand against the route's direction
};

/// A friction element: which support, which of its sites, and its two vertices.
struct SupportCell {
  unsigned int support = 0, site = 0;
  std::array<unsigned int, 2> vertices{}; ///< pipe, ground
  /// From the pipe to the ground, unit length: not from the vertices where the scene gives it, so
  /// that two elements face to face are opposite to the last digit.
  Vector3 axis;
  double length = 0.; ///< of the friction element [m]
};

/**
 * The line in terms of deal.II: triangulation, finite elements, degrees of freedom. Pipe cells come
 * first in the user's numbering, then friction elements, then the cells that carry free points held
 * by springs alone. The plugin is used through its public headers, as any program would.
 */
class Discretization {
public:
  enum class CellKind { pipe, support, carrier };
  struct CellInfo {
    CellKind kind = CellKind::pipe;
    unsigned int index = 0; ///< in pipe_cells() or support_cells()
  };
  using Cell = dealii::DoFHandler<1, 3>::active_cell_iterator;

  Discretization(const Scene &scene, const LineMesh &mesh, const LawLibrary &laws);

  const dealii::DoFHandler<1, 3> &dof_handler() const { return dofs; }
  const dealii::hp::FECollection<1, 3> &elements() const { return fe; }
  const VertexDofs &vertex_dofs() const { return *dofs_at_vertex; }
  const std::vector<Point3> &vertices() const { return points; }
  unsigned int n_line_vertices() const { return n_own; } ///< the rest are ground
  /// Whether a point of the line has the rotation @p axis: all that a pipe reaches have; others
  /// have those alone that a spring resists or a load imposes.
  bool turns(const unsigned int vertex, const unsigned int axis) const {
    return rotations[vertex][axis];
  }
  const std::vector<Profile> &profiles() const { return sections; }
  const std::vector<PipeCell> &pipe_cells() const { return pipes; }
  const std::vector<SupportCell> &support_cells() const { return supports; }

  /// The exact arc of a pipe cell in the direction of its deal.II cell, if it is one.
  std::optional<ArcBeam> arc(const Cell &cell) const;

  /// Joints of a pipe cell; null if it has none.
  const CellJoints *joints(const Cell &cell) const {
    const auto found = cell_joints.find(cell->active_cell_index());
    return found == cell_joints.end() ? nullptr : &found->second;
  }

  /// The first straight pipe cell of the same section and length as this one, lengths being equal
  /// but for rounding.
  Cell like(const Cell &cell) const { return at(first_like[info(cell).index]); }

  /// A place for what PipeElement has evaluated, for all that ask this line: one thread at a time.
  KeptMatrices &kept_matrices() const { return kept; }

  /// What the active cell is.
  const CellInfo &info(const Cell &cell) const { return infos[cell->active_cell_index()]; }
  /// The active cell of a pipe cell, and of a friction element.
  Cell pipe_cell(const unsigned int index) const { return at(index); }
  Cell support_cell(const unsigned int index) const { return at(pipes.size() + index); }

private:
  Cell at(const unsigned int author_index) const;
  /// The finite elements of pipes, of supports and of what carries free points.
  void add_elements(const Scene &scene);
  /// What the triangulation's cells are, and their elements.
  void take_cells(const Scene &scene, const std::vector<CellOrigin> &origins);
  void add_profiles(const Scene &scene, const LineMesh &mesh, const LawLibrary &laws);
  void add_supports(const Scene &scene, const LineMesh &mesh);
  void add_joints(const Scene &scene, const LineMesh &mesh);
  void add_carriers(const Scene &scene, const LineMesh &mesh);
  void find_rotations(const Scene &scene, const LineMesh &mesh);
  unsigned int element_index(const FrictionSupport &support, const bool reversed) const;

  dealii::Triangulation<1, 3> triangulation;
  dealii::hp::FECollection<1, 3> fe;
  dealii::DoFHandler<1, 3> dofs;
  std::unique_ptr<const VertexDofs> dofs_at_vertex;

  std::vector<Point3> points;
  unsigned int n_own = 0;
  std::vector<std::array<bool, 3>> rotations; ///< of the line's vertices
  std::vector<Profile> sections;
  std::vector<LineCell> cells;
  std::vector<unsigned int> fe_index; ///< of each author's cell
  std::vector<PipeCell> pipes;
  std::vector<unsigned int> first_like; ///< by pipe cell
  std::vector<SupportCell> supports;
  unsigned int first_option = 1;                  ///< fe before it: pipes
  std::map<unsigned int, CellJoints> cell_joints; ///< by active cell index
  std::vector<CellInfo> infos;                    ///< by active cell index
  std::vector<unsigned int> cell_level_index;     ///< of each author's cell
  std::vector<std::pair<FE_FrictionBeam::Rotations, bool>>
      options; ///< of the friction elements in fe
  mutable KeptMatrices kept;
};

/// Stiffness of a straight pipe over that of the bend, by the pipe's rule.
double bend_flexibility(const Pipe &pipe, const Section &section, const Material &material,
                        const double bend_radius);

/// A direction of the scene at a place of the line, as a unit vector.
/// @throws UserError naming @p part if it follows the pipe and there is none.
Vector3 resolve(const Direction &direction, const Vector3 &tangent, const std::string &part);

} // namespace frictionbeam
