// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/file/choice.h"

#include <deal.II/base/point.h>

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

/**
 * @file
 * The scene as a two- or three-dimensional body of linear elastic material with friction on parts
 * of its boundary, plain data in SI units. Parts of the boundary are called by name: physical
 * curves (2D), surfaces (3D) or points of a mesh, or `x0 x1 y0 y1 z0 z1` for the sides of a box.
 */
namespace frictionbeam {

/// A box from the origin, meshed by equal cells.
struct ContinuumBox {
  std::array<double, 3> size{{1., 1., 1.}}; ///< [m]
  std::array<unsigned int, 3> cells{{1, 1, 1}};
};

/// Stress on a part of the boundary, at a load factor of one.
struct ContinuumTraction {
  std::string part;
  dealii::Tensor<1, 3> vector; ///< [Pa]
  double pressure = 0.;        ///< against the outward normal [Pa]
};

/// Displacements held at zero on a part, or at a point.
struct ContinuumHold {
  std::string part;
  std::array<bool, 3> fixed{};
};

/// A cross-section of a pipe whose wall is held; of a breathing one, all but along its radii.
struct HeldSection {
  dealii::Point<3> centre;
  dealii::Tensor<1, 3> normal; ///< unit
  double radius = 0.;          ///< outer [m]
  bool breathes = false;
};

struct ElasticMaterial {
  double youngs_modulus = 0., poissons_ratio = 0.; ///< [Pa], -
};

/// Of a surface round a straight pipe the nodes near one direction, pressed by a flat foundation.
struct ContinuumPatch {
  std::array<dealii::Tensor<1, 3>, 3> axes; ///< outward normal of the foundation's plane, t1, t2
  dealii::Point<3> centre;                  ///< on the pipe's axis
  dealii::Tensor<1, 3> tangent, outward;    ///< unit: along the pipe, to the patch's middle
  double least_cosine = 0.;                 ///< of the angle from the middle

  bool has(const dealii::Point<3> &place) const {
    const dealii::Tensor<1, 3> arm = place - centre, across = arm - (arm * tangent) * tangent;
    return across * outward >= least_cosine * across.norm();
  }
};

/**
 * A surface on a foundation with friction. The law is one of kind `support`: its rigidities are
 * those of the friction elements, 1 m long, on one square metre, so that ES is the normal stiffness
 * [Pa/m] and GS the tangential one.
 */
struct ContinuumContact {
  std::string part, law;
  std::vector<double> parameters;
  std::optional<double> pressure; ///< [Pa] that presses the surface on, from the start; else
                                  ///< unilateral contact
  std::optional<ContinuumPatch> patch = {};
};

/// One step: the factors of the loads go there from those before in equal increments.
struct ContinuumStep {
  std::string name;
  double factor = 1.; ///< of the tractions, which are one load
  unsigned int n_increments = 1;
  std::vector<double> factors = {}; ///< of several loads; empty: `factor` alone

  std::vector<double> load_factors() const {
    return factors.empty() ? std::vector<double>{factor} : factors;
  }
};

struct ContinuumQuantity {
  enum class Kind {
    displacement,      ///< component at a point
    mean_displacement, ///< component averaged over a part
    axial_force,       ///< compression across the section at x [N]
    slip_length,       ///< of the slipping zone of a surface that begins at its lower end of the
                       ///< coordinate in which it extends furthest; in a plane along it [m]
    open_end,          ///< coordinate up to which the surface is open from there [m]
    slip_end,          ///< coordinate beyond which it sticks [m]
    sum_normal,        ///< force of the foundation, normal [N]
    sum_friction       ///< and tangential, its size [N]
  };
  std::string name;
  Kind kind = Kind::displacement;
  std::string where; ///< point or part
  unsigned int component = 0;
  double x = 0.;
  std::optional<double> reference;
  std::string source;
};

/// Words of plane problems: whether strains across the plane are zero.
inline constexpr Word<bool> plane_kinds[] = {{"stress", false}, {"strain", true}};

/// What the scene is as a continuum.
struct ContinuumScene {
  unsigned int dimension = 2;
  bool plane_strain = false; ///< else plane stress, in 2D
  double thickness = 1.;     ///< [m], in 2D
  double youngs_modulus = 0., poissons_ratio = 0.;
  std::vector<ElasticMaterial> materials; ///< by the cells' material id; empty: the one above
  std::vector<HeldSection> sections;
  std::optional<ContinuumBox> box; ///< else Mesh/File
  std::map<std::string, dealii::Point<3>> points;
  std::vector<ContinuumTraction> tractions;
  std::vector<ContinuumHold> holds;
  std::vector<ContinuumContact> contacts;
  std::vector<ContinuumStep> steps;
  std::vector<ContinuumQuantity> quantities;
};

/// How it is discretized and solved (section Continuum).
struct ContinuumSettings {
  enum class Refinement { adaptive, uniform, none } refinement = Refinement::adaptive;
  enum class LinearSolver {
    automatic,
    direct,
    amg,
    multigrid
  } linear_solver = LinearSolver::automatic;
  unsigned int degree = 3;
  unsigned int cells = 2;  ///< across the height of a box
  double tolerance = 1e-3; ///< relative, of every quantity
  double fraction = 0.8;   ///< of the squared error estimate that the cells to refine hold
  unsigned int max_refinements = 20, max_unknowns = 200000, increments = 1, dimension = 2;
};

} // namespace frictionbeam
