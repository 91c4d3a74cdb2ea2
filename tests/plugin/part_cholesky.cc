// SPDX-License-Identifier: LGPL-2.1-or-later
// Eliminating the inside of a body: nested dissection keeps what it separates apart, and the
// factorization on it gives what dense matrices give.
#include "../check.h"

#include "../../plugin/contact/dissection.h"
#include "../../plugin/contact/part_cholesky.h"

#include <Eigen/Cholesky>

#include <array>
#include <limits>
#include <random>

using namespace frictionbeam;
using contact::PartCholesky;
using contact::SparseMatrix;
using Vector = contact::Vector;
using Entries = std::vector<Eigen::Triplet<double>>;

namespace {

constexpr double tolerance = 1e-10; // of the norm

SparseMatrix matrix_of(const Entries &entries, const int n_rows, const int n_columns) {
  SparseMatrix matrix(n_rows, n_columns);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// K_ii and K_ib of a body.
struct Body {
  SparseMatrix inner, to_border;

  Body(const Entries &inside, const Entries &outwards, const int n, const int n_border)
      : inner(matrix_of(inside, n, n)), to_border(matrix_of(outwards, n, n_border)) {}
};

double number(const double from, const double to) {
  static std::minstd_rand random;
  return std::uniform_real_distribution<double>(from, to)(random);
}

int integer(const int n) { return static_cast<int>(number(0., n)) % n; }

void couple(Entries &entries, const int a, const int b, const double stiffness) {
  entries.emplace_back(a, a, stiffness);
  entries.emplace_back(b, b, stiffness);
  entries.emplace_back(a, b, -stiffness);
  entries.emplace_back(b, a, -stiffness);
}

/// Bricks of three unknowns a node and an element's stiffness from random numbers, on a border that
/// is the layer of nodes below them.
Body bricks(const std::array<int, 3> &n) {
  Eigen::MatrixXd root(24, 24);
  for (double &entry : root.reshaped())
    entry = number(-1., 1.);
  const Eigen::MatrixXd of_brick = root.transpose() * root;
  const int layer = 3 * (n[0] + 1) * (n[1] + 1);
  Entries inside, outwards;
  for (int z = 0; z < n[2]; ++z)
    for (int y = 0; y < n[1]; ++y)
      for (int x = 0; x < n[0]; ++x) {
        const auto unknown = [&](const int k) { // negative: of the border
          const int v = k / 3;
          return 3 * (((z + v / 4) * (n[1] + 1) + y + v / 2 % 2) * (n[0] + 1) + x + v % 2) + k % 3 -
                 layer;
        };
        for (int a = 0; a < 24; ++a)
          for (int b = 0; b < 24; ++b) {
            if (unknown(a) >= 0 && unknown(b) >= 0)
              inside.emplace_back(unknown(a), unknown(b), of_brick(a, b));
            if (unknown(a) >= 0 && unknown(b) < 0)
              outwards.emplace_back(unknown(a), unknown(b) + layer, of_brick(a, b));
          }
      }
  return {inside, outwards, n[2] * layer, layer};
}

/// Springs between random pairs, each unknown held by a weak one.
Body random_springs(const int n, const int n_springs, const int n_border) {
  Entries inside, outwards;
  for (int i = 0; i < n; ++i)
    inside.emplace_back(i, i, 0.1);
  for (int k = 0; k < n_springs; ++k) {
    const int a = integer(n), b = integer(n);
    if (a != b)
      couple(inside, a, b, number(0., 1.));
  }
  for (int b = 0; b < n_border; ++b)
    for (int k = 0; k < 3; ++k)
      outwards.emplace_back(integer(n), b, number(-1., 1.));
  return {inside, outwards, n, n_border};
}

/// A row of unknowns with springs, in @p n_parts without a spring between them.
Body rows(const int n, const int n_parts) {
  Entries inside, outwards;
  for (int i = 0; i < n * n_parts; ++i) {
    inside.emplace_back(i, i, 1e-3);
    if ((i + 1) % n != 0)
      couple(inside, i, i + 1, 1.);
  }
  for (int part = 0; part < n_parts; ++part)
    outwards.emplace_back(part * n, part % 4, -1.);
  return {inside, outwards, n * n_parts, 4};
}

/// All of them on a hub.
Body star(const int n) {
  Entries inside;
  for (int i = 0; i < n; ++i)
    couple(inside, i, n, 1. + i % 3);
  inside.emplace_back(n, n, 1.);
  return {inside, {{0, 0, 1.}, {n, 1, 1.}}, n + 1, 2};
}

/// Each unknown in one front, children before parents, and every entry between a front and one on
/// its way to the root.
void check_dissection(const Body &body) {
  const std::vector<contact::Dissected> pieces = contact::dissect(body.inner);
  std::vector<int> piece_of(body.inner.rows(), -1);
  bool is_in_order = true, once = true, is_apart = true;
  for (unsigned int p = 0; p < pieces.size(); ++p) {
    is_in_order = is_in_order && (pieces[p].parent == -1 || pieces[p].parent > static_cast<int>(p));
    for (const int i : pieces[p].unknowns) {
      once = once && piece_of[i] == -1;
      piece_of[i] = p;
    }
  }
  CHECK(is_in_order);
  if (!is_in_order)
    return;
  for (int i = 0; i < body.inner.rows(); ++i) {
    once = once && piece_of[i] >= 0;
    for (SparseMatrix::InnerIterator entry(body.inner, i); entry; ++entry) {
      const int above = std::max(piece_of[i], piece_of[entry.col()]);
      int on_its_way = std::min(piece_of[i], piece_of[entry.col()]);
      while (on_its_way >= 0 && on_its_way != above)
        on_its_way = pieces[on_its_way].parent;
      is_apart = is_apart && on_its_way == above;
    }
  }
  CHECK(once);
  CHECK(is_apart);
}

void check_factorization(const Body &body) {
  const PartCholesky part(body.inner, body.to_border);
  CHECK(part.ok());
  if (!part.ok())
    return;
  const Eigen::LLT<Eigen::MatrixXd> dense{Eigen::MatrixXd(body.inner)};
  const Eigen::MatrixXd to_border(body.to_border);
  const Eigen::MatrixXd share = -to_border.transpose() * dense.solve(to_border);
  CHECK_NEAR((part.share() - share).norm(), 0., tolerance * share.norm());
  Vector f(body.inner.rows());
  for (double &force : f)
    force = number(-1., 1.);
  const Vector motion = dense.solve(f), on_border = -to_border.transpose() * motion;
  CHECK_NEAR((part.solve(f) - motion).norm(), 0., tolerance * motion.norm());
  CHECK_NEAR((part.condense(f) - on_border).norm(), 0., tolerance * on_border.norm());
}

void check_all(const Body &body) {
  check_dissection(body);
  check_factorization(body);
}

void bodies() {
  for (const std::array<int, 3> &shape :
       std::vector<std::array<int, 3>>{{12, 3, 2}, {5, 6, 7}, {1, 1, 30}, {2, 2, 1}})
    check_all(bricks(shape));
}

void random_graphs() {
  for (const int n : {1, 2, 65, 300, 900})
    for (const int springs_of_each : {0, 1, 2, 5})
      check_all(random_springs(n, n * springs_of_each, 7)); // also in many parts, also all alone
}

void special_graphs() {
  check_all(rows(1500, 1));
  check_all(rows(100, 9));
  check_all(star(500));
  check_all(random_springs(80, 6000, 3)); // as good as dense
  Body touched_by_none = rows(100, 2);
  touched_by_none.to_border.setZero();
  const PartCholesky part(touched_by_none.inner, touched_by_none.to_border);
  CHECK(part.ok() && part.share().rows() == 4 && part.share().isZero(0.));
  const PartCholesky without_border(touched_by_none.inner, SparseMatrix(200, 0));
  CHECK(without_border.ok() && without_border.share().size() == 0);
  const PartCholesky empty(SparseMatrix(0, 0), SparseMatrix(0, 2));
  CHECK(empty.ok() && empty.share().isZero(0.));
}

/// A long row is halved, not peeled.
void depth() {
  const std::vector<contact::Dissected> pieces = contact::dissect(rows(4096, 1).inner);
  std::size_t deepest = 0, largest = 0;
  for (const contact::Dissected &piece : pieces) {
    largest = std::max(largest, piece.unknowns.size());
    std::size_t above = 0;
    for (int p = piece.parent; p >= 0; p = pieces[p].parent)
      ++above;
    deepest = std::max(deepest, above);
  }
  CHECK(largest <= 64);
  CHECK(deepest <= 11); // log_1.5 of 64 where sides may be as unequal as 1 to 2
}

bool is_accepted(const Body &body) { return PartCholesky(body.inner, body.to_border).ok(); }

void not_positive_definite() {
  for (const int n : {3, 60, 700}) { // in one front, in many
    Body body = rows(n, 1);
    CHECK(is_accepted(body));
    body.inner.coeffRef(n / 2, n / 2) = -1.;
    CHECK(!is_accepted(body));
    body.inner.coeffRef(n / 2, n / 2) = std::numeric_limits<double>::quiet_NaN();
    CHECK(!is_accepted(body));
    body = rows(n, 1);
    for (int i = 0; i < n; ++i)
      body.inner.coeffRef(i, i) -= 1e-3; // moves freely
    CHECK(!is_accepted(body));
  }
  Body body = random_springs(40, 0, 1);
  body.inner.coeffRef(7, 7) = 0.;
  CHECK(!is_accepted(body));
  // A net on one spring, which is there or is rounding.
  for (const double spring : {0., 1e-16, 1e-6}) {
    Entries inside;
    for (int i = 0; i < 20; ++i)
      for (int j = 0; j < 20; ++j) {
        const int at[2] = {20 * i + j, 20 * i + j + 20};
        if (i < 19)
          couple(inside, at[0], at[1], number(0.5, 2.));
        if (j < 19)
          couple(inside, at[0], at[0] + 1, number(0.5, 2.));
      }
    inside.emplace_back(0, 0, spring);
    CHECK(is_accepted({inside, {}, 400, 1}) == (spring > 1e-10));
  }
}

} // namespace

int main() {
  bodies();
  random_graphs();
  special_graphs();
  depth();
  not_positive_definite();
  return check::report();
}
