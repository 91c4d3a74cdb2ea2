// SPDX-License-Identifier: LGPL-2.1-or-later
#include "frame.h"

#include <algorithm>
#include <cmath>

namespace oracle {

namespace {

bool acts_on(const Load &load, const std::string &pipe) {
  return load.pipes.empty() || std::count(load.pipes.begin(), load.pipes.end(), pipe) > 0;
}

Mat6 joint_flexibility(const Vec &tangent, const Joint &joint) {
  const Vec3 t = tangent.cast<Real>();
  const Mat3 along = t * t.transpose(), cross = Mat3::Identity() - along;
  const auto soft = [](const double stiffness) -> Real {
    return stiffness > 0. ? 1.L / stiffness : 0.L;
  };
  Mat6 J = Mat6::Zero();
  J.block<3, 3>(0, 0) = soft(joint.axial) * along + soft(joint.lateral) * cross;
  J.block<3, 3>(3, 3) = soft(joint.torsion) * along + soft(joint.bending) * cross;
  return J;
}

} // namespace

void Frame::add_joints() {
  /// The member of a pipe that begins at a point, or that ends there at the pipe's end.
  const auto find = [&](const std::string &point, const std::string &pipe) {
    const int node = point_node.at(point);
    for (const int end : {0, 1})
      for (Member &member : members)
        if (scene.pipes[member.pipe].name == pipe && member.node[end] == node)
          return std::make_pair(&member, end);
    throw std::runtime_error("no pipe at joint " + point);
  };
  const auto tangent_at = [](const Member &member, const int end) { return member.tangent[end]; };
  for (const Joint &joint : scene.joints) {
    const auto [member, end] = find(joint.at, joint.pipe);
    const Vec t = tangent_at(*member, end);
    member->joint[end] += joint_flexibility(t, joint);
    if (joint.thrust_area > 0.)
      member->thrust[end].head<3>() += (joint.thrust_area / joint.axial * t).cast<Real>();
  }
  for (const Tee &tee : scene.tees) {
    if (!tee.code && tee.in_plane == 0.)
      continue;
    const auto [member, end] = find(tee.at, tee.branch);
    const Vec t = tangent_at(*member, end);
    const Member *run = nullptr; // the run's last member that ends at the tee, or its first one
    int run_end = 0;
    for (const Member &other : members)
      if (scene.pipes[other.pipe].name != tee.branch && (run == nullptr || run_end == 0))
        for (const int e : {0, 1})
          if (other.node[e] == point_node.at(tee.at)) {
            run = &other;
            run_end = e;
          }
    if (run == nullptr)
      throw std::runtime_error("no run at tee " + tee.at);
    const Vec along_run = tangent_at(*run, run_end);
    const Vec3 normal = along_run.cross(t).normalized().cast<Real>();
    double in_plane = tee.in_plane, out_of_plane = tee.out_of_plane;
    if (tee.code) { // theta = k M d/(E I_b), ASME III NB-3686.5
      const Pipe &of_run = scene.pipes[run->pipe], &branch = scene.pipes[member->pipe];
      const bool inches = scene.units.find("in ") == 0 || scene.units.find("ft ") == 0;
      const Figures b = figures(scene.sections[branch.section], inches),
                    r = figures(scene.sections[of_run.section], inches);
      const double d = 2. * b.radius, D = 2. * r.radius;
      const double root = std::sqrt(r.wall / b.wall * d / D) * b.wall / r.wall;
      const double unit = modulus(scene.materials[branch.material]) * b.inertia / d;
      out_of_plane = unit / (0.1 * std::pow(D / r.wall, 1.5) * root);
      in_plane = unit / (0.2 * D / r.wall * root);
    }
    const Vec3 along = t.cast<Real>();
    const Mat3 about_normal = normal * normal.transpose(),
               other = Mat3::Identity() - along * along.transpose() - about_normal;
    member->joint[end].block<3, 3>(3, 3) += about_normal / in_plane + other / out_of_plane;
  }
}

void Frame::assemble() {
  K = Matrix::Zero(n(), n());
  for (const Member &member : members)
    for (const int i : {0, 1})
      for (const int j : {0, 1})
        K.block<6, 6>(6 * member.node[i], 6 * member.node[j]) +=
            member.stiffness().block<6, 6>(6 * i, 6 * j);
  const auto add_spring = [&](const Six &stiffness, const std::string &at, const std::string &to) {
    const int a = 6 * point_node.at(at), b = to.empty() ? -1 : 6 * point_node.at(to);
    for (int c = 0; c < 6; ++c) {
      K(a + c, a + c) += stiffness[c];
      if (b >= 0) {
        K(b + c, b + c) += stiffness[c];
        K(a + c, b + c) -= stiffness[c];
        K(b + c, a + c) -= stiffness[c];
      }
    }
  };
  for (const Spring &spring : scene.springs)
    add_spring(spring.stiffness, spring.at, spring.to);
  for (const Hanger &hanger : scene.hangers)
    add_spring({0., 0., hanger.stiffness, 0., 0., 0.}, hanger.at, "");
}

MemberLoad Frame::load_on(const Member &member, const std::vector<Real> &factors) const {
  const Pipe &pipe = scene.pipes[member.pipe];
  const Material &material = scene.materials[pipe.material];
  const Figures f = figures_of(member);
  MemberLoad sum;
  for (std::size_t l = 0; l < scene.loads.size(); ++l) {
    const Load &load = scene.loads[l];
    if (factors[l] == 0 || !acts_on(load, pipe.name))
      continue;
    if (load.kind == "weight")
      sum.line_force += factors[l] * member.mass * load.vector.cast<Real>();
    else if (load.kind == "ground acceleration")
      sum.line_force -= factors[l] * member.mass * load.vector.cast<Real>();
    else if (load.kind == "line force")
      sum.line_force += factors[l] * load.vector.cast<Real>();
    else if (load.kind == "wind") // wind() is quadratic in its direction: one wind at a time
      sum.wind +=
          factors[l] * load.value * 2. * (f.radius + f.insulation) * load.vector.cast<Real>();
    else if (load.kind == "temperature")
      sum.strain +=
          factors[l] * thermal_strain(material, scene.installation_temperature, load.value);
    else if (load.kind == "pressure") {
      const double inner = f.radius - f.wall, bore = pi * inner * inner, nu = material.nu;
      const double stretch = factors[l] * load.value * bore * (1. - 2. * nu) / member.EA;
      sum.strain += stretch;
      sum.pressure += factors[l] * load.value;
      const double R = member.bend_radius, r = f.radius - f.wall / 2.;
      if (R > 0.) // Bourdon, by membrane theory of the torus
        sum.curvature -= factors[l] * load.value * r /
                         (2. * modulus(material) * f.wall * (pipe.rigid ? 1000. : 1.) * R);
    }
  }
  return sum;
}

Vec12 Frame::motions(const Member &member, const Vector &d) const {
  Vec12 result;
  result << d.segment<6>(6 * member.node[0]), d.segment<6>(6 * member.node[1]);
  return result;
}

Vector Frame::load_vector(const std::vector<Real> &factors) const {
  Vector f = Vector::Zero(n());
  for (const Member &member : members) {
    const Vec12 forces = member.load_vector(load_on(member, factors));
    f.segment<6>(6 * member.node[0]) += forces.head<6>();
    f.segment<6>(6 * member.node[1]) += forces.tail<6>();
  }
  for (std::size_t l = 0; l < scene.loads.size(); ++l) {
    const Load &load = scene.loads[l];
    if (load.kind == "force")
      for (const auto &[point, force] : load.at)
        for (int c = 0; c < 6; ++c)
          f[6 * point_node.at(point) + c] += factors[l] * force[c];
    if (load.kind == "weight" || load.kind == "ground acceleration")
      for (const Mass &mass : scene.masses)
        for (const std::string &point : mass.at)
          f.segment<3>(6 * point_node.at(point)) +=
              (load.kind == "weight" ? 1 : -1) * factors[l] * mass.mass * load.vector.cast<Real>();
  }
  for (const Hanger &hanger : scene.hangers)
    f[6 * point_node.at(hanger.at) + 2] += factors.back() * hanger.cold_load;
  return f;
}

Vector Frame::residual(const Vector &d, const std::vector<Real> &factors) const {
  return K * d - load_vector(factors);
}

Matrix Frame::mass(const bool lumped) const {
  Matrix M = Matrix::Zero(n(), n());
  for (const Member &member : members)
    if (lumped)
      for (const int node : member.node)
        for (int c = 0; c < 3; ++c)
          M(6 * node + c, 6 * node + c) += member.mass * member.curve.length / 2.;
    else {
      const Mat12 local = member.mass_matrix();
      for (const int i : {0, 1})
        for (const int j : {0, 1})
          M.block<6, 6>(6 * member.node[i], 6 * member.node[j]) += local.block<6, 6>(6 * i, 6 * j);
    }
  for (const Mass &mass : scene.masses)
    for (const std::string &point : mass.at)
      for (int c = 0; c < 3; ++c)
        M(6 * point_node.at(point) + c, 6 * point_node.at(point) + c) += mass.mass;
  return M;
}

} // namespace oracle
