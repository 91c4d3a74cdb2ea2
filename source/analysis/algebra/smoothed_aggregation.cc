// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/algebra/smoothed_aggregation.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {

using Matrix = SmoothedAggregation::Matrix;

constexpr int most_at_bottom = 800;
constexpr unsigned int most_levels = 12;
constexpr double weak = 0.02; ///< coupling of two nodes, relative to their own, that is left out

/// Which nodes each is strongly coupled to, by the norms of the blocks; rows of a graph.
struct Graph {
  std::vector<int> begin, neighbours;
};

std::vector<int> node_of_unknown(const std::vector<int> &node_begin) {
  std::vector<int> node(node_begin.back());
  for (std::size_t i = 0; i + 1 < node_begin.size(); ++i)
    std::fill(node.begin() + node_begin[i], node.begin() + node_begin[i + 1], int(i));
  return node;
}

Graph strong_couplings(const Matrix &A, const std::vector<int> &node_begin) {
  const int n = node_begin.size() - 1;
  const std::vector<int> node = node_of_unknown(node_begin);
  std::vector<int> place(n, -1);
  std::vector<double> own(n, 0.);
  Graph all;
  std::vector<double> squares;
  all.begin.push_back(0);
  for (int i = 0; i < n; ++i) {
    for (int row = node_begin[i]; row < node_begin[i + 1]; ++row)
      for (Matrix::InnerIterator entry(A, row); entry; ++entry) {
        const int j = node[entry.col()];
        if (place[j] < all.begin.back()) {
          place[j] = all.neighbours.size();
          all.neighbours.push_back(j);
          squares.push_back(0.);
        }
        squares[place[j]] += entry.value() * entry.value();
      }
    if (place[i] >= all.begin.back())
      own[i] = std::sqrt(squares[place[i]]);
    all.begin.push_back(all.neighbours.size());
  }
  Graph strong;
  strong.begin.push_back(0);
  for (int i = 0; i < n; ++i) {
    for (int k = all.begin[i]; k < all.begin[i + 1]; ++k) {
      const int j = all.neighbours[k];
      if (j != i && squares[k] > weak * weak * own[i] * own[j])
        strong.neighbours.push_back(j);
    }
    strong.begin.push_back(strong.neighbours.size());
  }
  return strong;
}

/// Aggregate of each node: first whole neighbourhoods, then what lies beside one, then the rest.
std::vector<int> aggregates(const Graph &graph, int &n_aggregates) {
  const int n = graph.begin.size() - 1;
  std::vector<int> aggregate(n, -1);
  n_aggregates = 0;
  const auto neighbours = [&](const int i, const auto &visit) {
    for (int k = graph.begin[i]; k < graph.begin[i + 1]; ++k)
      visit(graph.neighbours[k]);
  };
  for (int i = 0; i < n; ++i) {
    bool is_free = aggregate[i] < 0;
    neighbours(i, [&](const int j) { is_free = is_free && aggregate[j] < 0; });
    if (!is_free)
      continue;
    aggregate[i] = n_aggregates;
    neighbours(i, [&](const int j) { aggregate[j] = n_aggregates; });
    ++n_aggregates;
  }
  const std::vector<int> first = aggregate;
  for (int i = 0; i < n; ++i)
    neighbours(i, [&](const int j) {
      if (aggregate[i] < 0 && first[j] >= 0)
        aggregate[i] = first[j];
    });
  for (int i = 0; i < n; ++i) {
    if (aggregate[i] >= 0)
      continue;
    aggregate[i] = n_aggregates;
    neighbours(i, [&](const int j) {
      if (aggregate[j] < 0)
        aggregate[j] = n_aggregates;
    });
    ++n_aggregates;
  }
  return aggregate;
}

/// The modes, aggregate by aggregate, made orthonormal; coarse_modes are what they are of these.
Matrix tentative_prolongation(const std::vector<int> &aggregate, const int n_aggregates,
                              const std::vector<int> &node_begin, const Eigen::MatrixXd &modes,
                              std::vector<int> &coarse_begin, Eigen::MatrixXd &coarse_modes) {
  std::vector<std::vector<int>> unknowns(n_aggregates);
  for (std::size_t i = 0; i < aggregate.size(); ++i)
    for (int k = node_begin[i]; k < node_begin[i + 1]; ++k)
      unknowns[aggregate[i]].push_back(k);
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<Eigen::MatrixXd> parts;
  coarse_begin.assign(1, 0);
  for (const std::vector<int> &own : unknowns) {
    Eigen::MatrixXd local(own.size(), modes.cols());
    for (std::size_t k = 0; k < own.size(); ++k)
      local.row(k) = modes.row(own[k]);
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(local);
    int rank = 0; // what differs by rounding only is no function of its own
    const int most = std::min(local.rows(), local.cols());
    while (rank < most && std::abs(qr.matrixR()(rank, rank)) > 1e-8 * std::abs(qr.maxPivot()))
      ++rank;
    const Eigen::MatrixXd Q = qr.householderQ() * Eigen::MatrixXd::Identity(local.rows(), rank);
    for (std::size_t k = 0; k < own.size(); ++k)
      for (int c = 0; c < rank; ++c)
        entries.emplace_back(own[k], coarse_begin.back() + c, Q(k, c));
    parts.push_back(Q.transpose() * local);
    coarse_begin.push_back(coarse_begin.back() + rank);
  }
  coarse_modes.resize(coarse_begin.back(), modes.cols());
  for (std::size_t i = 0; i < parts.size(); ++i)
    coarse_modes.middleRows(coarse_begin[i], parts[i].rows()) = parts[i];
  Matrix P(node_begin.back(), coarse_begin.back());
  P.setFromTriplets(entries.begin(), entries.end());
  return P;
}

} // namespace

void SmoothedAggregation::invert_blocks(Level &level) {
  level.inverses.clear();
  const std::vector<int> &begin = level.node_begin;
  for (std::size_t i = 0; i + 1 < begin.size(); ++i) {
    const int n = begin[i + 1] - begin[i];
    Eigen::MatrixXd block = Eigen::MatrixXd::Zero(n, n);
    for (int row = 0; row < n; ++row)
      for (Matrix::InnerIterator entry(level.matrix, begin[i] + row); entry; ++entry)
        if (entry.col() >= begin[i] && entry.col() < begin[i + 1])
          block(row, entry.col() - begin[i]) = entry.value();
    const Eigen::MatrixXd inverse =
        Eigen::LDLT<Eigen::MatrixXd>(block).solve(Eigen::MatrixXd::Identity(n, n));
    level.inverses.insert(level.inverses.end(), inverse.data(), inverse.data() + n * n);
  }
}

void SmoothedAggregation::sweep(const Level &level, Eigen::VectorXd &x, const Eigen::VectorXd &b,
                                const bool backward) {
  const std::vector<int> &begin = level.node_begin;
  const int n_nodes = begin.size() - 1;
  const int *const starts = level.matrix.outerIndexPtr(), *const columns =
                                                              level.matrix.innerIndexPtr();
  const double *const values = level.matrix.valuePtr();
  const double *inverse = level.inverses.data() + (backward ? level.inverses.size() : 0);
  std::vector<double> left(16);
  for (int k = 0; k < n_nodes; ++k) {
    const int i = backward ? n_nodes - 1 - k : k, first = begin[i], n = begin[i + 1] - first;
    if (backward)
      inverse -= n * n;
    if (n > int(left.size()))
      left.resize(n);
    for (int row = 0; row < n; ++row) {
      double sum = b[first + row];
      for (int e = starts[first + row]; e < starts[first + row + 1]; ++e)
        sum -= values[e] * x[columns[e]];
      left[row] = sum;
    }
    for (int column = 0; column < n; ++column)
      for (int row = 0; row < n; ++row)
        x[first + row] += inverse[column * n + row] * left[column];
    if (!backward)
      inverse += n * n;
  }
}

SmoothedAggregation::SmoothedAggregation(Matrix matrix, std::vector<int> node_begin,
                                         Eigen::MatrixXd modes) {
  while (matrix.rows() > most_at_bottom && levels.size() < most_levels) {
    Level level;
    level.matrix = std::move(matrix);
    level.node_begin = std::move(node_begin);
    invert_blocks(level);
    int n_aggregates;
    const std::vector<int> aggregate =
        aggregates(strong_couplings(level.matrix, level.node_begin), n_aggregates);
    std::vector<int> coarse_begin;
    Eigen::MatrixXd coarse_modes;
    const Matrix rigid = tentative_prolongation(aggregate, n_aggregates, level.node_begin, modes,
                                                coarse_begin, coarse_modes);
    if (rigid.cols() == 0 || rigid.cols() > 0.8 * rigid.rows()) { // does not get coarser
      matrix = std::move(level.matrix);
      break;
    }
    // Smoothed once by D^-1 A, whose largest eigenvalue is taken from powers.
    std::vector<Eigen::Triplet<double>> entries;
    const double *inverse = level.inverses.data();
    for (std::size_t i = 0; i + 1 < level.node_begin.size(); ++i) {
      const int first = level.node_begin[i], n = level.node_begin[i + 1] - first;
      for (int column = 0; column < n; ++column)
        for (int row = 0; row < n; ++row)
          entries.emplace_back(first + row, first + column, *inverse++);
    }
    Matrix by_blocks(level.matrix.rows(), level.matrix.rows());
    by_blocks.setFromTriplets(entries.begin(), entries.end());
    Eigen::VectorXd power(level.matrix.rows());
    for (int i = 0; i < power.size(); ++i)
      power[i] = 1. + (i * 7919 % 101) / 101. * (i % 2 == 0 ? 1. : -1.);
    double largest = 1.;
    for (unsigned int k = 0; k < 10; ++k) {
      power.normalize();
      const Eigen::VectorXd product = level.matrix * power;
      power = by_blocks * product;
      largest = std::max(largest, power.norm());
    }
    const Matrix change = level.matrix * rigid, scaled = by_blocks * change;
    level.prolongation = rigid - (4. / 3. / largest) * scaled;
    const Matrix half = level.matrix * level.prolongation, across = level.prolongation.transpose();
    matrix = across * half;
    node_begin = coarse_begin;
    modes = coarse_modes;
    level.x.resize(matrix.rows());
    level.b.resize(matrix.rows());
    levels.push_back(std::move(level));
  }
  bottom.compute(matrix);
  bottom_entries = 2. * bottom.matrixL().nestedExpression().nonZeros();
}

double SmoothedAggregation::operator_complexity() const {
  if (levels.empty())
    return 1.;
  double sum = bottom_entries;
  for (const Level &level : levels)
    sum += level.matrix.nonZeros();
  return sum / levels.front().matrix.nonZeros();
}

void SmoothedAggregation::cycle(const std::size_t number, Eigen::VectorXd &x,
                                const Eigen::VectorXd &b) const {
  if (number == levels.size()) {
    x = bottom.solve(b);
    return;
  }
  const Level &level = levels[number];
  x.setZero(b.size());
  sweep(level, x, b, false);
  const Eigen::VectorXd left = b - level.matrix * x;
  level.b.noalias() = level.prolongation.transpose() * left;
  cycle(number + 1, level.x, level.b);
  x += level.prolongation * level.x;
  sweep(level, x, b, true);
}

} // namespace frictionbeam
