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

} // namespace

std::vector<StressEvaluation::TeeSite> StressEvaluation::find_tees(const Scene &scene,
                                                                   const LineMesh &mesh) {
  std::vector<TeeSite> sites;
  for (const Tee &tee : scene.tees) {
    const unsigned int vertex = mesh.points.at(tee.point);
    TeeSite site{&tee, vertex, Vector3(), 0, 0};
    std::optional<unsigned int> run;
    for (unsigned int p = 0; p < scene.pipes.size(); ++p) {
      const auto &vertices = mesh.pipes[p].vertices;
      if (scene.pipes[p].name == tee.branch)
        site.branch = p;
      else if (!run && std::count(vertices.begin(), vertices.end(), vertex) > 0)
        run = p;
    }
    site.run = run.value_or(site.branch);
    const Vector3 normal =
        cross_product_3d(tangent_at(mesh, site.run, vertex), tangent_at(mesh, site.branch, vertex));
    if (normal.norm() > no_direction)
      site.normal = normal / normal.norm();
    sites.push_back(site);
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

StressPoint StressEvaluation::point(const Station &station) const {
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
  if (const TeeSite *const site = tee_at(station)) {
    const Section &run = scene.sections[scene.pipes[site->run].section];
    point.part = station.pipe == site->branch ? StressPart::branch_of_tee : StressPart::run_of_tee;
    point.tee = site->tee->kind;
    point.pad = site->tee->pad;
    point.crotch_radius = site->tee->crotch_radius;
    point.run_diameter = 2. * run.outer_radius;
    point.run_wall = run.wall;
    point.run_corrosion = run.corrosion;
  }
  return point;
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

Vector3 StressEvaluation::normal_of_plane(const Scene &scene, const LineMesh &mesh,
                                          const Station &station) {
  return normal_at(find_tee(find_tees(scene, mesh), station), station);
}

StressEvaluation::Axes StressEvaluation::axes(const Station &station, const double pressure) const {
  const Vector3 normal = normal_at(tee_at(station), station);
  return {station.y * normal, station.z * normal, pressure};
}

const StressEvaluation::TeeSite *StressEvaluation::find_tee(const std::vector<TeeSite> &tees,
                                                            const Station &station) {
  for (const TeeSite &site : tees)
    if (site.vertex == station.vertex)
      return &site;
  return nullptr;
}

} // namespace frictionbeam
