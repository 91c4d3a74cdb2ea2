// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/build_line_mesh.h"

#include "mesh/gmsh/mesh_file.h"
#include "mesh/gmsh/session.h"
#include "mesh/mesh_routes.h"
#include "mesh/support/edges_of_patch.h"

#include "base/numbers.h"
#include "base/user_error.h"
#include "scene/file/parameter_file.h"
#include "scene/in_units.h"
#include "scene/solid/mixed_entries.h"
#include "scene/support_pair.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <map>
#include <set>
#include <sstream>

namespace frictionbeam {

using namespace dealii;

namespace {

/// "Nearest is ..." for messages about points off the line.
std::string nearest_pipe(const Scene &scene, const LineMesh &mesh, const Point3 &p) {
  double best = std::numeric_limits<double>::max();
  std::string message = "there is no pipe";
  for (unsigned int i = 0; i < mesh.pipes.size(); ++i)
    for (unsigned int k = 0; k + 1 < mesh.pipes[i].vertices.size(); ++k) {
      const Point3 begin = mesh.vertices[mesh.pipes[i].vertices[k]];
      const Vector3 leg = mesh.vertices[mesh.pipes[i].vertices[k + 1]] - begin;
      const Point3 foot = begin + std::clamp((p - begin) * leg / leg.norm_square(), 0., 1.) * leg;
      if (foot.distance(p) >= best)
        continue;
      best = foot.distance(p);
      std::ostringstream out;
      out << "the nearest place is " << in_units(scene.units, best, "m") << " away at "
          << in_units(scene.units, foot) << " on pipe '" << scene.pipes[i].name << "'";
      message = out.str();
    }
  return message;
}

/// Points that are on no pipe become free nodes if a spring or a friction support carries them.
void add_free_points(const Scene &scene, LineMesh &mesh) {
  std::set<std::string> carried_points;
  for (const Spring &spring : scene.springs)
    carried_points.insert({spring.point, spring.other});
  for (const FrictionSupport &support : scene.supports)
    if (!support.ground.empty()) { // from one point to another, neither need be on a pipe
      carried_points.insert(support.ground);
      carried_points.insert(support.placement.points.begin(), support.placement.points.end());
    }
  for (const NamedPoint &point : scene.points) {
    if (mesh.points.count(point.name) > 0)
      continue;
    std::string support;
    for (const FrictionSupport &s : scene.supports)
      if (std::count(s.placement.points.begin(), s.placement.points.end(), point.name) > 0)
        support = s.name;
    const bool carried = carried_points.count(point.name) > 0;
    if (!carried && support.empty())
      throw UserError(
          "Point " + point.name + ": no pipe reaches the position " +
          in_units(scene.units, point.position) + "; " + nearest_pipe(scene, mesh, point.position) +
          ". Move the point onto a pipe, or carry it by a spring or a friction support.");
    if (!carried && !scene.pipes.empty())
      throw UserError("Support " + support + " is off the line: its point '" + point.name +
                      "' is at " + in_units(scene.units, point.position) + ", and " +
                      nearest_pipe(scene, mesh, point.position) + ". Move the point onto a pipe.");
    mesh.points[point.name] = mesh.vertices.size();
    mesh.vertices.push_back(point.position);
  }
}

/// @throws UserError where an entry names a point that the file of the mesh does not have.
void check_asked_points(const Scene &scene, const LineMesh &mesh) {
  std::vector<std::string> names;
  for (const auto &[name, vertex] : mesh.points)
    names.push_back(name);
  for (const AskedPoint &asked : scene.asked_points)
    if (asked.entry != solid_at && mesh.points.count(asked.name) == 0) {
      const std::string like = nearest(asked.name, names);
      throw UserError(asked.entry + "\n  read:    '" + asked.name +
                      "'\n  allowed: a physical point of '" + scene.mesh.file +
                      "', or a Point of the parameter file: " + join(names) + "\n  try:     " +
                      (like.empty() ? "Physical Point(\"" + asked.name + "\") = {tag}; in the file"
                                    : "'" + like + "'"));
    }
}

/// Turns placements into vertices.
class Placer {
public:
  Placer(const Scene &scene, const LineMesh &mesh)
      : scene(scene), mesh(mesh), places(places_in_pipes(mesh)) {}

  /// @param follows_pipe whether a direction of the support is along or across the pipe
  std::vector<Site> sites(const std::string &support, const Placement &placement,
                          const bool follows_pipe) const {
    std::vector<Site> result;
    for (const std::string &point : placement.points) {
      const unsigned int at = vertex(support, point);
      const std::optional<Vector3> tangent = tangent_of_run(scene, mesh, at, places[at]);
      if (!tangent && follows_pipe)
        throw UserError(
            "Support " + support + "/Normal\n  read:    a direction of the pipe at point '" +
            point +
            "', where several pipes meet and none goes straight on, or more than "
            "one\n  allowed: along or across where one does, or a vector\n  try:     "
            "Normal = 0 1 0, along what the support is to hold; or a Tee whose Branch is "
            "the pipe that is not meant");
      result.push_back({at, tangent.value_or(Vector3()), 1.});
    }
    if (placement.pipe.empty())
      return result;

    const auto found = std::find_if(scene.pipes.begin(), scene.pipes.end(),
                                    [&](const Pipe &p) { return p.name == placement.pipe; });
    const MeshedPipe &pipe = mesh.pipes[found - scene.pipes.begin()];
    const auto position = [&](const std::string &name, const double otherwise) {
      if (name.empty())
        return otherwise;
      const auto at = std::find(pipe.vertices.begin(), pipe.vertices.end(), vertex(support, name));
      if (at == pipe.vertices.end())
        throw UserError("Support " + support + ": the point '" + name + "' is not on pipe '" +
                        placement.pipe + "'. Name a point of that pipe in From and To.");
      return pipe.s[at - pipe.vertices.begin()];
    };
    const double from = position(placement.from, 0.), to = position(placement.to, pipe.s.back());
    if (placement.continuous)
      add_continuous(pipe, from, to, result);
    else
      add_repeated(support, placement, pipe, from, to, result);
    return result;
  }

private:
  static double tolerance(const MeshedPipe &pipe) { return 1e-6 * pipe.s.back(); }

  /// Every vertex of a pipe from @p from to @p to [m], each with its share of the length.
  void add_continuous(const MeshedPipe &pipe, const double from, const double to,
                      std::vector<Site> &result) const {
    for (unsigned int i = 0; i < pipe.s.size(); ++i)
      if (pipe.s[i] >= from - tolerance(pipe) && pipe.s[i] <= to + tolerance(pipe)) {
        const double before = i == 0 ? 0. : pipe.s[i] - std::max(pipe.s[i - 1], from);
        const double after = i + 1 == pipe.s.size() ? 0. : std::min(pipe.s[i + 1], to) - pipe.s[i];
        result.push_back({pipe.vertices[i], tangent_of_pipe(mesh, pipe, i),
                          (std::max(before, 0.) + std::max(after, 0.)) / 2.});
      }
  }

  /// A site at each multiple of a distance, between the ends.
  void add_repeated(const std::string &support, const Placement &placement, const MeshedPipe &pipe,
                    const double from, const double to, std::vector<Site> &result) const {
    for (unsigned int i = 1; from + i * placement.every < to - tolerance(pipe); ++i) {
      const double s = from + i * placement.every;
      const unsigned int at =
          std::lower_bound(pipe.s.begin(), pipe.s.end(), s - tolerance(pipe)) - pipe.s.begin();
      Assert(at < pipe.s.size() && std::abs(pipe.s[at] - s) <= tolerance(pipe),
             ExcMessage("RoutePlan breaks pipes at repeated supports"));
      result.push_back({pipe.vertices[at], tangent_of_pipe(mesh, pipe, at), 1.});
    }
    if (result.empty() && to <= from)
      throw UserError("Support " + support + ": To stands " +
                      in_units(scene.units, from - to, "m") + " before From along pipe '" +
                      placement.pipe + "'. Change the two with each other.");
    if (result.empty())
      throw UserError("Support " + support + ": every " +
                      in_units(scene.units, placement.every, "m") + " gives no place on the " +
                      in_units(scene.units, to - from, "m") +
                      " of pipe between From and To. Give a smaller distance.");
  }

private:
  unsigned int vertex(const std::string &support, const std::string &point) const {
    const auto found = mesh.points.find(point);
    if (found == mesh.points.end())
      throw UserError("Support " + support + " is off the line: there is no point '" + point +
                      "' on a pipe.");
    return found->second;
  }

  const Scene &scene;
  const LineMesh &mesh;
  const std::vector<PlacesInPipes> places; ///< of the vertices
};

/// A bed carries at nodes, a share of its weight at each: few of them are no bed.
void remark_on_bed(const Scene &scene, const std::string &support, const std::vector<Site> &sites,
                   LineMesh &mesh) {
  constexpr double longest_share = 0.05;
  double length = 0., longest = 0.;
  for (const Site &site : sites) {
    length += site.tributary;
    longest = std::max(longest, site.tributary);
  }
  if (longest > longest_share * length)
    mesh.remarks.push_back(
        "Support " + support + " is a bed of " + in_units(scene.units, length, "m") +
        " that stands on " + std::to_string(sites.size()) + " nodes, one of which has " +
        in_units(scene.units, longest, "m") +
        " of it: what is near an anchor or beyond its reach is not on the bed. " +
        (scene.mesh.file.empty() ? "Leave Mesh/Cell length out, or take less"
                                 : "Give the file shorter cells") +
        ".");
}

/// A guide on a pipe that is nearly upright holds one of two horizontal directions; on an upright
/// one it would hold both, or be refused.
void remark_on_guide(const Scene &scene, const std::string &guide, const std::vector<Site> &sites,
                     LineMesh &mesh) {
  constexpr double upright = 1. - no_direction, nearly = 0.035; // rad
  for (const Site &site : sites) {
    const double lean = std::hypot(site.tangent[0], site.tangent[1]);
    if (site.tangent.norm() == 0. || lean > nearly || std::abs(site.tangent[2]) > upright)
      continue;
    std::ostringstream angle;
    angle << std::setprecision(2) << std::asin(lean) * 180. / numbers::PI;
    mesh.remarks.push_back(
        "Support " + guide + " is a guide at " + in_units(scene.units, mesh.vertices[site.vertex]) +
        ", where the pipe leans by " + angle.str() +
        " degrees from upright: it holds the horizontal direction across that lean and leaves the "
        "other one free. If both are meant, give two supports of Kind = stop with Normal = 1 0 0 "
        "and Normal = 0 1 0, or an upright pipe.");
    return;
  }
}

bool is_across(const Direction &direction) { return direction.kind == Direction::Kind::across; }
bool follows_pipe(const Direction &direction) { return direction.kind != Direction::Kind::global; }

/// @throws UserError where the branch of a tee goes on beyond it: it would be taken for the run.
void check_tees(const Scene &scene, const LineMesh &mesh) {
  for (const Tee &tee : scene.tees)
    for (unsigned int p = 0; p < scene.pipes.size(); ++p) {
      const std::vector<unsigned int> &vertices = mesh.pipes[p].vertices;
      const auto at = mesh.points.find(tee.point);
      if (scene.pipes[p].name == tee.branch && at != mesh.points.end() &&
          vertices.front() != at->second && vertices.back() != at->second)
        throw UserError(
            "Tee " + tee.name + "/Branch\n  read:    " + tee.branch +
            "\n  allowed: a pipe that begins or ends at point '" + tee.point +
            "'\n  try:     the pipe that branches off there; a cross is drawn with two");
    }
}

/// The force of a spring between two points acts on either at its own place: across the way between
/// them the two are a couple.
void remark_on_springs(const Scene &scene, LineMesh &mesh) {
  for (const Spring &spring : scene.springs) {
    if (spring.other.empty())
      continue;
    const Vector3 way =
        mesh.vertices[mesh.points.at(spring.other)] - mesh.vertices[mesh.points.at(spring.point)];
    for (unsigned int c = 0; c < 6; ++c) {
      const Motion &direction = spring.directions[c];
      const Vector3 push({direction[0], direction[1], direction[2]});
      if ((spring.stiffness[c] == 0. && spring.damping[c] == 0.) ||
          cross_product_3d(way, push).norm() <= 1e-6 * way.norm() || way.norm() == 0.)
        continue;
      mesh.remarks.push_back(
          "Spring " + spring.name + " joins points " + in_units(scene.units, way.norm(), "m") +
          " apart and acts across the way between them. The couple of its two forces, force times "
          "that distance, is carried by nothing that is modelled: moments are not in balance. "
          "Try points at one place, to which rigid pipes lead, or Axes along the way.");
      break;
    }
  }
}

/// @throws UserError where a load imposes one motion of a place under two names: they would add up.
void check_displacements(const Scene &scene, const LineMesh &mesh) {
  for (const Load &load : scene.loads) {
    if (load.kind != Load::Kind::displacement)
      continue;
    std::map<std::pair<unsigned int, unsigned int>, std::string> given; // vertex and motion
    for (const Load::AtPoint &at : load.at)
      for (unsigned int c = 0; c < 6; ++c) {
        if (!at.given[c])
          continue;
        const auto [one, is_first] = given.try_emplace({mesh.points.at(at.point), c}, at.point);
        if (!is_first)
          throw UserError("Load " + load.name + "/Displacements\n  read:    the same motion of '" +
                          one->second + "' and of '" + at.point +
                          "', which is one place: they would add up\n  allowed: each motion of a "
                          "place once\n  try:     that of '" +
                          one->second + "' alone");
      }
  }
}

/// @throws UserError where both ends of a spring or of a support on a pipe are one place of the
/// line under two names: what joins a place to itself carries nothing.
void check_ends(const Scene &scene, const LineMesh &mesh) {
  const auto refuse = [](const std::string &entry, const std::string &other, const std::string &one,
                         const std::string &advice) {
    throw UserError(entry + "\n  read:    '" + other + "', which is the place of '" + one +
                    "' on a pipe: one node, whatever else stands there\n  allowed: another "
                    "place than At\n  try:     " +
                    advice);
  };
  for (const Spring &spring : scene.springs)
    if (!spring.other.empty() && mesh.points.at(spring.point) == mesh.points.at(spring.other))
      refuse("Spring " + spring.name + "/To", spring.other, spring.point,
             "no 'To', and no support there: the spring is then between the pipe and the ground; "
             "or, between two pipes, a Joint");
  for (const FrictionSupport &support : scene.supports)
    for (const std::string &point : support.placement.points)
      if (!support.ground.empty() && mesh.points.at(point) == mesh.points.at(support.ground))
        refuse("Support " + part_name(support) + "/Ground", support.ground, point,
               "a point on another pipe, which does not meet this one there");
}

/// @throws UserError if a support has numbers for a place that it does not stand at
void check_places(const FrictionSupport &support, const std::size_t n_places) {
  if (support.parameters_at.empty() || support.parameters_at.rbegin()->first < n_places)
    return;
  const std::string last = std::to_string(support.parameters_at.rbegin()->first + 1);
  throw UserError("Support " + support.name + "." + last + " is none of the places of support " +
                  support.name + ", which has " + std::to_string(n_places) +
                  ".\n  read:    place " + last + "\n  allowed: 1 to " + std::to_string(n_places) +
                  "\n  try:     frictionbeam check, which lists the supports");
}

} // namespace

LineMesh build_line_mesh(const Scene &scene) {
  const std::string &file = scene.mesh.file;
  LineMesh mesh =
      by_gmsh(file, [&]() { return file.empty() ? mesh_routes(scene) : mesh_file(scene); });
  add_free_points(scene, mesh);
  check_asked_points(scene, mesh);
  check_tees(scene, mesh);
  check_displacements(scene, mesh);
  check_ends(scene, mesh);
  remark_on_springs(scene, mesh);
  const Placer placer(scene, mesh);
  for (const FrictionSupport &support : scene.supports) {
    std::vector<Site> sites =
        placer.sites(support.name, support.placement, follows_pipe(support.normal));
    for (unsigned int place = 0; place < sites.size(); ++place) {
      sites[place].place = place;
      sites[place].at = sites[place].vertex;
    }
    check_places(support, sites.size());
    mesh.supports.push_back(stands_on_edges(scene, support)
                                ? sites_on_edges(scene, mesh, support, sites)
                                : std::move(sites));
    if (support.placement.continuous && support.normal.sign > 0.) // of two halves, the one
      remark_on_bed(scene, part_name(support), mesh.supports.back(), mesh);
    if (is_across(support.normal) && support.normal.sign > 0.)
      remark_on_guide(scene, part_name(support), mesh.supports.back(), mesh);
  }
  for (const Restraint &restraint : scene.restraints) {
    const auto &held = restraint.translations;
    mesh.restraints.push_back(placer.sites(restraint.name, restraint.placement,
                                           std::any_of(held.begin(), held.end(), follows_pipe)));
    if (std::any_of(held.begin(), held.end(), is_across))
      remark_on_guide(scene, restraint.name, mesh.restraints.back(), mesh);
  }
  return mesh;
}

} // namespace frictionbeam
