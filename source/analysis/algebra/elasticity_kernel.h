// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace frictionbeam {

/// As many cells as are taken at once, their numbers side by side.
constexpr unsigned int n_lanes = 4;
using Lanes = double __attribute__((vector_size(n_lanes * sizeof(double))));

/// The same in vectors: as template arguments attributes are dropped, and alignment with them.
struct StoredLanes {
  Lanes lanes;
};

/// Lagrange polynomials of one direction, and those through the points of the quadrature.
struct Polynomials1D {
  unsigned int n = 0;            ///< nodes, and points of Gauss' formula
  std::vector<double> values;    ///< of polynomial i at point q, [q * n + i]
  std::vector<double> slopes;    ///< of the polynomial that is one at point j, at q, [q * n + j]
  std::vector<double> gradients; ///< of polynomial i at point q, [q * n + i]
  std::vector<double> weights;   ///< of the points
};

/// For elements of some degree with Gauss-Lobatto nodes.
Polynomials1D polynomials_of_degree(const unsigned int degree);

/**
 * The product of linear elasticity's stiffness and a vector, hexahedron by hexahedron, with no
 * matrix: values and gradients at the points of Gauss' formula by sums direction after direction
 * (S. A. Orszag, J. Comput. Phys. 37 (1980) 70-92; M. Kronbichler, K. Kormann, Comput. Fluids 63
 * (2012) 135-147). Some 60 n^4 + 110 n^3 multiplications a cell with n nodes per direction, where
 * its matrix has 9 n^6 entries. In batches of n_lanes cells; with AVX2 where the processor has it.
 */
class ElasticHexahedra {
public:
  /// Degrees that there is code for.
  static constexpr unsigned int highest_degree = 6;

  /// One cell: its dofs' places in the vectors, by component and then node, x fastest, and at each
  /// point (or once, where it is the same at all) the inverse Jacobian, row by row, and the
  /// determinant.
  struct Cell {
    std::vector<unsigned int> dofs;
    std::vector<double> geometry;
    double lambda = 0., mu = 0.;
  };

  explicit ElasticHexahedra(const unsigned int degree);

  /// Cells that follow each other share a batch if they are alike in having a constant Jacobian.
  void add(const Cell &cell);
  /// After the last cell.
  void close() { flush(); }

  /// y += K x
  void multiply_add(const double *x, double *y) const;
  /// d += diagonal of K
  void diagonal_add(double *d) const;

  std::size_t n_batches() const { return batches.size(); }

private:
  struct Batch {
    std::size_t geometry; ///< where it begins
    unsigned int stride;  ///< from point to point: 0 or 10
    Lanes lambda, mu;
  };

  void flush();

  const Polynomials1D polynomials;
  std::vector<Batch> batches;
  std::vector<unsigned int> dofs; ///< by batch, component, node and lane
  std::vector<StoredLanes> geometry;
  std::vector<Cell> waiting; ///< of a batch that is not full
};

} // namespace frictionbeam
