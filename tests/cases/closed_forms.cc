// SPDX-License-Identifier: LGPL-2.1-or-later
// Small lines shall answer as beam theory says: expansion, skew restraints, moving anchors, tees,
// bypasses, springs, gaps, pipes on pipes, sliding. The numbers come from the closed forms of
// Timoshenko's beam written out here, for the parameter files in the folder `line`.
#include "../check.h"
#include "run_program.h"

#include <Eigen/Dense>

namespace {

using Vector3 = Eigen::Vector3d;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

constexpr double pi = 3.14159265358979323846, degree = pi / 180.;

// pipe.prm
constexpr double ro = 0.1, ri = 0.092, E = 2e11, nu = 0.3, rho = 7850., alpha = 1.2e-5, g = 9.81;
constexpr double A = pi * (ro * ro - ri * ri),
                 I = pi / 4. * (ro * ro * ro * ro - ri * ri * ri * ri);
constexpr double G = E / (2. * (1. + nu)), EA = E * A, EI = E * I, GJ = 2. * G * I, GA = G * A / 2.;
constexpr double weight = (rho * A + 40.) * g; // [N/m]

double phi(const double length) { return 12. * EI / (GA * length * length); }

/// Deflection of a cantilever's tip under a unit force there.
double tip(const double length) { return length * length * length / (3. * EI) + length / GA; }

/// A clamped pipe's stiffness at its end: force and moment there for a motion of that end, the
/// other end at @p length along the unit vector @p t.
Matrix6 end_stiffness(const Vector3 &t, const double length) {
  const double k1 = 12. * EI / (std::pow(length, 3) * (1. + phi(length))), k2 = k1 * length / 2.,
               k3 = (4. + phi(length)) * EI / (length * (1. + phi(length)));
  Eigen::Matrix3d cross; // cross * v = t x v
  cross << 0., -t[2], t[1], t[2], 0., -t[0], -t[1], t[0], 0.;
  const Eigen::Matrix3d along = t * t.transpose(), across = Eigen::Matrix3d::Identity() - along;
  Matrix6 k;
  k << EA / length * along + k1 * across, -k2 * cross, k2 * cross,
      GJ / length * along + k3 * across;
  return k;
}

class Lines {
public:
  Lines(const std::string &binary, const std::string &folder) : binary(binary), folder(folder) {}

  program::Run run(const std::string &name) const {
    std::cout << name << std::endl;
    const program::Run result = program::run(binary, folder + '/' + name + ".prm");
    CHECK(result.exit_status == 0 && result.status == "converged");
    if (result.exit_status != 0)
      throw std::runtime_error(result.output);
    return result;
  }

private:
  const std::string binary, folder;
};

/// Equal within rounding error, measured by the size of the figures around.
#define CHECK_SAME(value, reference, scale)                                                        \
  CHECK_NEAR(1. + ((value) - (reference)) / (scale), 1., 1e-9)

Vector3 vector(const program::Run &run, const std::string &a, const std::string &b,
               const std::string &c) {
  return {run[a], run[b], run[c]};
}

void check_vector(const Vector3 &found, const Vector3 &expected, const double scale) {
  for (unsigned int d = 0; d < 3; ++d)
    CHECK_SAME(found[d], expected[d], scale);
}

/// Free expansion: every point moves by the strain times its distance to the anchor. A closed pipe
/// under pressure stretches by p A_bore (1 - 2 nu)/EA (Lame).
void expansion(const Lines &lines) {
  const auto run = lines.run("expansion");
  const double hot = 100. * alpha, pressure = 5e6 * pi * ri * ri * (1. - 2. * nu) / EA;
  const double size = 8. * hot;
  check_vector(vector(run, "hot_F_x", "hot_F_y", "hot_F_z"), hot * Vector3(8., 3., 1.), size);
  check_vector(vector(run, "hot_G_x", "hot_G_y", "hot_G_z"), hot * Vector3(3.5, 2., 2.), size);
  CHECK_SAME(run["hot_F_rz"], 0., hot);
  CHECK_SAME(run["hot_N"], 0., EA * hot);
  CHECK_SAME(run["hot_M"], 0., EA * hot);
  CHECK_SAME(run["pressure_Q_x"], 5. * pressure, 8. * pressure);
  CHECK_SAME(run["pressure_G_z"], 2. * pressure, 8. * pressure);
  CHECK_SAME(run["both_Q_x"], 5. * (hot + pressure / 2.), size);
  CHECK_SAME(run["both_G_z"], 2. * (hot + pressure / 2.), size);
}

/// The force has a part along the pipe, one that the guide takes, and one that bends the pipe.
void guide(const Lines &lines) {
  const auto run = lines.run("guide");
  const double L = 6.;
  const Vector3 force(1000., 0., 0.), t = Vector3(2., 2., 1.) / 3.,
                                      y = Vector3(-1., 1., 0.) / std::sqrt(2.), z = t.cross(y);
  const double N = force.dot(t), V = force.dot(z);
  check_vector(vector(run, "ux", "uy", "uz"), N * L / EA * t + V * tip(L) * z,
               std::abs(V * tip(L)));
  check_vector(vector(run, "fx", "fy", "fz"), -force.dot(y) * y, 1000.);
  check_vector(vector(run, "N", "Vy", "Vz"), {N, 0., V}, 1000.);
  // Section moment at the anchor: that of the force at L t, L t x (V z) = -L V y.
  check_vector(vector(run, "Mx", "My", "Mz"), {0., -L * V, 0.}, 1000. * L);
  CHECK_SAME(run["my_end"], L * V * y[1], 1000. * L);
}

void line_stop(const Lines &lines) {
  const auto run = lines.run("line_stop");
  const double L = 5., strain = 50. * alpha + 5e6 * pi * ri * ri * (1. - 2. * nu) / EA;
  const Vector3 t(0.6, 0.8, 0.);
  CHECK_SAME(run["N"], -EA * strain, EA * strain);
  CHECK_SAME(run["fx"], -EA * strain * t[0], EA * strain);
  CHECK_SAME(run["fy"], -EA * strain * t[1], EA * strain);
  check_vector(vector(run, "ux", "uy", "uz"), {0., 0., -500. * tip(L)}, 500. * tip(L));
}

/// The moved end answers with the stiffness of a clamped pipe; the middle of a pipe follows half
/// the motion of its end, and by L/8 its rotation.
void movement(const Lines &lines) {
  const auto run = lines.run("movement");
  const double L = 6.;
  const Vector3 t = Vector3(2., 2., 1.) / 3., shift(0.001, 0.002, -0.003),
                turn = degree * Vector3(0.1, -0.2, 0.3);
  Vector6 motion;
  motion << shift, turn;
  const Vector6 force = end_stiffness(-t, L) * motion;
  check_vector(vector(run, "fx", "fy", "fz"), force.head<3>(), force.head<3>().norm());
  check_vector(vector(run, "mx", "my", "mz"), force.tail<3>(), force.tail<3>().norm());
  check_vector(vector(run, "ux", "uy", "uz"), shift / 2. + L / 8. * t.cross(turn), shift.norm());
  CHECK_SAME(run["N"], EA / L * shift.dot(t), force.norm());
  CHECK_SAME(run["Mx"], GJ / L * turn.dot(t), force.norm());
}

/// A guide that moves takes the pipe along, whichever way the route runs: V = 3 EI u/L^3 with
/// shear.
void guide_moves(const Lines &lines) {
  const auto run = lines.run("guide_moves");
  const double V = 0.001 / tip(5.);
  for (const char *end : {"east", "west", "north", "south"})
    CHECK_SAME(run[end], V, V);
}

/// The tee moves by the inverse of the sum of the three stiffnesses; each anchor holds its share.
void tee(const Lines &lines) {
  const auto run = lines.run("tee");
  const Vector3 t[3] = {{-1., 0., 0.}, {1., 0., 0.}, {0.6, 0.48, 0.64}};
  const double length[3] = {4., 5., 3.};
  Matrix6 k[3], sum = Matrix6::Zero();
  for (unsigned int i = 0; i < 3; ++i)
    sum += k[i] = end_stiffness(t[i], length[i]);
  Vector6 load;
  load << 100., -200., -1000., 50., 60., -70.;
  const Vector6 u = sum.ldlt().solve(load);
  check_vector(vector(run, "ux", "uy", "uz"), u.head<3>(), u.head<3>().norm());
  check_vector(vector(run, "rx", "ry", "rz"), u.tail<3>(), u.tail<3>().norm());
  const char *const names[3] = {"A", "B", "C"};
  for (unsigned int i = 0; i < 3; ++i) {
    CHECK_SAME(run[std::string("N_") + names[i]], -EA / length[i] * t[i].dot(u.head<3>()), 1000.);
    if (i == 1)
      continue;
    const std::string prefix = std::string(names[i]) + '_';
    const Vector6 at_tee = k[i] * u;
    const Vector3 force = -at_tee.head<3>(),
                  moment = -at_tee.tail<3>() + (length[i] * t[i]).cross(at_tee.head<3>());
    check_vector(vector(run, prefix + "fx", prefix + "fy", prefix + "fz"), force, 1000.);
    check_vector(vector(run, prefix + "mx", prefix + "my", prefix + "mz"), moment, 1000.);
  }
}

/// Cut in its plane of symmetry, the ring of header and bypass carries X and the moment Y in the
/// bypass; least work gives both. u_B: 1 m of header on either side, and the header between.
void bypass(const Lines &lines) {
  const auto run = lines.run("bypass");
  const double F = 10000., b = 1.5, h = 2.; // half width, depth
  Eigen::Matrix2d work;
  // d/dX and d/dY of: bypass b (X^2/EA + Y^2/EI), leg X^2 h/GA + int (Y + X s)^2/EI ds, header
  // b ((F - X)^2/EA + (Y + X h)^2/EI), all over 2
  work(0, 0) = 2. * b / EA + h / GA + (h * h * h / 3. + b * h * h) / EI;
  work(0, 1) = work(1, 0) = (h * h / 2. + b * h) / EI;
  work(1, 1) = (2. * b + h) / EI;
  const Eigen::Vector2d redundant = work.inverse() * Eigen::Vector2d(F * b / EA, 0.);
  const double X = redundant[0], Y = redundant[1];
  CHECK_SAME(run["N_T"], X, F);
  CHECK_SAME(run["N_H"], F - X, F);
  CHECK_SAME(run["M_T"], std::abs(Y), F);
  CHECK_SAME(run["M_H"], std::abs(Y + X * h), F);
  CHECK_SAME(run["u_B"], (2. * F + 2. * b * (F - X)) / EA, 5. * F / EA);
}

void cantilever(const Lines &lines) {
  const auto run = lines.run("cantilever");
  const double L = 6., k = 2e5, valve = 80. * g;
  const auto sag = [&](const double q) {
    return q * std::pow(L, 4) / (8. * EI) + q * L * L / (2. * GA);
  };
  const double w = (sag(weight) + valve * tip(L)) / (1. + k * tip(L)), hanger = k * w;
  CHECK_SAME(run["uz"], -w, w);
  CHECK_SAME(run["hanger"], hanger, valve);
  CHECK_SAME(run["fz"], weight * L + valve - hanger, valve);
  const double moment = weight * L * L / 2. + (valve - hanger) * L; // hogging
  CHECK_SAME(run["rx"], -(weight * L * L * L / 6. + (valve - hanger) * L * L / 2.) / EI, w);
  CHECK_SAME(run["mx"], moment, weight * L * L);
  CHECK_SAME(run["Vz"], -(weight * L + valve - hanger), valve);
  CHECK_SAME(run["My"], moment, weight * L * L);
  CHECK_SAME(run["wind_ux"], sag(300.), sag(300.));
  CHECK_SAME(run["wind_uz"], -w, w);
  CHECK_SAME(run["wind_fx"], -300. * L, 300. * L);
  CHECK_SAME(run["wind_mz"], 300. * L * L / 2., 300. * L * L);
}

/// On the stand: (w - gap) k = P - w/tip. Off it: P tip upwards, the gap that much larger.
void gap(const Lines &lines) {
  const auto run = lines.run("gap");
  const double L = 6., P = 5000., k = 1e6 / 0.5, gap = 0.004;
  const double fn = (P * tip(L) - gap) / (tip(L) + 1. / k), w = (P - fn) * tip(L);
  CHECK_SAME(run["uz"], -w, w);
  CHECK_SAME(run["fn"], fn, P);
  CHECK_SAME(run["My"], (P - fn) * L, P * L);
  CHECK_SAME(run["uz_up"], P * tip(L), P * tip(L));
  CHECK_SAME(run["gap_up"], gap + P * tip(L), P * tip(L));
  CHECK_SAME(run["fn_up"], 0., P);
}

void pipe_on_pipe(const Lines &lines) {
  const auto run = lines.run("pipe_on_pipe");
  const double P = 2000., k = 3e5 / 0.3, fn = P * tip(5.) / (tip(5.) + tip(3.) + 1. / k);
  CHECK_SAME(run["fn"], fn, P);
  CHECK_SAME(run["upper"], -(P - fn) * tip(5.), P * tip(5.));
  CHECK_SAME(run["lower"], -fn * tip(3.), P * tip(5.));
}

/// All rests slide: the anchor holds f times the sum of their forces, outwards and back; the end
/// moves by the free expansion less what friction holds back.
void slide(const Lines &lines) {
  const auto run = lines.run("slide");
  const double f = 0.3, L = 60.;
  double normal = 0., held = 0.;
  for (unsigned int i = 1; i <= 10; ++i) {
    const double fn = run["fn_" + std::to_string(i)];
    normal += fn;
    held += f * fn * 6. * i / EA;
  }
  CHECK_SAME(run["normal"], normal, normal);
  CHECK_SAME(run["fz"] + normal, weight * L, weight * L);
  CHECK_SAME(run["friction"], f * normal, normal);
  CHECK_SAME(run["slipping"], 10., 1.);
  CHECK_SAME(run["N_hot"], -f * normal, normal);
  CHECK_SAME(run["N_cold"], f * normal, normal);
  const double hot = 100. * alpha * L;
  CHECK_SAME(run["ux_hot"], 0.6 * (hot - held), hot);
  CHECK_SAME(run["uy_hot"], 0.8 * (hot - held), hot);
  CHECK_SAME(run["ux_cold"], 0.6 * held, hot);
}

} // namespace

int main(int argc, char **argv) {
  if (argc != 3) {
    std::cerr << "closed_forms PROGRAM FOLDER\n";
    return 1;
  }
  const Lines lines(argv[1], argv[2]);
  for (const auto &test : {expansion, guide, line_stop, movement, guide_moves, tee, bypass,
                           cantilever, gap, pipe_on_pipe, slide})
    try {
      test(lines);
    } catch (const std::exception &error) {
      CHECK(false);
      std::cerr << error.what() << '\n';
    }
  return check::report();
}
