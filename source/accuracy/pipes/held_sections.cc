// SPDX-License-Identifier: LGPL-2.1-or-later
#include "accuracy/pipes/held_sections.h"

#include "accuracy/support_models.h"
#include "mesh/places_on_pipe.h"
#include "model/unknowns/reduced_space.h"
#include "results/quantity/shown_quantity.h"
#include "scene/support_pair.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam::accuracy {

namespace {

constexpr double same_place = 1e-6; // [m]

/// What a straight pipe's wall is made of.
struct Wall {
  double r, t, E, nu, EI, EA, GA;

  Wall(const Scene &scene, const Pipe &pipe) {
    const Section &section = scene.sections[pipe.section];
    const Material &material = scene.materials[pipe.material];
    r = section.outer_radius - section.wall / 2.;
    t = section.wall;
    E = material.youngs_modulus;
    nu = material.poissons_ratio;
    EI = E * section.inertia;
    EA = E * section.area;
    GA = E / (2. * (1. + nu)) * section.area / 2.;
  }
  double length_of_bending() const { return std::sqrt(r * t) / 1.285; }
  double mean_by_curvature() const { return nu * r * r / 2.; }
  double compliance_of_ring() const {
    constexpr double of_line_load = 0.0511, of_spread = 1.575;
    return of_line_load * std::sqrt(r / t) * std::max(0., 1. - of_spread * t / r) / (E * t);
  }
};

/// A place on a straight run.
struct Place {
  unsigned int pipe = 0;
  double s = 0., before = 0., after = 0.; ///< straight pipe on both sides [m]
  Vector3 tangent;
  bool is_end = false; ///< whether pipe is on one side only
};

/// What the line has at a place at one instant.
struct Forces {
  double N = 0.;
  Vector3 shear, moment, held; ///< the latter: by restraints, on the pipe
};

class HeldSections {
public:
  HeldSections(Scene whole, const Results &beams, const HeldAs as)
      : scene(std::move(whole)), beams(beams), as(as) {
    for (const Pipe &pipe : scene.pipes)
      paths.emplace_back(pipe, scene.units);
  }

  Scene hold() {
    std::vector<Point3> done;
    for (const Restraint &restraint : scene.restraints)
      for (const RestraintInfo &info : beams.restraints)
        if (is_place_of(info.name, restraint.name)) {
          const auto place = place_at(info.position);
          if (!place || is_supported(info.position))
            continue;
          const bool is_first = std::none_of(done.begin(), done.end(), [&](const Point3 &one) {
            return one.distance(info.position) < same_place;
          });
          done.push_back(info.position);
          if (restraint.is_anchor())
            add_anchor(*place, info.position);
          else
            add_guide(restraint, *place, info.position, is_first);
        }
    return std::move(scene);
  }

  /// Of the section at a point, against the line.
  std::optional<Motion> motion_of_section(const Point3 &position, const Frame &frame) const {
    const auto place = place_at(position);
    if (!place || is_supported(position) ||
        std::any_of(beams.restraints.begin(), beams.restraints.end(),
                    [&](const auto &one) { return one.position.distance(position) < same_place; }))
      return {};
    const Wall wall(scene, scene.pipes[place->pipe]);
    constexpr double of_edge = 4.;
    const Forces forces = forces_at(frame, *place, position);
    const Vector3 pushed = loads_at(frame, *place, position),
                  moved = wall.mean_by_curvature() / wall.EI *
                              dealii::cross_product_3d(forces.moment, place->tangent) +
                          (place->is_end ? of_edge : 1.) * wall.compliance_of_ring() * pushed,
                  turned = wall.mean_by_curvature() / wall.EI *
                           dealii::cross_product_3d(place->tangent, forces.shear);
    return Motion{{moved[0], moved[1], moved[2], turned[0], turned[1], turned[2]}};
  }

private:
  /// Across the pipe.
  Vector3 loads_at(const Frame &frame, const Place &place, const Point3 &position) const {
    const std::vector<double> factors = factors_in(scene, frame);
    Vector3 sum;
    for (unsigned int l = 0; l < scene.loads.size(); ++l)
      if (scene.loads[l].kind == Load::Kind::force)
        for (const Load::AtPoint &at : scene.loads[l].at)
          for (const PointInfo &point : beams.points)
            if (point.name == at.point && point.position.distance(position) < same_place)
              sum += factors[l] * Vector3({at.value[0], at.value[1], at.value[2]});
    return sum - (sum * place.tangent) * place.tangent;
  }

  /// Whether a contact stands there, which an imposed motion would push against.
  bool is_supported(const Point3 &position) const {
    return std::any_of(beams.supports.begin(), beams.supports.end(),
                       [&](const SupportInfo &support) {
                         return support.position.distance(position) < same_place;
                       });
  }

  std::optional<Place> place_at(const Point3 &position) const {
    std::optional<Place> place;
    unsigned int n_sides = 0;
    for (unsigned int p = 0; p < paths.size(); ++p) {
      const Section &section = scene.sections[scene.pipes[p].section];
      for (const PipePath::Segment &segment : paths[p].segments())
        if (const auto s = segment.place(position, same_place)) {
          const double before = *s - segment.start, after = segment.length - before;
          n_sides += (before > same_place) + (after > same_place);
          if ((!place || after > place->after) && segment.radius == 0. && section.wall > 0. &&
              !scene.pipes[p].rigid && !scene.pipes[p].end_section)
            place = Place{p, *s, before, after, segment.tangent(before), false};
        }
    }
    if (place)
      place->is_end = n_sides == 1;
    return place;
  }

  /// Of the pipe's stations there the mean: a moment may jump.
  Forces forces_at(const Frame &frame, const Place &place, const Point3 &position) const {
    Forces forces;
    unsigned int n = 0;
    for (const Station &station : frame.line)
      if (station.pipe == place.pipe && station.is_node() &&
          station.position.distance(position) < same_place) {
        forces.N += station.force[0];
        forces.shear += station.force[1] * station.y + station.force[2] * station.z;
        forces.moment += station.force[4] * station.y + station.force[5] * station.z;
        ++n;
      }
    if (n > 0) {
      forces.N /= n;
      forces.shear /= n;
      forces.moment /= n;
    }
    for (std::size_t i = 0; i < std::min(frame.reactions.size(), beams.restraints.size()); ++i)
      if (beams.restraints[i].position.distance(position) < same_place)
        for (unsigned int d = 0; d < 3; ++d)
          forces.held[d] += frame.reactions[i][d];
    forces.held -= (forces.held * place.tangent) * place.tangent;
    return forces;
  }

  template <typename Add>
  void in_each_step(const Add &add) {
    for (const Frame &frame : beams.frames)
      if (frame.end_of_step && frame.step < scene.steps.size())
        add(frame);
  }

  void add_load(const Load::Kind kind, const unsigned int step,
                const std::vector<Load::AtPoint> &at) {
    Load load;
    load.kind = kind;
    load.at = at;
    load.name = "held sections " + std::to_string(scene.loads.size());
    scene.steps[step].loads.emplace_back(scene.loads.size(), 1.);
    scene.loads.push_back(load);
  }

  std::string add_point(const Point3 &position) {
    const std::string name = "held section " + std::to_string(scene.points.size());
    scene.add_point(name, position);
    return name;
  }

  void add_guide(const Restraint &restraint, const Place &place, const Point3 &position,
                 const bool turns) {
    const Wall wall(scene, scene.pipes[place.pipe]);
    const double of_curvature = as == HeldAs::rings ? 0. : wall.mean_by_curvature(),
                 of_force = wall.compliance_of_ring();
    std::vector<Vector3> held;
    for (const dealii::Tensor<1, 6> &row : held_directions(restraint, {0, place.tangent})) {
      const Vector3 direction({row[0], row[1], row[2]});
      constexpr double askew = 0.7;
      if (direction.norm() > 0.5 && std::abs(direction * place.tangent) < askew)
        held.push_back(direction);
    }
    if (held.empty())
      return;
    const std::string point = add_point(position);
    in_each_step([&](const Frame &frame) {
      const Forces forces = forces_at(frame, place, position);
      const Vector3 mean =
          of_curvature / wall.EI * dealii::cross_product_3d(forces.moment, place.tangent) +
          of_force * forces.held;
      Load::AtPoint at;
      at.point = point;
      at.axes = axes_along(held[0]);
      if (held.size() > 1)
        at.axes = {{held[0], held[1], dealii::cross_product_3d(held[0], held[1])}};
      for (unsigned int d = 0; d < held.size(); ++d) {
        at.given[d] = true;
        at.value[d] = -(mean * at.axes[d]);
      }
      add_load(Load::Kind::displacement, frame.step, {at});
    });
    if (turns && of_curvature > 0.)
      add_kink(wall, place);
  }

  /// As a curvature of a short piece of the pipe beside the place, free of force.
  void add_kink(const Wall &wall, const Place &place) {
    const double piece = wall.r / 2.;
    if (place.after < 3. * piece)
      return;
    const double from = place.s + piece;
    const Point3 position = paths[place.pipe].point(place.s);
    const std::array<std::string, 2> ends = {{add_point(paths[place.pipe].point(from)),
                                              add_point(paths[place.pipe].point(from + piece))}};
    in_each_step([&](const Frame &frame) {
      const Forces forces = forces_at(frame, place, position);
      const Vector3 moment =
          wall.mean_by_curvature() / piece * dealii::cross_product_3d(place.tangent, forces.held);
      std::vector<Load::AtPoint> at(2);
      for (unsigned int end = 0; end < 2; ++end) {
        at[end].point = ends[end];
        for (unsigned int d = 0; d < 3; ++d)
          at[end].value[3 + d] = (end == 0 ? -1. : 1.) * moment[d];
      }
      add_load(Load::Kind::force, frame.step, at);
    });
  }

  void add_anchor(const Place &place, const Point3 &position) {
    if (as == HeldAs::rings || !place.is_end)
      return;
    const Pipe &pipe = scene.pipes[place.pipe];
    const Wall wall(scene, pipe);
    const bool is_held = scene.solid.anchors == SolidSettings::Anchors::held;
    const double unsheared = (is_held ? 0.7 : 0.3) * wall.t, length = wall.length_of_bending(),
                 way = place.after > place.before ? 1. : -1.;
    const std::vector<double> strains = hoop_strains(scene, pipe);
    const std::string point = add_point(position);
    in_each_step([&](const Frame &frame) {
      const Forces forces = forces_at(frame, place, position);
      Vector3 shift = -way * unsheared / wall.GA * forces.shear, turn;
      if (is_held) {
        shift += way * wall.nu * length *
                 (strain_in(scene, strains, frame) - wall.nu * forces.N / wall.EA) * place.tangent;
        turn = -way * wall.nu * wall.nu * length / wall.EI * forces.moment;
      }
      Load::AtPoint at;
      at.point = point;
      at.given.fill(true);
      for (unsigned int d = 0; d < 3; ++d) {
        at.value[d] = shift[d];
        at.value[3 + d] = turn[d];
      }
      add_load(Load::Kind::displacement, frame.step, {at});
    });
  }

  static Axes axes_along(const Vector3 &x) {
    Vector3 other;
    other[std::abs(x[0]) < 0.6 ? 0 : 1] = 1.;
    const Vector3 z = dealii::cross_product_3d(x, other);
    const Vector3 unit = z / z.norm();
    return {{x, dealii::cross_product_3d(unit, x), unit}};
  }

  Scene scene;
  const Results &beams;
  const HeldAs as;
  std::vector<PipePath> paths;
};

/// Size of what a motion adds to a quantity, in the quantity's SI unit.
double part_in(const Quantity &quantity, const Motion &motion) {
  const unsigned int c = quantity.kind().component;
  if (quantity.is(QuantityKind::Of::motion))
    return std::abs(quantity.scale * motion[c]);
  const bool turns = c == static_cast<unsigned int>(Directed::rotation);
  if (!turns && c != static_cast<unsigned int>(Directed::displacement))
    return 0.;
  const unsigned int first = turns ? 3 : 0;
  const Vector3 both({motion[first], motion[first + 1], motion[first + 2]}),
      along({quantity.direction[0], quantity.direction[1], quantity.direction[2]});
  return std::abs(quantity.scale) *
         (quantity.along == Quantity::Along::direction ? std::abs(both * along) : both.norm());
}

/// The first of a list that is so, or null.
template <typename List, typename Is>
const typename List::value_type *first_that(const List &list, const Is &is) {
  const auto found = std::find_if(list.begin(), list.end(), is);
  return found != list.end() ? &*found : nullptr;
}

} // namespace

Results with_sections_at_points(const Scene &scene, Results beams) {
  const Results as_beams = beams;
  const HeldSections sections(scene, as_beams, HeldAs::sections);
  for (QuantityResult &result : beams.quantities) {
    const Quantity *const quantity =
        first_that(scene.quantities, [&](const Quantity &one) { return one.name == result.name; });
    if (quantity == nullptr ||
        (!quantity->is(QuantityKind::Of::motion) && !quantity->is(QuantityKind::Of::directed)))
      continue;
    const std::string &step = quantity->step.empty() ? scene.steps.back().name : quantity->step;
    const PointInfo *const point = first_that(
        as_beams.points, [&](const PointInfo &one) { return one.name == quantity->where; });
    const Frame *const end = first_that(as_beams.frames, [&](const Frame &frame) {
      return frame.end_of_step && frame.step < scene.steps.size() &&
             scene.steps[frame.step].name == step;
    });
    if (point == nullptr || end == nullptr)
      continue;
    if (const auto motion = sections.motion_of_section(point->position, *end))
      result.value += part_in(*quantity, *motion) / scene.units.factor(unit_of(*quantity));
  }
  return beams;
}

Scene with_held_sections(Scene scene, const Results &beams, const HeldAs as) {
  return HeldSections(std::move(scene), beams, as).hold();
}

} // namespace frictionbeam::accuracy
