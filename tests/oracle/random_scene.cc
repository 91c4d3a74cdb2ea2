// SPDX-License-Identifier: LGPL-2.1-or-later
#include "generator.h"
#include "path.h"

#include <algorithm>
#include <cmath>

namespace oracle {

void Generator::materials() {
  for (int i = 0, n = random.whole(1, 2); i < n; ++i) {
    Material m;
    m.name = new_name("steel");
    m.E = random.number(7e10, 2.2e11);
    m.nu = random.number(0., 0.45);
    m.density = random.chance(0.1) && !kinds.transient ? 0. : random.number(2000., 9000.);
    m.expansion = random.number(8e-6, 2.4e-5);
    if (random.chance(0.3)) {
      for (double t = random.number(-80., 10.); t < 350.; t += random.number(60., 160.))
        m.table.push_back({t, random.number(1.5e11, 2.1e11), random.number(1e-5, 1.9e-5)});
      m.modulus_temperature = random.number(-50., 400.);
    }
    scene.materials.push_back(m);
  }
}

void Generator::sections() {
  using Shear = Section::Shear;
  for (int i = 0, n = random.whole(1, 3); i < n; ++i) {
    Section s;
    s.name = new_name("pipe_");
    if (random.chance(0.25)) {
      const std::vector<std::pair<std::string, std::string>> sizes = {
          {"NPS 2", "40"},  {"NPS 4", "40"},  {"NPS 6", "40"}, {"NPS 6", "80"},
          {"NPS 8", "STD"}, {"DN 250", "40"}, {"DN 300", "XS"}};
      std::tie(s.size, s.schedule) = random.pick(sizes);
    } else {
      s.diameter = random.number(0.06, 0.6);
      s.wall = s.diameter * random.number(0.01, random.chance(0.1) ? 0.5 : 0.1);
    }
    s.shear = random.pick(
        std::vector<Shear>{Shear::half, Shear::half, Shear::cowper, Shear::none, Shear::given});
    if (s.shear == Shear::given)
      s.shear_area = random.number(1e-3, 1e-2);
    if (random.chance(0.3))
      s.added_mass = random.number(1., 200.);
    if (random.chance(0.3))
      s.contents = random.number(1., 1500.);
    if (random.chance(0.2)) {
      s.insulation = random.number(0.01, 0.2);
      s.insulation_density = random.number(50., 300.);
    }
    s.rotary_inertia = random.chance(0.8);
    scene.sections.push_back(s);
  }
}

/// Legs from @p start; corners are sharp or rounded.
void Generator::add_pipe(const std::string &from, const Vec &start, Vec direction,
                         const bool only_one_leg) {
  Pipe pipe;
  pipe.name = new_name("line");
  pipe.section = random.whole(0, scene.sections.size() - 1);
  pipe.material = random.whole(0, scene.materials.size() - 1);
  Corner first;
  first.name = from.empty() ? new_name("P") : from;
  first.position = start;
  first.by_name = !from.empty();
  pipe.route.push_back(first);
  const int legs = only_one_leg ? 1 : random.whole(1, 4);
  double room = 0., tangent = 0.; // length of the last leg, and what its bend at the start takes
  for (int leg = 0; leg < legs; ++leg) {
    const double length = random.number(1., 6.);
    Corner corner;
    corner.position = pipe.route.back().position + length * direction;
    if (random.chance(0.85) || leg + 1 == legs)
      corner.name = new_name("P");
    corner.relative = random.chance(0.5);
    if (leg > 0 && random.chance(0.7)) { // round the corner before
      const Vec before = pipe.route[leg].position - pipe.route[leg - 1].position;
      const double angle = std::acos(std::clamp(before.normalized().dot(direction), -1., 1.));
      const double most = 0.45 * std::min(room - tangent, length);
      tangent = random.number(0.2, 1.) * most;
      pipe.route[leg].bend = tangent / std::tan(angle / 2.);
    } else
      tangent = 0.;
    room = length;
    pipe.route.push_back(corner);
    Vec next;
    double cosine;
    do {
      if (random.chance(0.6)) {
        const double sign = random.chance(0.5) ? 1. : -1.;
        next = sign * Vec::Unit(random.whole(0, 2));
      } else
        next = random.direction();
      cosine = next.dot(direction);
    } while (cosine > 0.9 || cosine < -0.7);
    direction = next;
  }
  using Flexibility = Pipe::Flexibility;
  pipe.flexibility =
      random.pick(std::vector<Flexibility>{Flexibility::code, Flexibility::code, Flexibility::none,
                                           Flexibility::von_karman, Flexibility::given});
  pipe.flexibility_factor = random.number(1., 12.);
  if (random.chance(0.2) && pipe.flexibility == Flexibility::code)
    pipe.stiffening_pressure = random.number(1e5, 2e7);
  if (random.chance(0.1))
    pipe.rigid = true;
  if (random.chance(0.15))
    pipe.mass = random.number(0., 2000.);
  const bool straight = std::all_of(pipe.route.begin(), pipe.route.end(),
                                    [](const Corner &c) { return c.bend == 0.; });
  if (straight && random.chance(0.25))
    pipe.end_section = random.whole(0, scene.sections.size() - 1);
  scene.pipes.push_back(pipe);
  points_on(pipe);
}

void Generator::points_on(const Pipe &pipe) {
  const Path path(pipe);
  for (const auto &[name, s] : path.names) {
    const Curve &curve = path.curves[path.curve_at(std::min(s, path.length - 1e-6))];
    if (std::abs(curve.tangent[2]) > 0.99 || std::abs(curve.direction(curve.length)[2]) > 0.99)
      vertical.insert(name);
    if (std::count(candidates.begin(), candidates.end(), name) > 0)
      continue;
    candidates.push_back(name);
    if (curve.radius == 0. && s > 0. && s < path.length) {
      on_straight.insert(name);
      places[name] = path.at(s);
    }
  }
  for (std::size_t i = 0; i < path.curves.size(); ++i)
    if (random.chance(0.35) && !pipe.rigid) {
      const Curve &curve = path.curves[i];
      const double s = curve.length * random.number(0.15, 0.45);
      const Point point{new_name("Q"), curve.at(s)};
      if (std::abs(curve.direction(s)[2]) > 0.99)
        vertical.insert(point.name);
      if (curve.radius == 0.) {
        on_straight.insert(point.name);
        places[point.name] = point.position;
      }
      scene.points.push_back(point);
      candidates.push_back(point.name);
    }
  ends.emplace_back(pipe.route.back().name, pipe.route.back().position);
}

void Generator::pipes() {
  Vec start;
  for (const int c : {2, 1, 0})
    start[c] = random.number(-5., 5.);
  add_pipe("", start, Vec::Unit(random.whole(0, 2)), false);
  for (int i = 0, n = random.whole(0, 2); i < n; ++i) {
    if (random.chance(0.5)) { // go on at the last pipe's end
      const auto [name, position] = ends.back();
      ends.pop_back();
      const Pipe &last = scene.pipes.back();
      const Path path(last);
      add_pipe(name, position, path.curves.back().direction(path.curves.back().length),
               random.chance(0.5));
    } else if (!on_straight.empty()) { // a branch
      const std::vector<std::string> list(on_straight.begin(), on_straight.end());
      const std::string name = random.pick(list);
      on_straight.erase(name);
      const bool only_one_leg = random.chance(0.5);
      add_pipe(name, places.at(name), random.direction(), only_one_leg);
      Tee tee;
      tee.name = new_name("tee");
      tee.at = name;
      tee.branch = scene.pipes.back().name;
      if (random.chance(0.7))
        scene.tees.push_back(tee);
    }
  }
  const auto is_rigid = [&](const std::string &name) {
    return std::any_of(scene.pipes.begin(), scene.pipes.end(),
                       [&](const Pipe &pipe) { return pipe.name == name && pipe.rigid; });
  };
  for (Tee &tee : scene.tees)
    if (is_rigid(tee.branch))
      continue;
    else if (random.chance(0.3) && tee.at[0] == 'P') // the run names a corner there
      tee.code = true;
    else if (random.chance(0.7)) {
      tee.in_plane = std::pow(10., random.number(4., 8.));
      tee.out_of_plane = std::pow(10., random.number(4., 8.));
    }
  // The two ends of a reducer have rotary inertia or neither has.
  for (const Pipe &pipe : scene.pipes)
    if (pipe.end_section >= 0 && scene.sections[pipe.section].rotary_inertia !=
                                     scene.sections[pipe.end_section].rotary_inertia)
      for (Section &section : scene.sections)
        section.rotary_inertia = true;
}

Scene Generator::make() {
  const std::vector<std::string> units = {"si",
                                          "si",
                                          "mm N",
                                          "mm N MPa",
                                          "in lb psi F",
                                          "ft kip ksi lbm",
                                          "cm kgf kg bar C",
                                          "m kN kPa t",
                                          "in lb slug F",
                                          "m N kg MPa F"};
  scene.units = random.pick(units);
  if (random.chance(0.4))
    scene.installation_temperature = random.number(-30., 40.);
  materials();
  sections();
  pipes();
  hold_ends();
  supports();
  if (kinds.contacts)
    contacts();
  if (random.chance(0.1))
    repeated();
  components();
  loads();
  steps();
  scene.stations = random.whole(0, 3);
  if (random.chance(0.25)) {
    scene.arcs = false;
    scene.cells_per_bend = random.whole(1, 8);
  }
  if (random.chance(0.2))
    scene.cell_length = random.number(0.7, 3.);
  scene.monitors = candidates;
  if (!kinds.contacts && !kinds.transient && random.chance(0.3)) {
    scene.modes = random.whole(1, 5);
    scene.lumped = random.chance(0.3);
  }
  extras();
  return scene;
}

Scene random_scene(const std::uint64_t seed, const Kinds &kinds) {
  return Generator(seed, kinds).make();
}

} // namespace oracle
