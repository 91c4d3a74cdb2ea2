// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/substructure/section_motion.h"
#include "analysis/substructure/wall_fields.h"
#include "mesh/solid/solid_stretches.h"
#include "model/body/wall_loads.h"
#include "model/line/solid_part.h"

namespace frictionbeam {

/// A stretch of a pipe as a scene of its own: one pipe, whose points are the line's vertices on it,
/// the loads that act on its metal, and the rests that press on its wall: those of which the patch
/// (Support/Width) lies on one straight run of the stretch, a diameter or more from an anchor, and
/// meets no patch of another.
struct StretchScene {
  StretchScene(const Scene &whole, const LineMesh &line, const SolidStretch &stretch);

  Scene scene;
  LineMesh line;
  std::vector<unsigned int> vertices; ///< of the whole line
  unsigned int first_cell = 0;        ///< of the whole pipe
  /// Forces and moments at points of each load at factor one, which act on the sections there: by
  /// load and vertex.
  std::vector<std::vector<Motion>> at_sections;
  /// Rests beside the stretch that bends would feel, and the Solid/Reach that takes them in.
  std::vector<std::string> near_rests;
  double wanted_reach = 0.;

private:
  void add_rests(const Scene &whole, const LineMesh &of, const SolidStretch &stretch);
};

/**
 * The wall of a stretch of a pipe as a solid, which the line joins at its vertices by
 * SectionMotion: N, V, M and T go through the section at either end without disturbance. One
 * factorization gives the displacement fields u_k of unit forces on all sections but one, and of
 * the loads; with the motions F of the sections in these fields, relative to that one, K = G^T F^-1
 * G,   G q = motions q relative to the reference, which is symmetric and leaves rigid motions
 * without forces. The reference is an end that an anchor holds, where the section is held as
 * Solid/Anchors says; else the last one, where forces balance all others.
 *
 * A rest within the stretch presses the wall oval, which bends some r sqrt(r/t) away feel. Its
 * force f along n is a pressure P on its patch, which moves the sections as W n f on its own would,
 * and by e f beside that, e those of the field of P - W n. Forces F^-1 e f do the same, and so does
 * the line's force f act along b = n + F^-1 e and the line's motion along n is b.q: K is symmetric
 * and positive still. Left out is how the wall gives way under the rest while no section moves, as
 * it is under the line's other rests; so e is taken along n of the rest's own section to be what no
 * force there belongs to.
 * Loads move the patch beside the section, too, by d, the work of P - W n on their field, and so
 * the line's motion along n is n.q + (F^-1 e).(q - U x) + d x, U x being the sections' motions.
 * Forces p at points act on sections, not on patches, though the line puts them on the same motion:
 * U gets F p and the line p less, which is the same without rests.
 * Widening is left out of P, e and d, as the line's other rests do not know it.
 *
 * Pressure that stiffens the wall makes all of this another one at each pressure (WallFields).
 * Forces through sections are effective ones still: each length of the wall with what the fluid in
 * it does to its bore and to two caps is in balance as it is turned.
 */
class WallStretch {
public:
  /// @throws UserError for a wall that cannot be meshed
  WallStretch(const Scene &whole, const LineMesh &line, const SolidStretch &stretch);

  /// What the line takes. Factors the stiffness.
  /// @param pressures in the pipe that there are [Pa], to which and between which those that
  /// stiffen the wall go
  SolidPart superelement(const std::vector<double> &pressures);
  /// The field that belongs to motions of the sections, six each, and loads. After superelement().
  ContinuumVector displacement(const Eigen::VectorXd &motions,
                               const std::vector<double> &factors) const;

  /// The section at a place of part.vertices among the wall's rings.
  unsigned int ring_of(const unsigned int section) const { return rings[section]; }

  /// Whether a ring is nearer than r sqrt(r/t) to a rest that stands as near as 1.5 times that to
  /// where the wall is cut, or beyond it: a free end gives way, and the oval there is too large.
  bool is_disturbed(const unsigned int ring) const;

  /// What pressure adds to the wall's stiffness; null: nothing.
  const PressureStiffness *pressure_stiffness() const { return stiffening.get(); }

  const SolidStretch stretch;
  const StretchScene own;
  PipeWall wall; ///< its s counts along the whole pipe
  const Scene body_scene;
  ContinuumBody<3> body;
  std::unique_ptr<const WallLoads> loads;

private:
  using Vector6 = SectionMotion::Vector6;
  using Matrix6 = Eigen::Matrix<double, 6, 6>;

  bool has_held_end() const { return stretch.anchored[0] || stretch.anchored[1]; }
  Point3 place(const unsigned int section) const { return wall.rings[rings[section]].centre; }
  /// Rigid motion of a section by that of the reference: columns of the latter.
  Matrix6 carried(const unsigned int section) const;
  /// Forces in balance: what is given, and the opposite of its resultant on the reference.
  ContinuumVector balanced(ContinuumVector forces, const Vector6 &resultant) const;
  /// Forces at points that act on sections, among those of unit forces, of each load (columns);
  /// zero without rests, where it is all the same.
  Eigen::MatrixXd on_sections() const;
  /// Find the fields of unit forces, loads and rests.
  void solve_fields(const std::vector<Vector6> &resultants, const std::vector<double> &pressures);
  /// Resultants of the loads on cells about the reference.
  std::vector<Vector6> resultants(const SolidPart &part) const;
  /// Motions of all sections but the reference relative to it.
  Eigen::VectorXd relative(const ContinuumVector &displacement) const;
  /// The same of several fields, a column each.
  Eigen::MatrixXd relative(const std::vector<ContinuumVector> &fields) const;
  /// n of a rest among relative motions.
  Eigen::VectorXd push(const unsigned int rest) const;
  /// B, columns of which are unit forces and the b of rests. @param stiffness F^-1
  /// @param of_rests relative motions in the fields of rests
  Eigen::MatrixXd directions(const Eigen::MatrixXd &stiffness,
                             const Eigen::MatrixXd &of_rests) const;
  /// G, motions to relative motions.
  Eigen::MatrixXd relation() const;
  /// Of each load at factor one: on what lies between sections.
  std::vector<std::vector<Motion>> cell_loads() const;

  /// All of it at one pressure.
  struct Condensed {
    double pressure;
    Eigen::MatrixXd fields;       ///< of forces, loads and rests (columns), by the basis of fields
    Eigen::MatrixXd inverse;      ///< (B^T F B)^-1
    Eigen::MatrixXd free_motions; ///< relative ones of each load (columns), those of rests with d
    bool holds = true;            ///< F is positive definite
  };
  Condensed condense(const double pressure) const;
  /// Forces on the sections of each load (columns).
  Eigen::MatrixXd forces(const Condensed &at) const;
  SolidPart::Pressed pressed(const double pressure) const;
  /// Factors of all loads, the pressure's own among them.
  Eigen::VectorXd load_factors(const std::vector<double> &factors) const;

  std::vector<unsigned int> rings; ///< of the sections
  unsigned int reference = 0;      ///< among them
  std::vector<SectionMotion> sections;
  std::unique_ptr<const PressureStiffness> stiffening;
  std::unique_ptr<const WallFields> fields; ///< of forces, loads and rests in the order of patches
  /// Of loads those of the scene and, where it stiffens, of the pressure by itself, which goes with
  /// its square.
  unsigned int n_forces = 0, n_loads = 0;
  Eigen::MatrixXd motions;      ///< relative ones of the basis of fields (columns)
  Eigen::MatrixXd rest_work;    ///< of P - W n of each rest (columns) on that basis (rows)
  Eigen::MatrixXd point_forces; ///< p of each load (columns)
  Eigen::MatrixXd on_reference; ///< resultants of each load on cells (columns)
  Condensed unpressed;
  std::optional<SolidPart::Pressed> last_pressed;
  double last_pressure = 0.;
};

} // namespace frictionbeam
