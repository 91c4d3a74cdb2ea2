// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "member.h"

#include <map>
#include <set>

namespace oracle {

using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

/// Section of a scene as it stands at a part of a reducer.
struct Figures {
  double area, inertia, torsion, shear, radius, wall, added, insulation;
};

/// Where a support stands.
struct Place {
  int node;
  Vec tangent;       ///< of the pipe; at a point, of what runs through it
  double share = 1.; ///< of a bed: metres of pipe that fall to it
};

/// One piece of a pipe between places that need a node.
struct Piece {
  double from, to;
  std::size_t curve;
  bool arc;
  int cells;
};

/**
 * A scene as members between nodes, with six motions each: geometry, matrices and load vectors, all
 * dense. Held motions are taken out by an orthonormal basis at each node.
 */
class Frame {
public:
  explicit Frame(const Scene &scene);

  int node_of(const std::string &point) const { return point_node.at(point); }
  const std::vector<Vec> &positions() const { return nodes; }
  std::vector<Place> places(const Support &support) const;
  bool turns(int node) const; ///< has rotations, which points that no pipe reaches have not
  int n() const { return 6 * static_cast<int>(nodes.size()); }

  const Matrix &stiffness() const { return K; }
  Matrix mass(bool lumped) const;
  const Matrix &free_basis() const { return basis; } ///< motions that nothing holds, by columns
  Vector load_vector(const std::vector<Real> &factors) const; ///< the last is of the hangers
  Vector imposed(const std::vector<Real> &factors) const;     ///< motions of held nodes

  /// What the supports must give for the motions @p d to be in equilibrium.
  Vector residual(const Vector &d, const std::vector<Real> &factors) const;

  /// Section forces and motion at a place on a pipe; at a node where they jump, of both sides.
  std::vector<Member::At> at(int pipe, double s, const Vector &d,
                             const std::vector<Real> &factors) const;
  std::vector<Vec12> end_forces(const Vector &d, const std::vector<Real> &factors) const;
  Six spring_force(const Spring &spring, const Vector &d) const;

  /// Directions that a support holds exactly, orthonormal.
  static std::vector<Vec6> held(const Support &support, const Place &place);

private:
  int node_at(const Vec &position);
  void lay_pipe(int pipe, const std::vector<double> &breaks);
  std::vector<double> breaks_of(int pipe) const;
  double bed_cell(int pipe, double from, double to) const; ///< longest on a bed there; 0: none
  Vec tangent_of(int pipe, int node) const;                ///< at a corner, of its bisector
  /// Through a point that all pipes, but for a tee's branch, meet at: along the one that goes
  /// straight on, or the two that do so together. 0: several do, or none.
  Vec run_through(int node) const;
  Figures figures_of(const Member &member) const;
  void give_section(Member &member) const;
  void add_joints();
  void assemble();
  void hold();
  MemberLoad load_on(const Member &member, const std::vector<Real> &factors) const;
  Vec12 motions(const Member &member, const Vector &d) const;

  const Scene &scene;
  std::vector<Path> paths;
  std::vector<Vec> nodes;
  std::vector<Member> members;
  std::map<std::string, int> point_node;
  std::vector<std::vector<std::pair<double, int>>> on_pipe; ///< nodes along each pipe
  Matrix K, basis;
};

/// Of a standard size, by the table in inches or in mm.
Figures figures(const Section &section, bool in_inches);
Figures between(const Section &begin, const Section &end, double part, bool in_inches);
double modulus(const Material &material);
double thermal_strain(const Material &material, double from, double to);
double bend_flexibility(const Pipe &pipe, const Figures &section, const Material &material,
                        double radius);
/// Horizontal and across a direction: the local y axis of a pipe in this direction.
Vec across(const Vec &tangent);

} // namespace oracle
