// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/generated/generated.h"
#include "scene/generated/random_numbers.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam::generated {

namespace {

struct Size {
  double diameter, wall, span; ///< [m]
};
constexpr std::array<Size, 5> sizes = {{{0.1143, 0.0060, 4.},
                                        {0.1683, 0.0071, 5.},
                                        {0.2191, 0.0082, 6.},
                                        {0.3239, 0.0095, 7.},
                                        {0.5080, 0.0095, 9.}}};

const std::array<Vector3, 3> axes = {
    {Vector3({1., 0., 0.}), Vector3({0., 1., 0.}), Vector3({0., 0., 1.})}};

/// A place for supports on a pipe.
struct Place {
  std::string name;
  Point3 position;
  Vector3 along; ///< unit
};

bool is_level(const Vector3 &along) { return std::abs(along[2]) < 0.9; }

/**
 * Makes the line, part by part. It is anchored where it begins, so that it is always held, and all
 * that supports stand on is held as well: there is an equilibrium for all loads.
 */
class RandomLine {
public:
  RandomLine(const unsigned int seed, const double stiffness, const LawLibrary &laws, Scene &scene)
      : random(seed), stiffness(stiffness), laws(laws), scene(scene) {}

  void build() {
    scene.materials = {{"steel", 2e11, 0.3, 7850., 1.2e-5}};
    size = random.one_of(sizes);
    add_section("pipe");
    const unsigned int axis = random.below(2), n_legs = 2 + random.below(11);
    lay("main", "A", Point3(), axis, n_legs);
    if (random.one_in(3))
      add_branch();
    add_supports();
    add_loads();
    add_steps();
    scene.quantities = sums_over_supports();
  }

private:
  /// A pipe full of water, or of nothing.
  void add_section(const std::string &name) {
    Section section = pipe_section(name, size.diameter, size.wall, 0.5, 0.);
    if (!random.one_in(3))
      section.added_mass = 1000. * section.bore_area();
    scene.sections.push_back(section);
  }

  /// The axis of the next leg: level three times out of four; never back along x, so that the route
  /// does not come upon itself.
  Vector3 direction(const unsigned int axis) {
    Vector3 result = axes[axis];
    if (axis > 0 && random.one_in(2))
      result *= -1.;
    if (random.one_in(6)) { // a slope, a skew run
      const unsigned int other = (axis + 1 + random.below(2)) % 3;
      result += random.uniform(0.05, 0.6) * axes[other];
      result /= result.norm();
    }
    return result;
  }

  unsigned int next_axis(const unsigned int axis) {
    if (axis == 2)
      return random.below(2);
    return random.one_in(4) ? 2 : 1 - axis;
  }

  /// A pipe of some legs with some bends, anchored where it begins unless it is a branch.
  void lay(const std::string &name, const std::string &first, const Point3 &start,
           unsigned int axis, const unsigned int n_legs) {
    std::vector<Vector3> legs;
    for (unsigned int i = 0; i < n_legs; ++i, axis = next_axis(axis))
      legs.push_back(direction(axis));
    Pipe pipe;
    pipe.name = name;
    pipe.section = scene.sections.size() - 1;
    pipe.route = {{first, start}};
    Point3 begin = start;
    double cut = 0.; // what a bend of at most 120 degrees takes of the leg, and some more
    for (unsigned int i = 0; i < n_legs; ++i) {
      const double length = random.uniform(i == 0 ? 8. : 4., 20.);
      const bool bend = i + 1 < n_legs && legs[i] * legs[i + 1] > -0.5 && random.one_in(2);
      const double radius = bend ? 1.5 * size.diameter : 0.;
      add_places(pipe, begin, legs[i], cut, length - 2. * radius, i == 0);
      begin += length * legs[i];
      pipe.route.push_back({name + "_" + std::to_string(i + 1), begin, radius});
      cut = 2. * radius;
    }
    scene.pipes.push_back(pipe);
    Restraint anchors = anchor("anchor_" + name, {});
    if (name == "main")
      anchors.placement.points.push_back(first);
    if (random.one_in(2))
      anchors.placement.points.push_back(pipe.route.back().name);
    if (!anchors.placement.points.empty())
      scene.restraints.push_back(anchors);
  }

  /// Places for supports on a leg from @p begin, from one distance to another [m]; at least one if
  /// @p needed.
  void add_places(Pipe &pipe, const Point3 &begin, const Vector3 &along, const double from,
                  const double to, const bool needed) {
    double s = from + random.uniform(0.3, 1.) * (needed ? to - from : size.span);
    if (needed)
      s = std::min(s, to - 0.5);
    for (; s < to - 0.3; s += random.uniform(0.5, 1.4) * size.span) {
      places.push_back({"S" + std::to_string(places.size() + 1), begin + s * along, along});
      pipe.route.push_back({places.back().name, places.back().position});
    }
  }

  /// A branch from one of the main pipe's places, across it.
  void add_branch() {
    const Place tee = places[random.below(places.size())];
    size = random.one_of(sizes);
    add_section("branch");
    unsigned int axis = 0; // that of the tee's leg
    for (unsigned int d = 1; d < 3; ++d)
      if (std::abs(tee.along[d]) > std::abs(tee.along[axis]))
        axis = d;
    axis = next_axis(axis);
    lay("branch", tee.name, tee.position, axis, 1 + random.below(4));
  }

  double friction() {
    const unsigned int kind = random.below(10);
    if (kind == 0)
      return 0.;
    return kind < 7 ? random.uniform(0.05, 0.6) : random.uniform(0.6, 3.);
  }

  /// Rigid, or one time out of ten elastic.
  double rigidity() {
    constexpr std::array<double, 5> choices = {{1e5, 1e6, 1e7, 1e8, 1e9}};
    const double elastic = random.one_of(choices);
    return random.one_in(10) ? elastic : stiffness;
  }

  FrictionSupport element(const std::string &name, const Place &place, const double gap) {
    const double f = friction(), axial = rigidity(), shear = rigidity();
    FrictionSupport support = coulomb_support(laws, name, f, axial, shear, 0.);
    support.parameters[parameter_index(laws.find("coulomb"), "Gap")] = gap;
    support.placement.points = {place.name};
    return support;
  }

  void add_supports() {
    const std::vector<Place> all = places;
    for (const Place &place : all) {
      if (is_level(place.along))
        add_rest(place);
      switch (random.below(12)) {
      case 0:
      case 1:
        add_guide(place);
        break;
      case 2:
        add_pair("guide_" + place.name, Direction::Kind::across, place);
        break;
      case 3:
        add_pair("stop_" + place.name, Direction::Kind::along, place);
        break;
      default:
        break;
      }
    }
  }

  void add_rest(const Place &place) {
    const double gap = random.one_in(6) ? random.uniform(0., 0.02) : 0.;
    FrictionSupport rest = element("rest_" + place.name, place, gap);
    if (random.one_in(8)) // inclined
      for (unsigned int d = 0; d < 2; ++d)
        rest.normal.vector[d] = random.uniform(-0.5, 0.5);
    rest.normal.vector /= rest.normal.vector.norm();
    switch (random.below(12)) {
    case 0:
      stand_on_springs(place, rest);
      break;
    case 1:
      stand_on_beam(place, rest);
      break;
    default:
      break;
    }
    scene.supports.push_back(rest);
  }

  void stand_on_springs(const Place &place, FrictionSupport &rest) {
    rest.ground = "G_" + place.name;
    scene.points.push_back({rest.ground, place.position - rest.length * rest.normal.vector});
    constexpr std::array<double, 4> choices = {{1e5, 1e6, 1e7, 1e8}};
    Spring spring{"spring_" + place.name, rest.ground, "", {}};
    for (unsigned int d = 0; d < 3; ++d)
      spring.stiffness[d] = random.one_of(choices);
    scene.springs.push_back(spring);
  }

  /// A beam across the pipe, below it, anchored at one end or at both.
  void stand_on_beam(const Place &place, FrictionSupport &rest) {
    rest.ground = "G_" + place.name;
    const Point3 middle = place.position - rest.length * rest.normal.vector;
    Vector3 across = cross_product_3d(axes[2], place.along);
    across /= across.norm();
    Pipe beam;
    beam.name = "beam_" + place.name;
    const double before = random.uniform(0.3, 3.), after = random.uniform(0.3, 3.);
    beam.route = {{"U_" + place.name, middle - before * across},
                  {rest.ground, middle},
                  {"V_" + place.name, middle + after * across}};
    scene.pipes.push_back(beam);
    std::vector<std::string> anchored = {beam.route.front().name};
    if (random.one_in(2))
      anchored.push_back(beam.route.back().name);
    scene.restraints.push_back(anchor("anchor_" + place.name, anchored));
  }

  /// Exact, without friction.
  void add_guide(const Place &place) {
    Restraint guide;
    guide.name = "guide_" + place.name;
    guide.kind = "guide";
    guide.placement.points = {place.name};
    guide.translations = {{Direction::Kind::across, Vector3(), 1.}};
    scene.restraints.push_back(guide);
  }

  /// Two friction elements face to face, now and then without any play.
  void add_pair(const std::string &name, const Direction::Kind kind, const Place &place) {
    const double play = random.uniform(0., 0.01);
    const bool tight = random.one_in(8);
    FrictionSupport support = element(name + ".plus", place, tight ? 0. : play);
    support.normal = {kind, Vector3(), 1.};
    scene.supports.push_back(support);
    support.name = name + ".minus";
    support.normal.sign = -1.;
    scene.supports.push_back(support);
  }

  void add_loads() {
    Load hot = temperature_load("hot", random.uniform(20., 300.));
    for (const Pipe &pipe : scene.pipes)
      if (pipe.name == "main" || pipe.name == "branch")
        hot.pipes.push_back(pipe.name);
    scene.loads = {weight_load(), hot};
    if (random.one_in(2))
      return;
    Load force;
    force.name = "force";
    force.kind = Load::Kind::force;
    const Section &section = scene.sections.front();
    const double span_weight = 9.81 * 5. * (7850. * section.area + section.added_mass);
    for (unsigned int n = 1 + random.below(3); n > 0; --n) {
      Load::AtPoint at;
      at.point = places[random.below(places.size())].name;
      for (unsigned int d = 0; d < 3; ++d)
        at.value[d] = random.uniform(-3., 3.) * span_weight;
      force.at.push_back(at);
    }
    scene.loads.push_back(force);
  }

  void add_steps() {
    const auto add = [&](const std::string &name, const bool hot, const bool force) {
      std::vector<std::pair<unsigned int, double>> loads = {{0, 1.}};
      if (hot)
        loads.emplace_back(1, 1.);
      if (force)
        loads.emplace_back(2, 1.);
      scene.steps.push_back(static_step(name, loads, 1 + random.below(5)));
    };
    const bool force = scene.loads.size() == 3;
    if (random.one_in(4)) {
      add("all", true, force);
      return;
    }
    add("weight", false, false);
    add("heat", true, false);
    if (force)
      add("push", true, true);
    const bool force_stays = force && random.one_in(2);
    add("cool", false, force_stays);
    if (random.one_in(3))
      add("heat_again", true, force_stays);
  }

  RandomNumbers random;
  const double stiffness;
  const LawLibrary &laws;
  Scene &scene;
  Size size{};
  std::vector<Place> places;
};

} // namespace

void declare_random(ParameterReader &in) {
  in.declare_count("Seed", 1, 0, "Every seed is another line.", 2000000000);
  in.declare_number("Stiffness", 0., "N", 0., 1e300,
                    "Rigidity ES and GS of the friction elements, of length 1 m; 0: rigid. One in "
                    "ten is elastic in any case.");
}

void build_random(const ParameterReader &in, const LawLibrary &laws, Scene &scene) {
  RandomLine(in.count("Seed"), in.number("Stiffness"), laws, scene).build();
}

} // namespace frictionbeam::generated
