// SPDX-License-Identifier: LGPL-2.1-or-later
#include "relations.h"
#include "changes.h"
#include "frame.h"

#include <algorithm>
#include <limits>

namespace oracle {

namespace {

using Maybe = std::optional<Related>;

/// 15 fibres miss a limit moment by 4e-3, and what hardens little moves by many times as much.
constexpr double of_fibres = 0.05;
/// Cells of other lengths have their sections elsewhere.
constexpr double of_sections = 0.05;

/// One of the turns of a cube into itself, mirrored ones included.
Eigen::Matrix3d cube_turn(Random &random, const bool keep_vertical) {
  std::array<int, 3> place = {0, 1, 2};
  if (random.chance(0.5))
    std::swap(place[0], place[1]);
  if (!keep_vertical)
    std::rotate(place.begin(), place.begin() + random.whole(0, 2), place.end());
  Eigen::Matrix3d Q = Eigen::Matrix3d::Zero();
  for (int d = 0; d < 3; ++d)
    Q(place[d], d) = keep_vertical && d == 2 ? 1. : random.chance(0.5) ? 1. : -1.;
  return Q;
}

bool any_anisotropic(const Scene &scene) {
  return std::any_of(scene.supports.begin(), scene.supports.end(),
                     [](const Support &s) { return s.ratio != 1.; });
}

Maybe turned(const Scene &scene, Random &random) {
  if (any_anisotropic(scene)) // its two directions do not follow the pipe
    return {};
  const bool keep_vertical =
      !scene.hangers.empty() ||
      std::any_of(scene.supports.begin(), scene.supports.end(),
                  [](const Support &s) { return s.kind == "guide" || s.direction == "across"; });
  Related related{scene, {}};
  related.mapping.turn = cube_turn(random, keep_vertical);
  turn(related.scene, related.mapping.turn);
  if (!keep_vertical && scene.has_laws()) // fibres stand elsewhere round the pipe
    related.mapping.accuracy = of_fibres;
  return related;
}

/// Without what has components along global axes and nowhere others.
void leave_out_components(Scene &scene) {
  scene.nozzles.clear();
  scene.spectra.clear();
  scene.combinations.clear();
  scene.free_motions.fill(true);
}

/// Guides stay across their pipes where the vertical keeps its direction.
Maybe turned_askew(const Scene &scene, Random &random) {
  if (any_anisotropic(scene))
    return {};
  const bool keep_vertical =
      std::any_of(scene.supports.begin(), scene.supports.end(),
                  [](const Support &s) { return s.kind == "guide" || s.direction == "across"; });
  const Vec axis = keep_vertical ? Vec(0., 0., 1.) : random.direction();
  Related related{scene, {}};
  related.mapping.turn =
      Eigen::AngleAxisd(random.number(0.1, 3.), axis.normalized()).toRotationMatrix();
  turn_askew(related.scene, related.mapping.turn);
  if (!keep_vertical && scene.has_laws()) // fibres stand elsewhere round the pipe
    related.mapping.accuracy = of_fibres;
  return related;
}

Maybe reversed(const Scene &scene, Random &) {
  Related related{scene, {}};
  return reverse_routes(related.scene) ? Maybe(related) : Maybe();
}

/// Whether motions are held at all points of the mesh, and so at more of them where it has more.
bool holds_motions(const Scene &scene) {
  return std::count(scene.free_motions.begin(), scene.free_motions.end(), false) > 0;
}

Maybe cut(const Scene &scene, Random &random) {
  Related related{scene, {}};
  if (scene.modes > 0 || holds_motions(scene)) // which depend on the cells
    return {};
  related.mapping.same_stations = false;
  related.mapping.accuracy = scene.has_laws() ? of_sections : 0.;
  return cut_a_pipe(related.scene, random) ? Maybe(related) : Maybe();
}

/// A point on a run, and a mass of zero there.
Maybe point_added(const Scene &scene, Random &random) {
  Related related{scene, {}};
  if (scene.modes > 0 || holds_motions(scene) || !add_a_point(related.scene, "Z1", random))
    return {};
  for (const Support &support : scene.supports)
    if (support.continuous) // a bed acts at its nodes
      return {};
  related.mapping.same_stations = false;
  related.mapping.accuracy = scene.has_laws() ? of_sections : 0.;
  related.scene.masses.push_back({"nothing", {"Z1"}, 0.});
  return related;
}

/// A support with a gap of a kilometre, at a point that is there.
Maybe far_support(const Scene &scene, Random &random) {
  Related related{scene, {}};
  Support support;
  support.name = "far";
  support.kind = "friction";
  support.at = {random.pick(scene.monitors)};
  support.normal = random.direction();
  support.friction = 0.3;
  support.gap = 1000.;
  related.scene.supports.push_back(support);
  return related;
}

Maybe sections_in_another_order(const Scene &scene, Random &random) {
  Related related{scene, {}};
  related.scene.sections_reversed = true;
  for (std::size_t i = related.scene.supports.size(); i > 1; --i)
    std::swap(related.scene.supports[i - 1], related.scene.supports[random.whole(0, i - 1)]);
  return related;
}

/// Laws that never yield, for elastic sections.
Maybe by_laws(const Scene &scene, Random &random) {
  const bool moves = std::any_of(scene.steps.begin(), scene.steps.end(),
                                 [](const Step &step) { return step.transient; });
  for (const Load &load : scene.loads) // jumps of free strains take a time step of such a line
    if (moves && (load.kind == "temperature" || load.kind == "pressure"))
      return {};
  Related related{scene, {}};
  give_laws(related.scene, random, false);
  for (const Pipe &pipe : scene.pipes)
    for (const Corner &corner : pipe.route)
      if (corner.bend > 0. && scene.arcs) // whose flexibility is summed over five sections
        related.mapping.accuracy = 1e-4;
  return related.scene.has_laws() ? Maybe(related) : Maybe();
}

Maybe other_units(const Scene &scene, Random &random) {
  const std::vector<std::string> units = {"si",     "mm N MPa",        "in lb psi F",
                                          "ft kip", "cm kgf kg bar C", "m kN t kPa F"};
  Related related{scene, {}};
  related.scene.units = random.pick(units);
  const auto inches = [](const std::string &words) {
    return words.find("in ") == 0 || words.find("ft ") == 0;
  };
  const bool sized = std::any_of(scene.sections.begin(), scene.sections.end(),
                                 [](const Section &section) { return !section.size.empty(); });
  if (sized && inches(scene.units) != inches(related.scene.units))
    return {}; // the standard's tables in mm and in inches differ
  return related;
}

Maybe scaled(const Scene &scene, Random &random) {
  for (const Section &section : scene.sections)
    if (!section.size.empty())
      return {};
  for (const Hanger &hanger : scene.hangers)
    if (hanger.cold_load == 0.)
      return {}; // which is sized for 25 mm at least
  for (const Section &section : scene.sections)
    for (const LawValue &of : section.law_values)
      if (of.name == "Creep coefficient" || of.name == "Primary creep coefficient")
        return {}; // of the time that is scaled, too
  Related related{scene, {}};
  const double a = random.number(0.2, 5.);
  scale_lengths(related.scene, a);
  related.mapping.length = related.mapping.time = a;
  related.mapping.force = a * a;
  return related;
}

/// Stiffnesses in their last bits.
Maybe nudged(const Scene &scene, Random &random) {
  const auto nudge = [&](double &number) {
    number *= 1. + random.whole(-4, 4) * std::numeric_limits<double>::epsilon();
  };
  Related related{scene, {}};
  for (Material &material : related.scene.materials) {
    nudge(material.E);
    for (auto &row : material.table)
      nudge(row[1]);
  }
  for (Section &section : related.scene.sections)
    nudge(section.diameter);
  return related;
}

/// Guides and stops that hold exactly against two rigid contacts without gap and friction.
Maybe guides_as_pairs(const Scene &scene, Random &) {
  Related related{scene, {}};
  bool any = false;
  const Frame frame(scene);
  for (const Support &support : scene.supports)
    for (const Place &place : frame.places(support))
      if (support.kind == "guide" && std::abs(place.tangent[2]) > 1. - 1e-6)
        return {}; // which two contacts cannot hold both ways
  for (Support &support : related.scene.supports)
    if (support.holds_exactly() && support.kind != "anchor" && support.kind != "restraint") {
      support.as_pair = true;
      any = true;
    }
  if (scene.modes > 0)
    return {};
  return any ? Maybe(related) : Maybe();
}

/// A rest on the ground against a rest on a piece of pipe that is anchored at both ends.
Maybe ground_is_a_pipe(const Scene &scene, Random &) {
  Related related{scene, {}};
  return stand_on_pipes(related.scene) ? Maybe(related) : Maybe();
}

Maybe bends_as_pieces(const Scene &scene, Random &) {
  Related related{scene, {}};
  related.mapping.same_stations = false;
  related.scene.arcs = false;
  related.scene.cells_per_bend = 200;
  for (const Load &load : scene.loads)
    if (load.kind == "pressure" || load.kind == "wind") // Bourdon's effect; wind by cells
      return {};
  if (!scene.arcs || scene.has_contacts() || scene.modes > 0)
    return {};
  return related;
}

/// Elastic contacts by return mapping against the method exact.
Maybe by_newton(const Scene &scene, Random &) {
  bool any = false;
  for (const Support &support : scene.supports)
    if (!support.holds_exactly()) {
      any = true;
      if (support.axial_rigidity == 0. || support.shear_rigidity == 0.)
        return {};
    }
  Related related{scene, {}};
  related.scene.more.emplace_back("Solver/Method", "newton");
  return any ? Maybe(related) : Maybe();
}

} // namespace

const std::vector<Relation> &relations() {
  static const std::vector<Relation> all = {
      {"turned", "the scene turned or mirrored, gravity with it", &turned},
      {"skew", "the scene turned by any angle about any axis", &turned_askew, 1e-7, 1e-6, false,
       false, &leave_out_components},
      {"reversed", "all routes from their ends", &reversed},
      {"cut", "a pipe cut into two", &cut, 1e-7, 0.},
      {"point", "a named point and a mass of zero added", &point_added, 1e-7, 0.},
      {"far", "a support that never touches added", &far_support},
      {"order", "sections of the file and supports in another order", &sections_in_another_order},
      {"units", "the file in other units", &other_units},
      {"nudged", "Young's moduli and diameters in their last bits", &nudged},
      {"scaled", "all lengths times a factor at equal stresses", &scaled},
      {"pairs", "exact guides as two contacts", &guides_as_pairs, 1e-7, 0.},
      {"ground", "supports on an anchored pipe", &ground_is_a_pipe, 1e-7, 0.},
      {"arcs", "bends cut into 200 straight pieces", &bends_as_pieces, 2e-4, 0., false, false,
       nullptr, 0.},
      {"laws", "laws of sections that never yield", &by_laws, 1e-7, 1e-6, false, false, &allow_laws,
       0.},
      {"increments", "a step within the elastic range in ten increments", &in_ten_increments, 1e-7,
       0., false, false, &unload},
      {"newton", "method newton where contacts are elastic", &by_newton, 1e-6, 0., true},
      {"split", "a step cut into two", &step_split, 1e-9, 1e-9},
      {"detour", "a step that is gone back from, between two", &detour, 1e-9, 1e-9},
      {"again", "the last step once more", &last_step_again, 1e-7, 0.},
      {"slow", "all steps as slow motions", &slowly, 1e-5, 0., true, false, &make_static, 0.},
      {"resumed", "the run interrupted and resumed", &interrupted, 1e-15, 1e-15, false, true},
      {"small", "small displacements by linear kinematics", &linear_kinematics, 1e-4, 0., false,
       false, &make_small_displacements, 1e-4}};
  return all;
}

} // namespace oracle
