// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/stress/stress_evaluation.h"

#include "base/numbers.h"
#include "base/user_error.h"
#include "results/stress/wall_stress.h"
#include "results/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace frictionbeam {

namespace {

Vector3 tangent_at(const LineMesh &mesh, const unsigned int pipe, const unsigned int vertex) {
  const MeshedPipe &meshed = mesh.pipes[pipe];
  const auto found = std::find(meshed.vertices.begin(), meshed.vertices.end(), vertex);
  const unsigned int i = found - meshed.vertices.begin();
  return meshed.tangent(mesh.vertices, i > 0 ? i - 1 : 0, i > 0);
}

/// All that a place is, for a set of them.
std::array<double, 15> numbers_of(const StressPoint &p) {
  return {{static_cast<double>(p.part), p.diameter, p.wall, p.corrosion, p.bend_radius,
           p.youngs_modulus, p.stiffening_pressure, static_cast<double>(p.tee), p.pad,
           p.crotch_radius, p.run_diameter, p.run_wall, p.run_corrosion, p.allowable_cold,
           p.allowable_hot}};
}

/// Of the pipes at a vertex but its branch those of the run: what passes through, or goes on
/// straight in another one; all of them where nothing does.
std::vector<unsigned int> run_of(const LineMesh &mesh, const unsigned int vertex,
                                 const unsigned int branch) {
  constexpr double straight = 0.1; // sine
  std::vector<unsigned int> all, run;
  for (unsigned int p = 0; p < mesh.pipes.size(); ++p)
    if (const auto &at = mesh.pipes[p].vertices;
        p != branch && std::count(at.begin(), at.end(), vertex) > 0)
      all.push_back(p);
  for (const unsigned int p : all) {
    const auto &at = mesh.pipes[p].vertices;
    const Vector3 along = tangent_at(mesh, p, vertex);
    const bool goes_on = std::any_of(all.begin(), all.end(), [&](const unsigned int other) {
      return other != p &&
             cross_product_3d(along, tangent_at(mesh, other, vertex)).norm() < straight;
    });
    if (goes_on || (at.front() != vertex && at.back() != vertex))
      run.push_back(p);
  }
  return run.empty() ? all : run;
}

} // namespace

std::vector<StressEvaluation::TeeSite> StressEvaluation::find_tees(const Scene &scene,
                                                                   const LineMesh &mesh) {
  std::vector<TeeSite> sites;
  for (const Tee &tee : scene.tees) {
    const unsigned int vertex = mesh.points.at(tee.point);
    const auto named = std::find_if(scene.pipes.begin(), scene.pipes.end(),
                                    [&](const Pipe &pipe) { return pipe.name == tee.branch; });
    const unsigned int branch = named != scene.pipes.end() ? named - scene.pipes.begin() : 0;
    std::vector<unsigned int> runs = run_of(mesh, vertex, branch);
    if (runs.empty()) // its branch is all there is
      runs = {branch};
    for (const unsigned int run : runs) {
      TeeSite site{&tee, vertex, Vector3(), branch, run};
      const Vector3 normal =
          cross_product_3d(tangent_at(mesh, run, vertex), tangent_at(mesh, branch, vertex));
      if (normal.norm() > no_direction)
        site.normal = normal / normal.norm();
      sites.push_back(site);
    }
  }
  return sites;
}

StressEvaluation::StressEvaluation(const Scene &scene, const LineMesh &mesh, const Results &results)
    : scene(scene), results(results), code(scene.stress), tees(find_tees(scene, mesh)) {}

const Frame *StressEvaluation::frame_of(const std::string &step) const {
  const Frame *found = nullptr;
  for (const Frame &frame : results.frames)
    if (frame.end_of_step && frame.name == step)
      found = &frame;
  return found;
}

StressPoint StressEvaluation::point_of_pipe(const Station &station) const {
  const Pipe &pipe = scene.pipes[station.pipe];
  const Material &material = scene.materials[pipe.material];
  const Section section = section_at(scene, station);
  StressPoint point;
  point.diameter = 2. * section.outer_radius;
  point.wall = section.wall;
  point.corrosion = section.corrosion;
  point.youngs_modulus = material.youngs_modulus;
  point.stiffening_pressure = pipe.bend_flexibility.pressure;
  point.allowable_cold = material.allowable_cold;
  point.allowable_hot = material.allowable_hot;
  if (station.bend_radius > 0.) {
    point.part = StressPart::bend;
    point.bend_radius = station.bend_radius;
  }
  return point;
}

StressPoint StressEvaluation::point_at(const TeeSite &site, const Station &station) const {
  const Section &run = scene.sections[scene.pipes[site.run].section];
  StressPoint point = point_of_pipe(station);
  point.part = station.pipe == site.branch ? StressPart::branch_of_tee : StressPart::run_of_tee;
  point.tee = site.tee->kind;
  point.pad = site.tee->pad;
  point.crotch_radius = site.tee->crotch_radius;
  point.run_diameter = 2. * run.outer_radius;
  point.run_wall = run.wall;
  point.run_corrosion = run.corrosion;
  return point;
}

StressPoint StressEvaluation::point(const Station &station) const {
  const TeeSite *const site = tee_at(station);
  return site != nullptr ? point_at(*site, station) : point_of_pipe(station);
}

const StressEvaluation::TeeSite *StressEvaluation::tee_at(const Station &station) const {
  std::vector<const TeeSite *> at;
  const auto take = [&](const auto &is_of) {
    for (const TeeSite &site : tees)
      if (site.vertex == station.vertex && is_of(site) == station.pipe)
        at.push_back(&site);
  };
  take([](const TeeSite &site) { return site.branch; });
  if (at.empty())
    take([](const TeeSite &site) { return site.run; });
  const TeeSite *worst = nullptr;
  double largest = 0.;
  for (const TeeSite *const site : at) {
    if (at.size() == 1)
      return site;
    const StressFactors factors = code.intensification(point_at(*site, station));
    if (const double size = std::max(factors.in_plane, factors.out_of_plane);
        worst == nullptr || size > largest) {
      worst = site;
      largest = size;
    }
  }
  return worst;
}

void StressEvaluation::check(const std::vector<Station> &line) const {
  std::set<std::array<double, 15>> known; // a line has few kinds of places
  for (const Station &station : line) {
    const StressPoint at = point(station);
    if (!station.is_node() || !known.insert(numbers_of(at)).second)
      continue;
    const std::string fault = code.fault(at);
    if (!fault.empty())
      throw UserError(
          "The stress code '" + scene.stress.code + "' cannot be applied to pipe '" +
          scene.pipes[station.pipe].name + "', " +
          rounded_number(station.s / scene.units.factor("m"), 6) + " " + scene.units.name("m") +
          " from its beginning.\n  read:    " + fault +
          "\n  allowed: what the code has a rule for\n  try:     another Stress/Code, or "
          "to mend the code (doc/stress_codes.md)");
  }
}

Vector3 StressEvaluation::normal_of_tee(const Scene &scene, const LineMesh &mesh,
                                        const Station &station) {
  Vector3 normal;
  for (const TeeSite &site : find_tees(scene, mesh))
    if (site.vertex == station.vertex) {
      if (site.branch == station.pipe)
        return site.normal;
      if (site.run == station.pipe && normal.norm() == 0.)
        normal = site.normal;
    }
  return normal;
}

StressEvaluation::Axes StressEvaluation::axes(const Station &station, const double pressure) const {
  const TeeSite *const site = tee_at(station);
  const Vector3 normal = site != nullptr ? site->normal : station.bend_axis;
  return {station.y * normal, station.z * normal, pressure};
}

} // namespace frictionbeam
