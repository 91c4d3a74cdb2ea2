// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/unknowns/discretization.h"

#include "base/numbers.h"
#include "base/user_error.h"
#include "model/unknowns/like_cells.h"
#include "model/unknowns/rigid_part.h"
#include "model/unknowns/section_law.h"
#include "scene/file/parameter_reader.h"
#include <frictionbeam/fe_timoshenko_beam.h>
#include <frictionbeam/generalized_strain.h>

#include <algorithm>
#include <set>

namespace frictionbeam {

using namespace dealii;

namespace {

/// As create_line_triangulation(), of cells that have been checked: what it refuses are loops.
std::vector<CellOrigin> triangulate(const std::vector<Point<3>> &points,
                                    const std::vector<LineCell> &cells,
                                    Triangulation<1, 3> &triangulation) {
  try {
    return create_line_triangulation(points, cells, triangulation);
  } catch (const StandardExceptions::ExcMessage &) {
    throw UserError("The loops of the pipes meet in such a way that they cannot be put in order.\n"
                    "  read:    pipes that meet, four or more at a point, in many loops\n"
                    "  allowed: loops that meet at points of three pipes\n"
                    "  try:     pulling such a point apart by a short pipe");
  }
}

} // namespace

double bend_flexibility(const Pipe &pipe, const Section &section, const Material &material,
                        const double bend_radius) {
  if (bend_radius == 0. || pipe.bend_flexibility.rule == BendFlexibility::Rule::none)
    return 1.;
  if (pipe.bend_flexibility.rule == BendFlexibility::Rule::given)
    return pipe.bend_flexibility.factor;
  if (section.wall == 0.)
    throw UserError("Pipe " + pipe.name +
                    ": Bend flexibility = code needs the outer diameter and "
                    "the wall of section '" +
                    section.name +
                    "', which is given by its area and inertia. Give them, a number, or none.");
  const double r = section.outer_radius - section.wall / 2.;
  const double t = section.wall, R = bend_radius, h = t * R / (r * r);
  if (pipe.bend_flexibility.rule == BendFlexibility::Rule::von_karman)
    return (10. + 12. * h * h) / (1. + 12. * h * h);
  const double stiffening = 1. + 6. * pipe.bend_flexibility.pressure / material.youngs_modulus *
                                     std::pow(r / t, 7. / 3.) * std::cbrt(R / r);
  return std::max(1., 1.65 / h / stiffening);
}

Vector3 resolve(const Direction &direction, const Vector3 &tangent, const std::string &part) {
  if (direction.kind == Direction::Kind::global)
    return direction.sign * direction.vector;
  if (tangent.norm() == 0.)
    throw UserError("Support " + part +
                    " follows the direction of a pipe, and no pipe reaches its "
                    "point. Give its direction, or place it on a pipe.");
  const LocalAxes axes(tangent);
  return direction.sign * (direction.kind == Direction::Kind::along ? axes.x : axes.y);
}

namespace {

/// Options of the friction element; in a turned cell the pipe is the second node.
std::pair<FE_FrictionBeam::Rotations, bool> element_option(const FrictionSupport &support,
                                                           const bool reversed) {
  using Rotations = FE_FrictionBeam::Rotations;
  switch (support.rotations) {
  case FrictionSupport::Rotations::none:
    return {Rotations::none, support.torsion};
  case FrictionSupport::Rotations::averaged:
    return {Rotations::averaged, support.torsion};
  default:
    return {reversed ? Rotations::second_node : Rotations::first_node, support.torsion};
  }
}

/// About the axis [kg m]. A twist without inertia in a skew pipe would be a motion that no single
/// unknown names, and rounding its only mass: where the metal has no density, all mass stands for
/// it.
double twist_inertia(const Profile &profile, const Section &section) {
  const double density = profile.material.density;
  return 2. * section.inertia * (density > 0. ? density : profile.mass / section.area);
}

/// A pipe's own mass in place of its metal's [kg/m]; what has none turns without inertia, too.
void give_mass(const double mass, const Section &section, Profile &profile) {
  profile.mass = mass + section.added_mass;
  profile.twist_inertia = twist_inertia(profile, section);
  if (profile.mass == 0.)
    profile.rotary_inertia = profile.twist_inertia = 0.;
}

/// Cells of one bend have one radius and one centre, if they are arcs.
BendPart bend_of(const MeshedPipe &meshed, const unsigned int cell) {
  BendPart bend;
  bend.radius = meshed.bend_radius[cell];
  const auto centre_of = [&](const unsigned int i) {
    const auto arc = meshed.arc_centre.find(i);
    return arc == meshed.arc_centre.end() ? std::nullopt : std::optional<Point3>(arc->second);
  };
  bend.arc_centre = centre_of(cell);
  if (!bend.arc_centre)
    return bend;
  const auto is_same = [&](const unsigned int i) {
    return meshed.bend_radius[i] == bend.radius && centre_of(i) == bend.arc_centre;
  };
  unsigned int first = cell, last = cell;
  while (first > 0 && is_same(first - 1))
    --first;
  while (last + 1 < meshed.bend_radius.size() && is_same(last + 1))
    ++last;
  bend.length = meshed.s[last + 1] - meshed.s[first];
  bend.begin = (meshed.s[cell] - meshed.s[first]) / bend.length;
  bend.end = (meshed.s[cell + 1] - meshed.s[first]) / bend.length;
  return bend;
}

Profile make_profile(const Pipe &pipe, const Section &section, const Material &material,
                     const BendPart &bend, const LawLibrary &laws) {
  const double E = material.youngs_modulus, G = E / (2. * (1. + material.poissons_ratio));
  Profile profile;
  profile.EA = E * section.area;
  profile.GA = G * section.shear_area;
  profile.GJ = G * section.torsion_constant;
  profile.EI = E * section.inertia / bend_flexibility(pipe, section, material, bend.radius);
  profile.mass = material.density * section.area + section.added_mass;
  profile.wind_diameter = 2. * (section.outer_radius + section.insulation);
  profile.rotary_inertia = section.rotary_inertia ? material.density * section.inertia : 0.;
  profile.material = material;
  profile.twist_inertia = twist_inertia(profile, section);
  profile.pressure_strain = section.bore_area() * (1. - 2. * material.poissons_ratio) / profile.EA;
  const double stiffer = pipe.rigid ? rigid_part : 1.;
  for (double *rigidity : {&profile.EA, &profile.GA, &profile.GJ, &profile.EI})
    *rigidity *= stiffer;
  profile.pressure_strain /= stiffer;
  // The Bourdon effect: pressure opens a bend by p r/(2 E t) of its angle, for membrane forces
  // stretch a torus without a jump at its crowns then and only then (doc/theory.md).
  if (bend.radius > 0. && section.wall > 0.)
    profile.pressure_curvature = -(section.outer_radius - section.wall / 2.) /
                                 (2. * stiffer * E * section.wall * bend.radius);
  profile.arc_centre = bend.arc_centre;
  profile.bore_area = section.bore_area();
  const BoundLaw law = bind_section_law(laws.find(pipe.rigid ? "elastic_section" : section.law),
                                        pipe, section, bend, profile);
  if (law.name() == "elastic_section")
    profile.tangent = elastic_tangent(law);
  else
    take_section_law(law, pipe, section, bend, profile);
  return profile;
}

/// Unit normal of the plane of a bend that a straight cell is a piece of, first tangent x inward;
/// of a pipe of a file that is a bend, by its first and last cell. 0: of none.
Vector3 axis_of_piece(const LineMesh &mesh, const MeshedPipe &pipe, const unsigned int cell) {
  if (pipe.bend_radius[cell] == 0.)
    return {};
  if (const auto known = pipe.bend_axis.find(cell); known != pipe.bend_axis.end())
    return known->second;
  const auto &v = pipe.vertices;
  const auto chord = [&](const std::size_t i) {
    return mesh.vertices[v[i + 1]] - mesh.vertices[v[i]];
  };
  const Vector3 axis = cross_product_3d(chord(0), chord(v.size() - 2));
  return axis.norm() > no_direction * chord(0).norm_square() ? axis / axis.norm() : Vector3();
}

/// Of a reducer, the section in the middle of a cell; of another pipe, its own.
Section section_of(const Scene &scene, const Pipe &pipe, const MeshedPipe &meshed,
                   const unsigned int cell) {
  const Section &begin = scene.sections[pipe.section];
  if (!pipe.end_section)
    return begin;
  return between(begin, scene.sections[*pipe.end_section],
                 (meshed.s[cell] + meshed.s[cell + 1]) / (2. * meshed.s.back()));
}

} // namespace

namespace {

/// What the triangulation cannot be made of, in the user's words.
void check_cells(const std::vector<Point3> &points, const std::vector<LineCell> &cells) {
  if (cells.empty())
    throw UserError("The scene has no line.\n  read:    no pipe, and no point with a support or "
                    "a spring\n  allowed: at least one of them\n  try:     a pipe, or, if the "
                    "scene is a body, Model = continuum; 'check' draws lines only");
  for (const LineCell &cell : cells) {
    const Point3 &at = points[cell.vertices[0]];
    if (!(at.distance(points[cell.vertices[1]]) > 0.))
      throw UserError("Two points that a support or a spring joins stand at one place.\n  read:    "
                      "(" +
                      to_text(at[0]) + ", " + to_text(at[1]) + ", " + to_text(at[2]) +
                      ") m for both\n  allowed: points apart from each other, as of a support and "
                      "its Ground\n  try:     another Position of one of them");
  }
}

} // namespace

Discretization::Discretization(const Scene &scene, const LineMesh &mesh, const LawLibrary &laws)
    : dofs(triangulation), points(mesh.vertices), n_own(mesh.vertices.size()) {
  add_profiles(scene, mesh, laws);
  first_like = first_like_cells(points, cells);
  add_elements(scene);
  add_supports(scene, mesh);
  add_carriers(scene, mesh);
  find_rotations(scene, mesh);
  check_cells(points, cells);
  const std::vector<CellOrigin> origins = triangulate(points, cells, triangulation);
  take_cells(scene, origins);
  dofs.distribute_dofs(fe);
  add_joints(scene, mesh);
  dofs_at_vertex = std::make_unique<const VertexDofs>(dofs);
}

void Discretization::add_elements(const Scene &scene) {
  std::vector<double> shear_flexibility;
  for (const Profile &profile : sections)
    shear_flexibility.push_back(profile.GA > 0. ? 12. * profile.EI / profile.GA : 0.);
  fe.push_back(FE_TimoshenkoBeam(shear_flexibility));
  std::map<unsigned int, ArcData> arcs;
  for (unsigned int id = 0; id < sections.size(); ++id)
    if (sections[id].arc_centre)
      arcs[id] = sections[id].arc();
  if (!arcs.empty())
    fe.push_back(FE_ArcBeam(arcs));
  first_option = fe.size();
  using Rotations = FE_FrictionBeam::Rotations;
  const auto add_option = [this](const std::pair<Rotations, bool> &option) {
    if (std::find(options.begin(), options.end(), option) == options.end())
      options.push_back(option);
  };
  for (const FrictionSupport &support : scene.supports) {
    add_option(element_option(support, false));
    add_option(element_option(support, true)); // the triangulation may turn the cell
  }
  const auto turns = [](const Spring &spring) {
    return spring.turns(0, true) || spring.turns(1, true) || spring.turns(2, true);
  };
  const bool turning_spring = std::any_of(scene.springs.begin(), scene.springs.end(), turns);
  if (!scene.springs.empty()) // carriers of free points
    options.emplace_back(turning_spring ? Rotations::averaged : Rotations::none, turning_spring);
  for (const auto &[rotations, torsion] : options)
    fe.push_back(FE_FrictionBeam(rotations, torsion));
}

void Discretization::take_cells(const Scene &scene, const std::vector<CellOrigin> &origins) {
  infos.resize(cells.size());
  cell_level_index.resize(cells.size());
  for (const auto &cell : dofs.active_cell_iterators()) {
    const CellOrigin &origin = origins[cell->active_cell_index()];
    cell_level_index[origin.index] = cell->index();
    CellInfo &info = infos[cell->active_cell_index()];
    if (origin.index < pipes.size()) {
      info = {CellKind::pipe, origin.index};
      pipes[origin.index].reversed = origin.reversed;
    } else if (origin.index < pipes.size() + supports.size()) {
      info = {CellKind::support, origin.index - static_cast<unsigned int>(pipes.size())};
      fe_index[origin.index] =
          element_index(scene.supports[supports[info.index].support], origin.reversed);
    } else
      info = {CellKind::carrier, 0};
    cell->set_active_fe_index(fe_index[origin.index]);
  }
}

Discretization::Cell Discretization::at(const unsigned int author_index) const {
  return {&triangulation, 0, static_cast<int>(cell_level_index[author_index]), &dofs};
}

std::optional<ArcBeam> Discretization::arc(const Cell &cell) const {
  const Profile &profile = sections[cell->material_id()];
  if (!profile.arc_centre)
    return {};
  return ArcBeam(cell->vertex(0), cell->vertex(1), profile.arc());
}

void Discretization::add_profiles(const Scene &scene, const LineMesh &mesh,
                                  const LawLibrary &laws) {
  std::map<std::array<double, 5>, unsigned int> known; // pipe, bend radius, axis of the bend
  for (unsigned int p = 0; p < mesh.pipes.size(); ++p) {
    const MeshedPipe &meshed = mesh.pipes[p];
    const Pipe &pipe = scene.pipes[p];
    for (unsigned int i = 0; i + 1 < meshed.vertices.size(); ++i) {
      const bool is_arc = meshed.arc_centre.count(i) > 0;
      const Vector3 axis = is_arc ? Vector3() : axis_of_piece(mesh, meshed, i);
      unsigned int id = sections.size();
      if (!is_arc && !pipe.end_section)
        id = known.try_emplace({double(p), meshed.bend_radius[i], axis[0], axis[1], axis[2]}, id)
                 .first->second;
      if (id == sections.size()) {
        const Section section = section_of(scene, pipe, meshed, i);
        sections.push_back(
            make_profile(pipe, section, scene.materials[pipe.material], bend_of(meshed, i), laws));
        sections[id].bend_axis = axis;
        if (scene.keeps_elastic)
          sections[id].law = {};
        if (pipe.total_mass)
          give_mass(*pipe.total_mass / meshed.s.back(), section, sections[id]);
      }
      cells.push_back({{meshed.vertices[i], meshed.vertices[i + 1]}, id});
      fe_index.push_back(is_arc ? 1 : 0);
      pipes.push_back({p, i, false});
    }
  }
}

unsigned int Discretization::element_index(const FrictionSupport &support,
                                           const bool reversed) const {
  const auto option = element_option(support, reversed);
  return first_option + (std::find(options.begin(), options.end(), option) - options.begin());
}

void Discretization::add_supports(const Scene &scene, const LineMesh &mesh) {
  for (unsigned int i = 0; i < scene.supports.size(); ++i) {
    const FrictionSupport &support = scene.supports[i];
    for (unsigned int site = 0; site < mesh.supports[i].size(); ++site) {
      const unsigned int on = mesh.supports[i][site].vertex;
      unsigned int ground;
      double length = support.length;
      const Vector3 &tangent = mesh.supports[i][site].tangent;
      if (support.kind == "guide" && tangent.norm() > 0. &&
          std::abs(tangent[2]) > 1. - no_direction)
        throw UserError(
            "Support " + support.name +
            ": with a gap, friction or a stiffness, a guide on a vertical pipe would "
            "hold one of its two horizontal directions only. Give two supports of Kind = "
            "stop instead, with Normal = 1 0 0 and Normal = 0 1 0.");
      Vector3 axis = -1. * resolve(support.normal, tangent, support.name);
      if (support.ground.empty()) {
        ground = points.size();
        points.push_back(points[on] + support.length * axis);
      } else {
        ground = mesh.points.at(support.ground);
        const Vector3 way = points[ground] - points[on];
        if (way.norm() == 0.)
          throw UserError("Support " + support.name + " and its Ground " + support.ground +
                          " are at the same place. Place them a Length apart along the Normal.");
        if (axis.norm() == 0.)
          axis = (support.normal.sign) * way;
        if (length == 0.)
          length = way.norm();
      }
      cells.push_back({{on, ground}, 0});
      fe_index.push_back(element_index(support, false));
      supports.push_back({i, site, {on, ground}, axis / axis.norm(), length});
    }
  }
}

void Discretization::add_carriers(const Scene &scene, const LineMesh &mesh) {
  std::vector<bool> reached(n_own, false);
  for (const LineCell &cell : cells)
    for (const unsigned int vertex : cell.vertices)
      if (vertex < n_own)
        reached[vertex] = true;
  for (const Spring &spring : scene.springs)
    for (const std::string &name : {spring.point, spring.other}) {
      if (name.empty() || reached[mesh.points.at(name)])
        continue;
      const unsigned int vertex = mesh.points.at(name);
      reached[vertex] = true;
      points.push_back(points[vertex] + Vector3({0., 0., -1.}));
      cells.push_back({{vertex, static_cast<unsigned int>(points.size() - 1)}, 0});
      fe_index.push_back(fe.size() - 1);
    }
}

void Discretization::find_rotations(const Scene &scene, const LineMesh &mesh) {
  rotations.assign(n_own, {false, false, false});
  for (const MeshedPipe &pipe : mesh.pipes)
    for (const unsigned int vertex : pipe.vertices)
      rotations[vertex] = {true, true, true};
  for (unsigned int axis = 0; axis < 3; ++axis) {
    for (const Spring &spring : scene.springs)
      if (spring.turns(axis, true))
        for (const std::string &point : {spring.point, spring.other})
          if (!point.empty())
            rotations[mesh.points.at(point)][axis] = true;
    for (const Load &load : scene.loads)
      if (load.kind == Load::Kind::displacement)
        for (const Load::AtPoint &at : load.at)
          for (unsigned int c = 3; c < 6; ++c)
            if (at.given[c] && at.axes[c - 3][axis] != 0.)
              rotations[mesh.points.at(at.point)][axis] = true;
  }
}

} // namespace frictionbeam
