// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/archive.h"
#include "model/unknowns/reduced_space.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <functional>

namespace frictionbeam {

/// K x = value M x, x with a largest entry of 1.
struct Eigenpair {
  double value = 0.; ///< square of the circular frequency [1/s2]
  Vector vector;

  void transfer(Archive &archive) { archive(value, vector); }
};

/**
 * Eigenpairs of K x = value M x next to a shift, by ARPACK through deal.II in shift-invert mode, by
 * value, their vectors as ARPACK scales them; none if it has not converged with @p n_vectors
 * Arnoldi vectors.
 * @param inverse of K - shift M
 */
std::vector<Eigenpair> arpack_eigenpairs(const Eigen::SparseMatrix<double> &M,
                                         const std::function<Vector(const Vector &)> &inverse,
                                         const double shift, const unsigned int n,
                                         const unsigned int n_vectors);

/// How many eigenvalues of K x = value M x are below @p value, by Sylvester's law of inertia.
unsigned int count_eigenvalues_below(const Eigen::SparseMatrix<double> &K,
                                     const Eigen::SparseMatrix<double> &M, const double value);

/**
 * The lowest eigenpairs of K x = w^2 M x, by value, K positive definite and M positive
 * semidefinite. Small problems, and those that ask for a large part of all pairs, go to Eigen's
 * dense solver, the others to ARPACK through deal.II in shift-invert mode; Sylvester's law of
 * inertia then counts the eigenvalues below the last one, so that none is missed.
 * @param factors of K
 * @return @p n pairs, or as many as M has rank
 * @throws UserError if ARPACK does not find them
 */
std::vector<Eigenpair>
lowest_eigenpairs(const Eigen::SparseMatrix<double> &K, const Eigen::SparseMatrix<double> &M,
                  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> &factors,
                  const unsigned int n);

} // namespace frictionbeam
