// SPDX-License-Identifier: LGPL-2.1-or-later
#include "frame.h"

#include <algorithm>
#include <cmath>

namespace oracle {

namespace {
constexpr double near_enough = 1e-7; ///< places on a line that are one [m]

} // namespace

Frame::Frame(const Scene &scene) : scene(scene), on_pipe(scene.pipes.size()) {
  for (const Pipe &pipe : scene.pipes)
    paths.emplace_back(pipe);
  for (std::size_t p = 0; p < paths.size(); ++p)
    lay_pipe(p, breaks_of(p));
  for (std::size_t p = 0; p < paths.size(); ++p)
    for (const auto &[name, s] : paths[p].names)
      point_node[name] = node_at(paths[p].at(s));
  for (const Point &point : scene.points) // on a pipe, or free
    point_node[point.name] = node_at(point.position);
  add_joints();
  for (Member &member : members)
    member.prepare();
  assemble();
  hold();
}

int Frame::node_at(const Vec &position) {
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if ((nodes[i] - position).norm() < near_enough)
      return i;
  nodes.push_back(position);
  return nodes.size() - 1;
}

std::vector<double> Frame::breaks_of(const int pipe) const {
  const Path &path = paths[pipe];
  std::vector<double> breaks = path.start;
  breaks.push_back(path.length);
  for (const auto &[name, s] : path.names)
    breaks.push_back(s);
  std::vector<Vec> others;
  for (const Point &point : scene.points)
    others.push_back(point.position);
  for (const Path &other : paths) {
    others.push_back(other.at(0.));
    others.push_back(other.at(other.length));
  }
  for (const Vec &point : others) // where they lie on this pipe
    for (std::size_t i = 0; i < path.curves.size(); ++i) {
      const Curve &curve = path.curves[i];
      double s = (point - curve.begin).dot(curve.tangent);
      if (curve.radius > 0.) {
        const Vec arm = point - (curve.begin + curve.radius * curve.inward);
        s = curve.radius * std::atan2(arm.dot(curve.tangent), -arm.dot(curve.inward));
      }
      s = std::clamp(s, 0., curve.length);
      if ((curve.at(s) - point).norm() < near_enough)
        breaks.push_back(path.start[i] + s);
    }
  for (const Support &support : scene.supports)
    if (support.pipe == scene.pipes[pipe].name) {
      const auto place = [&](const std::string &name, const double otherwise) {
        for (const auto &[corner, s] : path.names)
          if (corner == name)
            return s;
        return otherwise;
      };
      const double from = place(support.from, 0.), to = place(support.to, path.length);
      for (int i = 1; !support.continuous && from + i * support.every < to - near_enough; ++i)
        breaks.push_back(from + i * support.every);
    }
  std::sort(breaks.begin(), breaks.end());
  breaks.erase(std::unique(breaks.begin(), breaks.end(),
                           [](const double a, const double b) { return b - a < near_enough; }),
               breaks.end());
  return breaks;
}

void Frame::lay_pipe(const int pipe, const std::vector<double> &breaks) {
  const Path &path = paths[pipe];
  const bool bedded =
      std::any_of(scene.loads.begin(), scene.loads.end(),
                  [](const Load &load) { return load.kind == "wind"; }) &&
      std::any_of(scene.supports.begin(), scene.supports.end(), [&](const Support &support) {
        return support.continuous && support.pipe == scene.pipes[pipe].name;
      });
  on_pipe[pipe].emplace_back(0., node_at(path.at(0.)));
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    const double from = breaks[i], to = breaks[i + 1], length = to - from;
    const std::size_t c = path.curve_at((from + to) / 2.);
    const Curve &curve = path.curves[c];
    const auto whole = [](const double number) {
      return std::max(1, static_cast<int>(std::ceil(number - 1e-6)));
    };
    const bool bend = curve.radius > 0.;
    const double longest = scene.cell_length > 0. ? scene.cell_length : bed_cell(pipe, from, to);
    int cells = longest > 0. ? whole(length / longest) : 1;
    const bool arc = bend && scene.arcs;
    if (arc && bedded) // a bed stands at the program's nodes
      cells = std::max(cells, whole(length / curve.radius / 0.03));
    if (bend && !scene.arcs)
      cells = whole(scene.cells_per_bend * length / curve.radius / (pi / 2.));
    if (scene.pipes[pipe].end_section >= 0 && !arc)
      cells = std::max(cells, 10); // a reducer is a staircase of ten
    for (int k = 0; k < cells; ++k) {
      const double a = from + length * k / cells, b = from + length * (k + 1) / cells;
      Member member;
      member.pipe = pipe;
      member.start = a;
      member.curve = curve.part(a - path.start[c], b - path.start[c]);
      member.node = {node_at(path.at(a)), node_at(path.at(b))};
      member.tangent = {member.curve.direction(0.), member.curve.direction(member.curve.length)};
      if (bend) {
        member.bend_radius = curve.radius;
        member.bend_axis = curve.axis();
      }
      give_section(member);
      if (bend && !arc) { // a chord, with the bend's flexibility
        Curve chord;
        chord.begin = member.curve.begin;
        const Vec way = member.curve.at(member.curve.length) - chord.begin;
        chord.tangent = way.normalized();
        chord.length = way.norm();
        member.curve = chord;
      }
      members.push_back(member);
      on_pipe[pipe].emplace_back(b, member.node[1]);
    }
  }
}

Figures Frame::figures_of(const Member &member) const {
  const Pipe &pipe = scene.pipes[member.pipe];
  const bool inches = scene.units.find("in ") == 0 || scene.units.find("ft ") == 0;
  const double middle = (member.start + member.curve.length / 2.) / paths[member.pipe].length;
  const Section &begin = scene.sections[pipe.section];
  return pipe.end_section < 0 ? figures(begin, inches)
                              : between(begin, scene.sections[pipe.end_section], middle, inches);
}

void Frame::give_section(Member &member) const {
  const Pipe &pipe = scene.pipes[member.pipe];
  const Material &material = scene.materials[pipe.material];
  const Figures f = figures_of(member);
  const double R = member.bend_radius, E = modulus(material), G = E / 2. / (1. + material.nu);
  const double k = R > 0. ? bend_flexibility(pipe, f, material, R) : 1.;
  const double stiffer = pipe.rigid ? 1000. : 1.;
  member.EA = stiffer * E * f.area;
  member.GA = stiffer * G * f.shear;
  member.GJ = stiffer * G * f.torsion;
  member.EI = stiffer * E * f.inertia / k;
  member.mass =
      (pipe.mass >= 0. ? pipe.mass / paths[member.pipe].length : material.density * f.area) +
      f.added;
  member.rotary = scene.sections[pipe.section].rotary_inertia ? material.density * f.inertia : 0.;
  member.twist = 2. * (material.density > 0. ? material.density * f.inertia
                                             : member.mass * f.inertia / f.area);
}

std::vector<Place> Frame::places(const Support &support) const {
  std::vector<Place> result;
  for (const std::string &point : support.at) {
    const int node = point_node.at(point);
    result.push_back({node, run_through(node), 1.});
  }
  if (support.pipe.empty())
    return result;
  for (std::size_t p = 0; p < paths.size(); ++p) {
    if (scene.pipes[p].name != support.pipe)
      continue;
    const auto place = [&](const std::string &name, const double otherwise) {
      for (const auto &[corner, s] : paths[p].names)
        if (corner == name)
          return s;
      return otherwise;
    };
    const double from = place(support.from, 0.), to = place(support.to, paths[p].length);
    if (support.continuous)
      for (std::size_t i = 0; i < on_pipe[p].size(); ++i) {
        const auto &[s, node] = on_pipe[p][i];
        if (s < from - near_enough || s > to + near_enough)
          continue;
        const double before = i == 0 ? s : std::max(on_pipe[p][i - 1].first, from),
                     after = i + 1 == on_pipe[p].size() ? s : std::min(on_pipe[p][i + 1].first, to);
        result.push_back(
            {node, tangent_of(p, node), (std::max(s - before, 0.) + std::max(after - s, 0.)) / 2.});
      }
    for (int i = 1; !support.continuous && from + i * support.every < to - near_enough; ++i)
      for (const auto &[s, node] : on_pipe[p])
        if (std::abs(s - from - i * support.every) < near_enough) {
          result.push_back({node, tangent_of(p, node), 1.});
          break;
        }
  }
  return result;
}

std::vector<Vec6> Frame::held(const Support &support, const Place &place) {
  std::vector<Vec6> directions;
  const auto translation = [&](const Vec &v) {
    Vec6 d = Vec6::Zero();
    d.head<3>() = v.cast<Real>();
    directions.push_back(d);
  };
  if (support.kind == "anchor" || support.kind == "restraint") {
    for (int c = 0; c < 6; ++c)
      if (support.kind == "anchor" || support.fixed[c])
        directions.push_back(Vec6::Unit(c));
  } else if (support.kind == "guide") {
    translation(across(place.tangent));
    if (std::abs(place.tangent[2]) > 1. - 1e-6) // a vertical pipe: both ways
      translation(place.tangent.cross(across(place.tangent)));
  } else if (support.kind == "line stop" || support.direction == "along")
    translation(place.tangent);
  else if (support.direction == "across")
    translation(across(place.tangent));
  else
    translation(support.normal.normalized());
  return directions;
}

void Frame::hold() {
  std::map<int, std::vector<Vec6>> at;
  for (const Support &support : scene.supports)
    if (support.holds_exactly())
      for (const Place &place : places(support))
        for (const Vec6 &direction : held(support, place))
          at[place.node].push_back(direction);
  std::set<int> named; // by steps
  for (const Step &step : scene.steps)
    for (const auto &load : step.loads)
      named.insert(load.first);
  for (const int l : named) {
    const Load &load = scene.loads[l];
    if (load.kind == "displacement") // holds its points in all steps, with the others' loads too
      for (std::size_t i = 0; i < load.at.size(); ++i)
        for (int c = 0; c < 6; ++c)
          if (load.given[i][c])
            at[point_node.at(load.at[i].first)].push_back(Vec6::Unit(c));
  }
  for (int v = 0; v < n() / 6; ++v)
    for (int c = 0; c < 6; ++c)
      if (!scene.free_motions[c] || (c >= 3 && !turns(v)))
        at[v].push_back(Vec6::Unit(c));
  basis = Matrix::Zero(n(), n());
  int columns = 0;
  for (int v = 0; v < n() / 6; ++v) {
    Mat6 whole = Mat6::Zero(); // sum of the projections onto what is held
    for (const Vec6 &d : at[v])
      whole += d * d.transpose();
    const Eigen::SelfAdjointEigenSolver<Mat6> eigen(whole);
    for (int i = 0; i < 6; ++i)
      if (eigen.eigenvalues()[i] < 1e-10L)
        basis.block(6 * v, columns++, 6, 1) =
            at[v].empty() ? Vec6(Vec6::Unit(i)) : Vec6(eigen.eigenvectors().col(i));
  }
  basis.conservativeResize(n(), columns);
}

bool Frame::turns(const int node) const {
  return std::any_of(members.begin(), members.end(), [&](const Member &member) {
    return std::count(member.node.begin(), member.node.end(), node) > 0;
  });
}

Vector Frame::imposed(const std::vector<Real> &factors) const {
  Vector d = Vector::Zero(n());
  for (std::size_t l = 0; l < scene.loads.size(); ++l)
    for (std::size_t i = 0; i < scene.loads[l].given.size(); ++i)
      for (int c = 0; c < 6; ++c)
        if (scene.loads[l].given[i][c])
          d[6 * point_node.at(scene.loads[l].at[i].first) + c] +=
              factors[l] * scene.loads[l].at[i].second[c] * (c < 3 ? 1. : pi / 180.);
  return d;
}

std::vector<Member::At> Frame::at(const int pipe, const double s, const Vector &d,
                                  const std::vector<Real> &factors) const {
  std::vector<Member::At> result;
  for (const Member &member : members) {
    const auto &along = on_pipe[pipe];
    if (member.pipe != pipe)
      continue;
    const auto end = std::find_if(along.begin(), along.end(), [&](const auto &node) {
      return node.first > member.start + near_enough;
    });
    const double from = member.start, to = end->first; // of a chord, along the bend
    if (s < from - near_enough || s > to + near_enough)
      continue;
    const double part = std::clamp((s - from) / (to - from), 0., 1.);
    result.push_back(
        member.at(part * member.curve.length, motions(member, d), load_on(member, factors)));
  }
  return result;
}

std::vector<Vec12> Frame::end_forces(const Vector &d, const std::vector<Real> &factors) const {
  std::vector<Vec12> result;
  for (const Member &member : members)
    result.push_back(member.stiffness() * motions(member, d) -
                     member.load_vector(load_on(member, factors)));
  return result;
}

Six Frame::spring_force(const Spring &spring, const Vector &d) const {
  Six force{};
  const int a = point_node.at(spring.at);
  for (int c = 0; c < 6; ++c) {
    const Real other = spring.to.empty() ? 0. : d[6 * point_node.at(spring.to) + c];
    force[c] = -spring.stiffness[c] * (d[6 * a + c] - other);
  }
  return force;
}

} // namespace oracle
