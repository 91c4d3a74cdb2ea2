// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/scene.h"

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace frictionbeam {

/**
 * A stretch of a pipe whose wall is a solid, as the line sees it: a superelement on the motions q
 * of its sections at the line's vertices, six each, first to last: forces on the sections from
 * outside are K q - sum_l x_l f_l under loads of factors x_l. Pressure in it may stiffen it.
 */
struct SolidPart {
  /// What a pressure p in it adds to K and f_l, and forces that it exerts by itself besides.
  struct Pressed {
    /// Whether the part holds its own shape: known, not even with all of its sections held, or by
    /// what holds its sections, if at all, which the whole line's stiffness tells.
    enum class Stability { known, buckled, of_the_line };

    Eigen::MatrixXd stiffness, forces; ///< of loads in columns
    Eigen::VectorXd by_itself;         ///< [N, N m]
    Stability stability = Stability::known;
  };
  using Stability = Pressed::Stability;

  unsigned int pipe = 0, first_cell = 0; ///< in Scene::pipes, in the pipe's chain of cells
  std::vector<unsigned int> vertices;    ///< of the LineMesh, one more than cells
  Eigen::MatrixXd stiffness;             ///< K, global axes
  std::vector<Eigen::VectorXd> forces;   ///< f of each load at factor one [N, N m]
  /// Force and moment about its first vertex of each load at factor one on what lies between two
  /// vertices, by load and cell.
  std::vector<std::vector<Motion>> cell_loads;
  /// Of each load at factor one [Pa], and what such pressures do, valid until asked again; neither
  /// is there where they do not stiffen it.
  std::vector<double> pressures;
  std::function<const Pressed &(const double pressure)> pressed;

  /// In it, of those that stiffen it [Pa].
  double pressure(const std::vector<double> &factors) const {
    double sum = 0.;
    for (std::size_t l = 0; l < pressures.size(); ++l)
      sum += factors[l] * pressures[l];
    return sum;
  }

  bool has(const unsigned int of_pipe, const unsigned int cell) const {
    return of_pipe == pipe && cell >= first_cell && cell + 1 < first_cell + vertices.size();
  }
};

} // namespace frictionbeam
