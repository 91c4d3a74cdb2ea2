// SPDX-License-Identifier: LGPL-2.1-or-later
#include "member.h"

#include <cmath>

namespace oracle {

namespace {

/// Points and weights of Gauss and Legendre on (0, 1), by Newton's method on the polynomial.
struct Gauss {
  std::vector<Real> x, w;
  explicit Gauss(const int n) {
    for (int i = 0; i < n; ++i) {
      Real z = std::cos(static_cast<Real>(pi) * (i + 0.75L) / (n + 0.5L)), slope = 1.;
      for (int iteration = 0; iteration < 50; ++iteration) {
        Real p = 1., before = 0.;
        for (int k = 1; k <= n; ++k) {
          const Real next = ((2 * k - 1) * z * p - (k - 1) * before) / k;
          before = p;
          p = next;
        }
        slope = n * (z * p - before) / (z * z - 1);
        z -= p / slope;
      }
      x.push_back((1 - z) / 2);
      w.push_back(1 / ((1 - z * z) * slope * slope));
    }
  }
};

/// Sum of w f(x) from @p a to @p b: polynomials on a straight piece, sines and cosines on an arc.
template <typename Function>
void integrate(const bool arc, const Real a, const Real b, const Function &f) {
  static const Gauss few(6), many(20);
  const Gauss &rule = arc ? many : few;
  for (std::size_t i = 0; i < rule.x.size(); ++i)
    f(a + (b - a) * rule.x[i], (b - a) * rule.w[i]);
}

Mat3 cross(const Vec3 &r) {
  Mat3 result;
  result << 0, -r[2], r[1], r[2], 0, -r[0], -r[1], r[0], 0;
  return result;
}

} // namespace

Vec3 MemberLoad::force(const Vec3 &tangent) const {
  const Real q = wind.norm();
  if (q == 0)
    return line_force;
  const Vec3 w = (wind - wind.dot(tangent) * tangent) / q;
  return line_force + q * w.norm() * w;
}

Mat6 Member::carry(const double from, const double to) const {
  Mat6 H = Mat6::Identity();
  H.block<3, 3>(3, 0) = cross((curve.at(to) - curve.at(from)).cast<Real>());
  return H;
}

Mat6 Member::compliance(const double s) const {
  const Vec3 t = curve.direction(s).cast<Real>().normalized();
  const Mat3 along = t * t.transpose(), across = Mat3::Identity() - along;
  Mat6 c = Mat6::Zero();
  c.block<3, 3>(0, 0) = along / EA;
  if (GA > 0)
    c.block<3, 3>(0, 0) += across / GA;
  c.block<3, 3>(3, 3) = along / GJ + across / EI;
  return c;
}

Vec6 Member::beyond(const double s, const MemberLoad &load) const {
  Vec6 sum = Vec6::Zero();
  integrate(curve.radius > 0., s, curve.length, [&](const Real x, const Real w) {
    const Vec3 q = load.force(curve.direction(x).cast<Real>());
    const Vec3 arm = (curve.at(x) - curve.at(s)).cast<Real>();
    sum.head<3>() += w * q;
    sum.tail<3>() += w * arm.cross(q);
  });
  return sum;
}

Vec6 Member::free_strain(const double s, const MemberLoad &load) const {
  Vec6 e;
  e.head<3>() = load.strain * curve.direction(s).cast<Real>();
  e.tail<3>() = load.curvature * bend_axis.cast<Real>();
  return e;
}

Vec6 Member::free_motion(const MemberLoad &load) const {
  const double L = curve.length;
  Vec6 d = carry(0., L).transpose() * (joint[0] * beyond(0., load) + load.pressure * thrust[0]) +
           load.pressure * thrust[1];
  integrate(curve.radius > 0., 0, L, [&](const Real s, const Real w) {
    d += w * carry(s, L).transpose() * (compliance(s) * beyond(s, load) + free_strain(s, load));
  });
  return d;
}

Vec12 Member::shape_forces(const Vec6 &at_b) const {
  Vec12 f;
  f.head<6>() = -carry(0., curve.length) * at_b;
  f.tail<6>() = at_b;
  return f;
}

void Member::prepare() {
  const double L = curve.length;
  const Mat6 H_a = carry(0., L);
  Mat6 F = H_a.transpose() * joint[0] * H_a + joint[1];
  integrate(curve.radius > 0., 0, L, [&](const Real s, const Real w) {
    const Mat6 H = carry(s, L);
    F += w * H.transpose() * compliance(s) * H;
  });
  stiff_b = F.inverse();
  Eigen::Matrix<Real, 6, 12> relative;
  relative << -H_a.transpose(), Mat6::Identity();
  K = relative.transpose() * stiff_b * relative;
}

Vec12 Member::load_vector(const MemberLoad &load) const {
  Vec12 f = shape_forces(-stiff_b * free_motion(load));
  f.head<6>() -= beyond(0., load); // the clamped ends carry the load
  return -f;
}

Member::At Member::at(const double s, const Vec12 &d, const MemberLoad &load) const {
  const double L = curve.length;
  const Vec6 a = d.head<6>(), b = d.tail<6>();
  const Vec6 end = stiff_b * (b - carry(0., L).transpose() * a - free_motion(load));
  const auto section = [&](const double x) { return Vec6(carry(x, L) * end + beyond(x, load)); };
  At result;
  result.force = section(s);
  result.motion =
      carry(0., s).transpose() * (a + joint[0] * section(0.) + load.pressure * thrust[0]);
  integrate(curve.radius > 0., 0, s, [&](const Real x, const Real w) {
    result.motion +=
        w * carry(x, s).transpose() * (compliance(x) * section(x) + free_strain(x, load));
  });
  return result;
}

Mat12 Member::mass_matrix() const {
  Mat12 M = Mat12::Zero();
  integrate(curve.radius > 0., 0, curve.length, [&](const Real s, const Real w) {
    Eigen::Matrix<Real, 6, 12> N;
    for (int i = 0; i < 12; ++i)
      N.col(i) = at(s, Vec12::Unit(i), MemberLoad{}).motion;
    const Vec3 t = curve.direction(s).cast<Real>();
    const Mat3 along = t * t.transpose(),
               inertia = rotary * (Mat3::Identity() - along) + twist * along;
    const auto u = N.topRows<3>(), turn = N.bottomRows<3>();
    M += w * (mass * u.transpose() * u + turn.transpose() * inertia * turn);
  });
  return M;
}

} // namespace oracle
