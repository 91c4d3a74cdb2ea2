// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/event/curved_slip.h"

#include <deal.II/base/quadrature_lib.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {

constexpr int n_nodes = 12, n_orders = 31;
constexpr unsigned int most_slip_iterations = 15;
constexpr double largest_turn = 0.5, small_turn = 1e-12, noise_of_turn = 1e-8;
constexpr double rounding_of_velocities = 1e-9; ///< at the start, of the fastest in the piece
constexpr double rounding_of_friction = 1e-15;  ///< of friction, which its derivative multiplies

using Eigen::MatrixXd, Eigen::VectorXd, Eigen::Vector2d;

/// Chebyshev's polynomials of [0, 1] and their derivatives at x.
void chebyshev(const double x, const int n, Eigen::RowVectorXd &values,
               Eigen::RowVectorXd &derivatives) {
  values.setOnes(n);
  derivatives.setZero(n);
  const double y = 2. * x - 1.;
  for (int k = 1; k < n; ++k) {
    values[k] = k == 1 ? y : 2. * y * values[k - 1] - values[k - 2];
    derivatives[k] =
        k == 1 ? 2. : 4. * values[k - 1] + 2. * y * derivatives[k - 1] - derivatives[k - 2];
  }
}

/// Polynomials by their values at Gauss' points, and at 0 first if that is given as well.
struct Basis {
  int n;
  MatrixXd to_chebyshev, to_powers;
  std::vector<double> points;
  /// At Gauss' points, then at 0, between those points, and at 1: values, derivatives, and by order
  /// j the responses j int_0^x (x - y)^(j-1) P(y) dy of something whose response to 1 is x^j.
  MatrixXd values, derivatives;
  MatrixXd responses; ///< points and places by order

  explicit Basis(const bool with_start) : n(n_nodes + with_start) {
    const dealii::QGauss<1> gauss(n_nodes);
    std::vector<double> places;
    if (with_start)
      places.push_back(0.);
    for (int j = 0; j < n_nodes; ++j) {
      places.push_back(gauss.point(j)[0]);
      points.push_back(gauss.point(j)[0]);
    }
    points.push_back(0.);
    for (int j = 1; j < n_nodes; ++j)
      points.push_back((gauss.point(j - 1)[0] + gauss.point(j)[0]) / 2.);
    points.push_back(1.);
    make_maps(places);
    make_values();
  }

  /// From values at these places to Chebyshev's coefficients, and from these to powers.
  void make_maps(const std::vector<double> &places) {
    Eigen::RowVectorXd value, derivative;
    MatrixXd vandermonde(n, n);
    for (int b = 0; b < n; ++b) {
      chebyshev(places[b], n, value, derivative);
      vandermonde.row(b) = value;
    }
    to_chebyshev = vandermonde.fullPivLu().inverse();
    to_powers.setZero(n, n); // powers by polynomials
    to_powers(0, 0) = 1.;
    to_powers(0, 1) = -1.;
    to_powers(1, 1) = 2.;
    for (int k = 2; k < n; ++k)
      for (int p = 0; p <= k; ++p)
        to_powers(p, k) = -2. * to_powers(p, k - 1) - to_powers(p, k - 2) +
                          (p > 0 ? 4. * to_powers(p - 1, k - 1) : 0.);
  }

  void make_values() {
    const dealii::QGauss<1> fine(n_orders);
    Eigen::RowVectorXd value, derivative;
    values.resize(points.size(), n);
    derivatives.resize(points.size(), n);
    std::vector<MatrixXd> by_order(n_orders, MatrixXd::Zero(points.size(), n));
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double x = points[i];
      chebyshev(x, n, value, derivative);
      values.row(i) = value;
      derivatives.row(i) = derivative;
      by_order[0].row(i) = value;
      for (unsigned int g = 0; g < fine.size(); ++g) {
        const double y = x * fine.point(g)[0];
        chebyshev(y, n, value, derivative);
        for (int j = 1; j < n_orders; ++j)
          by_order[j].row(i) += j * x * fine.weight(g) * std::pow(x - y, j - 1) * value;
      }
    }
    for (MatrixXd *const m : {&values, &derivatives})
      *m *= to_chebyshev;
    responses.resize(points.size() * n, n_orders);
    for (int j = 0; j < n_orders; ++j) {
      const MatrixXd m = by_order[j] * to_chebyshev;
      responses.col(j) = Eigen::Map<const VectorXd>(m.data(), m.size());
    }
  }

  int n_points() const { return values.rows(); }
  /// Powers, by rows, of the polynomials with such values, by rows; what is rounding is left out.
  MatrixXd powers(const MatrixXd &at_places) const {
    MatrixXd coefficients = at_places * to_chebyshev.transpose();
    const double largest = coefficients.lpNorm<Eigen::Infinity>();
    coefficients = (coefficients.array().abs() <= 4e-15 * largest).select(0., coefficients);
    return coefficients * to_powers.transpose();
  }
};

const Basis &basis_of(const CurvedSlip::Contact &contact) {
  static const Basis rigid(false), elastic(true);
  return contact.compliance > 0. ? elastic : rigid;
}

void shorten_columns(MatrixXd &m, const double x) {
  double power = 1.;
  for (int k = 0; k < m.cols(); ++k, power *= x)
    m.col(k) *= power;
}

Vector2d unit(const double angle) { return {std::cos(angle), std::sin(angle)}; }
Vector2d across(const double angle) { return {-std::sin(angle), std::cos(angle)}; }

/// What the equations say for one piece: w and N of all contacts at all points as linear functions
/// of the friction tau = f N s at Gauss' points, where Newton's method solves |s| = 1, s x w = 0
/// (doc/dynamics.md, "From event to event", slip along a curve).
class Piece {
public:
  Piece(const std::vector<CurvedSlip::Contact> &contacts, const CurvedSlip::Responses &responses,
        const double length);

  bool solve();
  /// Whether the equations hold between the points.
  bool is_resolved(const double tolerance) const;
  /// Friction at the places of a contact's basis.
  MatrixXd friction(const unsigned int i) const;
  MatrixXd directions(const unsigned int i) const;

private:
  int unknown(const int i, const int j) const { return i * n_nodes + j; }
  int row(const int i, const int point) const { return 3 * (i * n_points + point); }
  double coefficient(const int i) const { return contacts[i].coefficient; }
  VectorXd all_friction() const;

  const std::vector<CurvedSlip::Contact> &contacts;
  const double length;
  const int n_points;
  VectorXd constant; ///< w_1, w_2, N by contact and point
  MatrixXd matrix;   ///< of friction, two by contact and Gauss' point
  VectorXd angles, normal;
};

Piece::Piece(const std::vector<CurvedSlip::Contact> &contacts,
             const CurvedSlip::Responses &responses, const double length)
    : contacts(contacts), length(length), n_points(basis_of(contacts[0]).n_points()) {
  const int n = contacts.size();
  constant.setZero(3 * n * n_points);
  matrix.setZero(3 * n * n_points, 2 * n * n_nodes);
  const auto add = [&](const int i, const int c, const int l, const int d, const MatrixXd &by_place,
                       const double factor) { // to component c of contact i from tau_d of l
    const int start = by_place.cols() - n_nodes;
    for (int p = 0; p < n_points; ++p) {
      if (start > 0)
        constant[row(i, p) + c] += factor * by_place(p, 0) * contacts[l].force[d];
      for (int j = 0; j < n_nodes; ++j)
        matrix(row(i, p) + c, 2 * unknown(l, j) + d) += factor * by_place(p, start + j);
    }
  };
  for (int i = 0; i < n; ++i) {
    const MatrixXd &free = contacts[i].free;
    for (int p = 0; p < n_points; ++p)
      for (int k = free.cols(); k-- > 0;)
        constant.segment<3>(row(i, p)) =
            basis_of(contacts[i]).points[p] * constant.segment<3>(row(i, p)) + free.col(k);
  }
  for (int l = 0; l < n; ++l)
    for (int d = 0; d < 2; ++d) {
      const Basis &basis = basis_of(contacts[l]);
      const MatrixXd &response = responses[2 * l + d],
                     all = basis.responses.leftCols(response.cols()) * response.transpose();
      for (int i = 0; i < n; ++i)
        for (int c = 0; c < 3; ++c)
          add(i, c, l, d, Eigen::Map<const MatrixXd>(all.col(3 * i + c).data(), n_points, basis.n),
              1.);
      if (contacts[l].compliance > 0.)
        add(l, d, l, d, basis.derivatives, -contacts[l].compliance / length);
    }
}

VectorXd Piece::all_friction() const {
  VectorXd result(2 * angles.size());
  for (int u = 0; u < angles.size(); ++u)
    result.segment<2>(2 * u) = coefficient(u / n_nodes) * normal[u] * unit(angles[u]);
  return result;
}

bool Piece::solve() {
  const int n = contacts.size(), m = n * n_nodes;
  angles.resize(m);
  normal.setZero(m);
  for (int i = 0; i < n; ++i)
    angles.segment(i * n_nodes, n_nodes)
        .setConstant(std::atan2(contacts[i].direction[1], contacts[i].direction[0]));
  MatrixXd jacobian(2 * m, 2 * m); // angles, then normal forces
  VectorXd residual(2 * m);
  double turn_before = 1e300;
  for (unsigned int iteration = 0; iteration <= most_slip_iterations; ++iteration) {
    const VectorXd values = constant + matrix * all_friction();
    MatrixXd slopes(matrix.rows(), 2 * m);
    for (int k = 0; k < m; ++k) {
      const auto columns = matrix.middleCols<2>(2 * k);
      slopes.col(k) = columns * (coefficient(k / n_nodes) * normal[k] * across(angles[k]));
      slopes.col(m + k) = columns * (coefficient(k / n_nodes) * unit(angles[k]));
    }
    for (int u = 0; u < m; ++u) {
      const int r = row(u / n_nodes, u % n_nodes);
      const Vector2d t = across(angles[u]), w = values.segment<2>(r);
      residual[u] = t.dot(w);
      residual[m + u] = normal[u] - values[r + 2];
      jacobian.row(u) = t.transpose() * slopes.middleRows<2>(r);
      jacobian.row(m + u) = -slopes.row(r + 2);
      jacobian(u, u) -= unit(angles[u]).dot(w);
      jacobian(m + u, m + u) += 1.;
    }
    if (iteration == 0) { // normal forces for the first directions
      normal -= jacobian.bottomRightCorner(m, m).partialPivLu().solve(residual.tail(m)).eval();
      if (!normal.allFinite())
        return false;
      continue;
    }
    const VectorXd step = jacobian.partialPivLu().solve(-residual);
    if (!step.allFinite())
      return false;
    const double turn = step.head(m).lpNorm<Eigen::Infinity>(),
                 part = std::min(1., largest_turn / turn);
    angles += part * step.head(m);
    normal += part * step.tail(m);
    const double change =
        std::max(turn, step.tail(m).lpNorm<Eigen::Infinity>() / normal.lpNorm<Eigen::Infinity>());
    if (change <= small_turn || (change <= noise_of_turn && change >= turn_before / 2.))
      return true;
    turn_before = change;
  }
  return false;
}

bool Piece::is_resolved(const double tolerance) const {
  const VectorXd values = constant + matrix * all_friction();
  for (unsigned int i = 0; i < contacts.size(); ++i) {
    const Basis &basis = basis_of(contacts[i]);
    const MatrixXd tau = friction(i);
    const MatrixXd coefficients = tau * basis.to_chebyshev.transpose(),
                   at_points = tau * basis.values.transpose();
    const double largest = tau.lpNorm<Eigen::Infinity>();
    if (coefficients.rightCols(2).lpNorm<Eigen::Infinity>() > tolerance * largest)
      return false;
    double fastest = 0.;
    for (int p = 0; p < n_points; ++p)
      fastest = std::max(fastest, values.segment<2>(row(i, p)).norm());
    const double noise = contacts[i].compliance / length * rounding_of_friction * largest *
                         basis.derivatives.cwiseAbs().rowwise().sum().maxCoeff();
    if (unit(angles[unknown(i, 0)]).dot(values.segment<2>(row(i, 0))) <
        -rounding_of_velocities * fastest - noise)
      return false;
    for (int p = n_nodes; p < n_points; ++p) {
      const Vector2d t = at_points.col(p), w = values.segment<2>(row(i, p));
      const double limit = coefficient(i) * std::abs(values[row(i, p) + 2]);
      if (std::abs(t.norm() - limit) > tolerance * largest ||
          std::abs(t[0] * w[1] - t[1] * w[0]) > largest * (tolerance * fastest + noise))
        return false;
    }
  }
  return true;
}

MatrixXd Piece::friction(const unsigned int i) const {
  const bool start = contacts[i].compliance > 0.;
  MatrixXd result(2, n_nodes + start);
  if (start)
    result.col(0) = contacts[i].force;
  for (int j = 0; j < n_nodes; ++j)
    result.col(start + j) = coefficient(i) * normal[unknown(i, j)] * unit(angles[unknown(i, j)]);
  return result;
}

MatrixXd Piece::directions(const unsigned int i) const {
  MatrixXd result(2, n_nodes);
  for (int j = 0; j < n_nodes; ++j)
    result.col(j) = unit(angles[unknown(i, j)]);
  return result;
}

} // namespace

double CurvedSlip::solve(const std::vector<Contact> &contacts, const Responses &responses,
                         const double length, const double response_length, const double longest,
                         const double shortest, const double tolerance) {
  for (double part = longest; part >= shortest; part /= 2.) {
    std::vector<Contact> within = contacts;
    for (Contact &contact : within)
      shorten_columns(contact.free, part);
    Responses scaled = responses;
    for (MatrixXd &response : scaled)
      shorten_columns(response, part * length / response_length);
    if (solve_within(within, scaled, part * length, tolerance))
      return part;
  }
  return 0.;
}

bool CurvedSlip::solve_within(const std::vector<Contact> &contacts, const Responses &responses,
                              const double length, const double tolerance) {
  Piece piece(contacts, responses, length);
  if (!piece.solve() || !piece.is_resolved(tolerance))
    return false;
  friction.clear();
  direction.clear();
  static const Basis nodes(false);
  for (unsigned int i = 0; i < contacts.size(); ++i) {
    friction.push_back(basis_of(contacts[i]).powers(piece.friction(i)));
    direction.push_back(nodes.powers(piece.directions(i)));
  }
  return true;
}

} // namespace frictionbeam
