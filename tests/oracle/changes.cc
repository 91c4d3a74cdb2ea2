// SPDX-License-Identifier: LGPL-2.1-or-later
#include "changes.h"
#include "path.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace oracle {

namespace {

/// Where an axis goes.
int place_of(const Eigen::Matrix3d &Q, const int axis) {
  for (int d = 0; d < 3; ++d)
    if (Q(d, axis) != 0.)
      return d;
  return axis;
}

template <typename Value>
std::array<Value, 6> permuted(const Eigen::Matrix3d &Q, const std::array<Value, 6> &values) {
  std::array<Value, 6> result{};
  for (int d = 0; d < 3; ++d) {
    result[place_of(Q, d)] = values[d];
    result[3 + place_of(Q, d)] = values[3 + d];
  }
  return result;
}

/// A force and a moment, or a translation and a rotation: the second turns with the sign of Q.
Six turned(const Eigen::Matrix3d &Q, const Six &values) {
  const Vec polar = Q * Vec(values[0], values[1], values[2]),
            axial = Q.determinant() * (Q * Vec(values[3], values[4], values[5]));
  return {polar[0], polar[1], polar[2], axial[0], axial[1], axial[2]};
}

/// A leg of a pipe, and a place on its straight part.
bool find_place(const Scene &scene, Random &random, int &pipe, int &leg, Vec &place) {
  pipe = random.whole(0, scene.pipes.size() - 1);
  const std::vector<Corner> &route = scene.pipes[pipe].route;
  leg = random.whole(0, route.size() - 2);
  const auto taken_by_bend = [&](const std::size_t i) {
    if (route[i].bend == 0.)
      return 0.;
    const Vec a = (route[i].position - route[i - 1].position).normalized(),
              b = (route[i + 1].position - route[i].position).normalized();
    return route[i].bend * std::tan(std::acos(std::clamp(a.dot(b), -1., 1.)) / 2.);
  };
  const Vec way = route[leg + 1].position - route[leg].position;
  const double low = taken_by_bend(leg), high = way.norm() - taken_by_bend(leg + 1);
  const double s = low + (high - low) * random.number(0.2, 0.8);
  place = route[leg].position + s * way.normalized();
  const double least = 0.05 * way.norm(); // from every other point of the run
  for (const Point &point : scene.points)
    if ((point.position - place).norm() < least)
      return false;
  return high - low > 2. * least;
}

} // namespace

void turn(Scene &scene, const Eigen::Matrix3d &Q) {
  const bool vertical_stays = Q(2, 2) == 1.;
  for (Pipe &pipe : scene.pipes)
    for (Corner &corner : pipe.route)
      corner.position = Q * corner.position;
  for (Point &point : scene.points)
    point.position = Q * point.position;
  for (Support &support : scene.supports) {
    support.normal = Q * support.normal;
    for (auto &row : support.ground_motion) {
      const Vec x = Q * Vec(row[1], row[2], row[3]);
      row = {row[0], x[0], x[1], x[2]};
    }
    support.fixed = permuted(Q, support.fixed);
    if ((support.kind == "rest" || support.kind == "rod") && !vertical_stays)
      support.kind = "friction";
  }
  for (Spring &spring : scene.springs) {
    spring.stiffness = permuted(Q, spring.stiffness);
    spring.damping = permuted(Q, spring.damping);
  }
  for (Load &load : scene.loads) {
    load.vector = Q * load.vector;
    for (auto &at : load.at)
      at.second = turned(Q, at.second);
    for (auto &given : load.given)
      given = permuted(Q, given);
  }
  for (Initial &initial : scene.initial) {
    initial.displacement = turned(Q, initial.displacement);
    initial.velocity = turned(Q, initial.velocity);
  }
  for (Spectrum &spectrum : scene.spectra)
    spectrum.directions = Q.cwiseAbs() * spectrum.directions;
  for (Nozzle &nozzle : scene.nozzles)
    nozzle.allowed = permuted(Q, nozzle.allowed);
  scene.free_motions = permuted(Q, scene.free_motions);
}

void turn_askew(Scene &scene, const Eigen::Matrix3d &Q) {
  for (Pipe &pipe : scene.pipes)
    for (Corner &corner : pipe.route)
      corner.position = Q * corner.position;
  for (Point &point : scene.points)
    point.position = Q * point.position;
  for (Support &support : scene.supports) {
    support.normal = Q * support.normal;
    support.axes = Q * support.axes;
    for (auto &row : support.ground_motion) {
      const Vec x = Q * Vec(row[1], row[2], row[3]);
      row = {row[0], x[0], x[1], x[2]};
    }
  }
  for (Spring &spring : scene.springs) {
    spring.axes = Q * spring.axes;
    spring.as_matrix = spring.damping == Six{};
  }
  for (Hanger &hanger : scene.hangers)
    hanger.direction = Q * hanger.direction;
  for (Load &load : scene.loads) {
    load.vector = Q * load.vector;
    if (load.kind == "displacement")
      load.axes = Q * load.axes;
    else
      for (auto &at : load.at)
        at.second = turned(Q, at.second);
  }
  for (Initial &initial : scene.initial) {
    initial.displacement = turned(Q, initial.displacement);
    initial.velocity = turned(Q, initial.velocity);
  }
}

bool reverse_routes(Scene &scene) {
  for (const Pipe &pipe : scene.pipes)
    if (pipe.end_section >= 0 &&
        (scene.sections[pipe.section].shear != scene.sections[pipe.end_section].shear ||
         scene.sections[pipe.section].shear == Section::Shear::given ||
         scene.sections[pipe.section].shear == Section::Shear::cowper ||
         scene.sections[pipe.section].rotary_inertia !=
             scene.sections[pipe.end_section].rotary_inertia))
      return false; // which count at a reducer's beginning
  for (const Joint &joint : scene.joints)
    for (const Pipe &pipe : scene.pipes)
      if (pipe.name == joint.pipe && pipe.route.front().name != joint.at &&
          pipe.route.back().name != joint.at)
        return false; // it stands after its point
  for (const Support &support : scene.supports)
    if (!support.pipe.empty() ||
        (scene.modes > 0 && support.rotations != Support::Rotations::none &&
         (support.kind == "guide" || support.kind == "line stop")))
      return false; // its places, and which of two idle halves holds in modes, follow the route
  for (const Tee &tee : scene.tees)
    if ((tee.code || tee.in_plane > 0.) && tee.at[0] == 'P')
      return false; // at a corner of the run: its plane is that of one leg
  for (Pipe &pipe : scene.pipes) {
    std::reverse(pipe.route.begin(), pipe.route.end());
    for (Corner &corner : pipe.route)
      corner.relative = false;
    if (pipe.end_section >= 0)
      std::swap(pipe.section, pipe.end_section);
  }
  return true;
}

bool add_a_point(Scene &scene, const std::string &name, Random &random) {
  int pipe, leg;
  Vec place;
  if (!find_place(scene, random, pipe, leg, place) || scene.pipes[pipe].end_section >= 0)
    return false;
  scene.points.push_back({name, place});
  return true;
}

bool cut_a_pipe(Scene &scene, Random &random) {
  int which, leg;
  Vec place;
  if (!find_place(scene, random, which, leg, place))
    return false;
  Pipe first = scene.pipes[which], second = first;
  if (first.end_section >= 0)
    return false;
  for (const Support &support : scene.supports)
    if (support.pipe == first.name)
      return false;
  if (first.mass > 0.) {
    const double whole = Path(first).length;
    Pipe beginning = first;
    beginning.route.resize(leg + 1);
    Corner corner;
    corner.position = place;
    beginning.route.push_back(corner);
    first.mass *= Path(beginning).length / whole;
    second.mass -= first.mass;
  }
  second.name = first.name + "b";
  Corner corner;
  corner.name = "CUT";
  corner.position = place;
  first.route.resize(leg + 1);
  first.route.push_back(corner);
  second.route.erase(second.route.begin(), second.route.begin() + leg + 1);
  corner.by_name = true;
  second.route.insert(second.route.begin(), corner);
  std::set<std::string> on_second;
  for (const auto &[name, s] : Path(second).names)
    on_second.insert(name);
  for (Joint &joint : scene.joints)
    if (joint.pipe == first.name && on_second.count(joint.at) > 0)
      joint.pipe = second.name;
  for (Tee &tee : scene.tees)
    if (tee.branch == first.name && on_second.count(tee.at) > 0)
      tee.branch = second.name;
  for (Load &load : scene.loads)
    if (std::count(load.pipes.begin(), load.pipes.end(), first.name) > 0)
      load.pipes.push_back(second.name);
  for (Initial &initial : scene.initial)
    if (!initial.pipes.empty())
      return false; // a node more starts with it
  scene.pipes[which] = first;
  scene.pipes.insert(scene.pipes.begin() + which + 1, second);
  return true;
}

void scale_lengths(Scene &scene, const double a) {
  const double a2 = a * a, a3 = a2 * a;
  const auto scale = [](Six &values, const double translations, const double rotations) {
    for (int c = 0; c < 6; ++c)
      values[c] *= c < 3 ? translations : rotations;
  };
  for (Section &s : scene.sections) {
    for (double *length : {&s.diameter, &s.wall, &s.insulation, &s.corrosion})
      *length *= a;
    s.area *= a2;
    s.shear_area *= a2;
    s.added_mass *= a2;
    s.inertia *= a2 * a2;
    s.torsion *= a2 * a2;
  }
  for (Pipe &pipe : scene.pipes) {
    for (Corner &corner : pipe.route) {
      corner.position *= a;
      corner.bend *= a;
    }
    if (pipe.mass > 0.)
      pipe.mass *= a3;
  }
  for (Point &point : scene.points)
    point.position *= a;
  for (Support &s : scene.supports) {
    for (double *length : {&s.every, &s.length, &s.gap, &s.patch_radius})
      *length *= a;
    for (double *force : {&s.normal_force, &s.axial_rigidity, &s.shear_rigidity})
      *force *= s.continuous ? a : a2; // per metre
    s.torsional_rigidity *= s.continuous ? a3 : a2 * a2;
    for (auto &row : s.ground_motion)
      for (double &value : row)
        value *= a;
    s.drag *= a3; // [N s]
    s.whip.stiffness *= a;
    s.whip.coefficient *= std::pow(a, 2. - s.whip.exponent);
    s.snubber.stiffness *= a;
    s.snubber.acceleration /= a;
    s.snubber.dead_band *= a;
    s.snubber.drag *= a2;
  }
  for (Spring &s : scene.springs) {
    scale(s.stiffness, a, a3);
    scale(s.damping, a2, a2 * a2); // times a time more
  }
  for (Mass &mass : scene.masses)
    mass.mass *= a3;
  for (Joint &j : scene.joints) {
    j.axial *= a;
    j.lateral *= a;
    j.bending *= a3;
    j.torsion *= a3;
    j.thrust_area *= a2;
  }
  for (Tee &t : scene.tees) {
    t.pad *= a;
    t.crotch_radius *= a;
    t.in_plane *= a3;
    t.out_of_plane *= a3;
  }
  for (Hanger &h : scene.hangers) {
    h.stiffness *= a;
    h.cold_load *= a2;
  }
  for (Load &load : scene.loads) {
    if (load.kind == "weight" || load.kind == "ground acceleration")
      load.vector /= a;
    else if (load.kind == "line force")
      load.vector *= a;
    for (auto &at : load.at)
      if (load.kind == "force")
        scale(at.second, a2, a3);
      else
        scale(at.second, a, 1.);
    for (auto &row : load.history)
      row[0] *= a;
  }
  for (Step &step : scene.steps) {
    step.duration *= a;
    step.ramp *= a;
  }
  for (Initial &initial : scene.initial) {
    scale(initial.displacement, a, 1.);
    scale(initial.velocity, 1., 1. / a);
  }
  for (Spectrum &spectrum : scene.spectra)
    for (auto &point : spectrum.curve)
      point = {point[0] / a, point[1] / a};
  for (Nozzle &nozzle : scene.nozzles)
    scale(nozzle.allowed, a2, a3);
  for (Setting &setting : scene.settings)
    setting.value *= std::pow(a, setting.length + setting.time);
  for (auto &[entry, value] : scene.more)
    if (entry == "Time/Step")
      value = std::to_string(std::stod(value) * a * 1e6) + "e-6";
  scene.cell_length *= a;
}

bool stand_on_pipes(Scene &scene) {
  for (Support &support : scene.supports) {
    const bool rest = support.kind == "rest" || support.kind == "friction";
    if (!rest || support.at.size() != 1 || support.normal_force > 0. || !support.ground.empty() ||
        !support.ground_motion.empty())
      continue;
    Vec on = Vec::Zero();
    bool found = false;
    for (const Pipe &pipe : scene.pipes)
      for (const Corner &corner : pipe.route)
        if (corner.name == support.at.front() && corner.bend == 0.) {
          on = corner.position;
          found = true;
        }
    for (const Point &point : scene.points)
      if (point.name == support.at.front()) {
        on = point.position;
        found = true;
      }
    if (!found)
      continue;
    Pipe post;
    post.name = "post_" + support.name;
    Corner top, foot;
    top.name = "top_" + support.name;
    top.position = on - support.length * support.normal.normalized();
    foot.name = "foot_" + support.name;
    foot.position = top.position - Vec(0.11, 0.07, 0.5);
    post.route = {top, foot};
    bool in_the_way = false; // of a pipe, which would be held there
    for (const Pipe &pipe : scene.pipes)
      for (std::size_t i = 0; i + 1 < pipe.route.size(); ++i) {
        const Vec from = pipe.route[i].position, way = pipe.route[i + 1].position - from;
        const double part = std::clamp((top.position - from).dot(way) / way.squaredNorm(), 0., 1.);
        in_the_way = in_the_way || (top.position - from - part * way).norm() < 1e-3;
      }
    if (in_the_way)
      continue;
    scene.pipes.push_back(post);
    Support anchor;
    anchor.name = "anchor_" + support.name;
    anchor.kind = "anchor";
    anchor.at = {top.name, foot.name};
    support.ground = top.name;
    scene.supports.push_back(anchor);
    return true; // one is enough; the list has moved
  }
  return false;
}

} // namespace oracle
