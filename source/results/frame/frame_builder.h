// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/line_pose.h"
#include "model/model.h"
#include "results/frame/cell_course.h"
#include "results/results.h"

#include <functional>
#include <optional>
#include <unordered_map>

namespace frictionbeam {

/// Turns a state of the analysis into what is reported: section forces, support forces, reactions.
class FrameBuilder {
public:
  /// @param both_sides nodes within a pipe always appear with the forces on either side, so that
  /// frames have equally many stations and can be combined; otherwise only where forces jump.
  explicit FrameBuilder(const Model &model, const bool both_sides = false);

  std::vector<RestraintInfo> restraint_infos() const;

  /// Displacements and section forces along the pipes, supports, reactions.
  Frame make(const LineState &state);
  /// The same of a state at rest that has accelerations of its own, of all degrees of freedom, and
  /// the mass of the scene's modes.
  Frame make(const LineState &state, const Vector &accelerations);

  /// Frame::line at rest: places and axes.
  std::vector<Station> stations();

  /// Frame::reactions alone, of linear cells, from those at the restraints. reaction() then knows
  /// the vertices of restraints and imposed motions.
  std::vector<Motion> reactions(const LineState &state);

  /// What acts together, of the frame of this state made last: first all supports, then at the
  /// places that quantities name. Of a pair the sum of both halves; of a point what holds it, in
  /// `on_pipe`; of several supports sizes, the normal forces in `fn`, friction forces in `ft1`.
  std::vector<SupportState> together(const LineState &state, const Frame &frame) const;
  /// The same by what a frame has alone, of a wall, whose points carry no other supports.
  std::vector<SupportState> together(const Frame &frame) const;
  /// Its place in Frame::together. @param of_all whether `name` are all of a repeated support's
  std::optional<std::size_t> place_of(const std::string &where, const bool of_all) const;

  /// Motion of a named point in global axes [m, rad].
  Motion motion(const LineState &state, const std::string &point) const;

  /// Velocity of a named point in global axes, also of one that loads move [m/s, rad/s].
  Motion velocity(const LineState &state, const std::string &point) const;

  /// Linear momentum (3) [kg m/s] and angular momentum about the origin (3) [kg m2/s], kinetic and
  /// stored energy of the line together [J].
  std::array<double, 7> momentum_and_energy(const LineState &state) const;

private:
  /// A place that a quantity asks for.
  struct Place {
    std::string where;
    bool of_all = false;                ///< that are repeated, or all there are
    std::vector<unsigned int> supports; ///< that act together; none: the point of this name
  };

  void find_places();
  using ForceAtPoint = std::function<Motion(unsigned int vertex, const std::string &name)>;
  std::vector<SupportState> sums_of(const Frame &frame, const ForceAtPoint &force_at) const;
  /// Force on a vertex [N, N m], global axes, of all that holds it.
  Motion force_on(const unsigned int vertex, const std::string &point, const LineState &state,
                  const Frame &frame) const;
  /// Force of restraints and imposed motions on a vertex, of the frame made last [N, N m]; 0 at
  /// others, where what is left of the forces is inertia.
  Motion reaction(const unsigned int vertex) const {
    return is_held[vertex] ? vertex_forces[vertex] : Motion{};
  }
  /// Force of a spring and its dashpot on its first point [N, N m].
  Motion spring_force(const LineState &state, const Spring &spring) const;

  /// A pipe cell at a restraint, or at a node that a load moves.
  struct HeldCell {
    unsigned int index = 0;
    std::array<unsigned int, 2> vertices{};
    std::vector<dealii::types::global_dof_index> dofs;
    PipeElement::Matrix12 stiffness, mass;
    std::vector<std::pair<unsigned int, PipeElement::Vector12>> loads; ///< those that it carries
  };

  void find_cells_at_restraints();
  /// What holds each restraint, by the forces at the vertices.
  std::vector<Motion> reactions_of_vertices(const LineState &state) const;
  /// @param pose of the state
  void add_pipe(const LineState &state, const Pose &pose, const unsigned int pipe,
                std::vector<Station> &line);
  void add_cell(const LineState &state, const Pose &pose, const unsigned int cell,
                std::vector<Station> &line);
  /// Nothing holds any vertex yet, and whether inertia is to be told of this state.
  void begin(const LineState &state);
  /// What forces M (a + alpha v) of a state in motion add to the course of a cell's section forces,
  /// of the cell that the element speaks of; zero at rest.
  /// @param back turns them into the axes of the stations' places
  CellCourse inertia_along(const LineState &state, const unsigned int index,
                           const Eigen::Matrix3d &back);
  /// The course of a cell's section forces in balance with those on its ends, which stand in the
  /// order of the deal.II cell.
  CellCourse in_balance(const unsigned int index, PipeElement::Vector12 ends) const;
  /// What is missing for that: in a solid part the weight of a bend's wall does not act on its
  /// axis, and on a cell that has become longer or shorter forces across it have another arm than
  /// at rest.
  CellCourse beside_line_force(const unsigned int index, const PipeElement::Vector12 &ends,
                               const CellLoad &load) const;
  /// a + alpha v of a degree of freedom, or what was given in place of it.
  double acceleration(const LineState &state, const dealii::types::global_dof_index dof) const;
  /// Mass that these accelerations act on, of a cell of which the element speaks.
  PipeElement::Matrix12 mass_of(const unsigned int index);
  /// Forces M a + C v of a state in motion on the nodes of restraints, of imposed motions too.
  void add_inertia(const LineState &state);
  /// Stations of a cell in a frame that has moved: section forces in the axes that turn with it.
  std::vector<Station> stations_in(const CellFrame &frame, const LineCells::CellState &of_cell,
                                   const Pose &pose, const unsigned int index, CellLoad load,
                                   const CellCourse &inertia);
  /// Give a station what it knows of the pipe there, with its local axes.
  void place(const PipeCell &pipe_cell, const LocalAxes &axes, Station &station) const;
  /// Add the first station of a cell, unless the line has it already. Where the forces jump (a
  /// support, a point load), a node appears with both sides.
  void begin_cell(const Station &first, std::vector<Station> &line) const;
  /// Stations of the cell that the element speaks of, as a linear one, along the route. The forces
  /// on its ends and their motions, beyond joints, stand in the order of the deal.II cell.
  /// @param inertia as inertia_along() has it
  std::vector<Station> stations_of(const unsigned int index, const PipeElement::Vector12 &ends,
                                   const PipeElement::Vector12 &motions, const CellLoad &load,
                                   const CellCourse &inertia);
  std::vector<Station> stations_of_arc(const PipeCell &pipe_cell, const PipeElement::Vector12 &ends,
                                       const PipeElement::Vector12 &motions, const CellLoad &load,
                                       const CellCourse &inertia) const;
  /// Motions inside a straight cell by those of its ends, at each station, in its local axes.
  using StationShapes = std::vector<Eigen::Matrix<double, 6, 12>>;
  const StationShapes &shapes_of(const Discretization::Cell &cell);
  void append(const std::vector<Station> &stations, std::vector<Station> &line) const;
  void add_vertex_forces(const LineState &state, const Pose &pose);

  const Model &model;
  const bool both_sides;
  std::vector<bool> is_held; ///< vertices of restraints and imposed motions
  PipeElement element;
  std::vector<HeldCell> held_cells;
  std::vector<Place> places;
  dealii::FEValues<1, 3> station_values;
  std::unordered_map<unsigned int, StationShapes> station_shapes; ///< of Discretization::like()
  std::vector<unsigned int> first_cell; ///< of each pipe, in Discretization::pipe_cells()
  std::vector<Motion> vertex_forces;    ///< what holds each vertex of the line
  bool tells_inertia = false;           ///< of the state at hand
  const Vector *given = nullptr;        ///< accelerations in place of that state's
};

} // namespace frictionbeam
