// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/unknowns/restraint_forces.h"
#include "base/algebra/dense_algebra.h"
#include "model/unknowns/reduced_space.h"

#include <map>

namespace frictionbeam {

namespace {

/// A direction that one of the restraints holds.
struct Held {
  std::size_t restraint; ///< among the results
  Eigen::Matrix<double, 6, 1> direction;
};

} // namespace

std::vector<Motion> restraint_forces(const Scene &scene, const LineMesh &mesh,
                                     const std::function<Motion(const unsigned int)> &holding) {
  std::vector<Motion> result;
  std::map<unsigned int, std::vector<Held>> at; // vertices
  for (std::size_t i = 0; i < scene.restraints.size(); ++i)
    for (const Site &site : mesh.restraints[i]) {
      for (const dealii::Tensor<1, 6> &direction : held_directions(scene.restraints[i], site)) {
        Held held{result.size(), {}};
        for (unsigned int c = 0; c < 6; ++c)
          held.direction[c] = direction[c];
        at[site.vertex].push_back(held);
      }
      result.push_back({});
    }
  for (const auto &[vertex, all] : at) {
    Eigen::MatrixXd directions(6, all.size());
    for (std::size_t k = 0; k < all.size(); ++k)
      directions.col(k) = all[k].direction;
    const Motion force = holding(vertex);
    const Eigen::Map<const Eigen::Matrix<double, 6, 1>> f(force.data());
    // One restraint's are orthonormal.
    const Eigen::VectorXd shares = all.front().restraint == all.back().restraint
                                       ? Eigen::VectorXd(directions.transpose() * f)
                                       : Eigen::VectorXd(LeastSquares(directions).solve(f));
    for (std::size_t k = 0; k < all.size(); ++k)
      for (unsigned int c = 0; c < 6; ++c)
        result[all[k].restraint][c] += shares[k] * all[k].direction[c];
  }
  return result;
}

} // namespace frictionbeam
