// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/results/stress_code.h>
#include <frictionbeam/results/stresses.h>
#include <frictionbeam/results/text.h>

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {

/// Where tees stand: the vertex' position, the normal of their plane, run and branch.
struct TeeSite {
  const Tee *tee;
  Point3 position;
  Vector3 normal;
  unsigned int branch, run;
};

Vector3 tangent_at(const LineMesh &mesh, const unsigned int pipe, const unsigned int vertex) {
  const MeshedPipe &meshed = mesh.pipes[pipe];
  const auto found = std::find(meshed.vertices.begin(), meshed.vertices.end(), vertex);
  const unsigned int i = found - meshed.vertices.begin();
  return meshed.tangent(mesh.vertices, i > 0 ? i - 1 : 0, i > 0);
}

std::vector<TeeSite> find_tees(const Scene &scene, const LineMesh &mesh) {
  std::vector<TeeSite> sites;
  for (const Tee &tee : scene.tees) {
    const unsigned int vertex = mesh.points.at(tee.point);
    TeeSite site{&tee, mesh.vertices[vertex], Vector3(), 0, 0};
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
    if (normal.norm() > 1e-6)
      site.normal = normal / normal.norm();
    sites.push_back(site);
  }
  return sites;
}

class StressEvaluation {
public:
  StressEvaluation(const Scene &scene, const LineMesh &mesh, const Results &results)
      : scene(scene), results(results), code(make_stress_code(scene.stress.code)),
        tees(find_tees(scene, mesh)) {}

  const Frame *frame_of(const std::string &step) const {
    const Frame *found = nullptr;
    for (const Frame &frame : results.frames)
      if (frame.end_of_step && step_name(scene, frame) == step)
        found = &frame;
    return found;
  }

  StressPoint point(const Station &station) const {
    const Pipe &pipe = scene.pipes[station.pipe];
    const Material &material = scene.materials[pipe.material];
    Section section = scene.sections[pipe.section];
    if (pipe.end_section)
      section = between(section, scene.sections[*pipe.end_section], station.part);
    StressPoint point;
    point.diameter = 2. * section.outer_radius;
    point.wall = section.wall;
    point.corrosion = section.corrosion;
    point.youngs_modulus = material.youngs_modulus;
    point.stiffening_pressure = pipe.bend_flexibility.pressure;
    point.allowable_cold = material.allowable_cold;
    point.allowable_hot = material.allowable_hot;
    if (station.bend_radius > 0.) {
      point.part = StressPoint::Part::bend;
      point.bend_radius = station.bend_radius;
    }
    if (const TeeSite *const site = tee_at(station)) {
      const Section &run = scene.sections[scene.pipes[site->run].section];
      point.part = station.pipe == site->branch ? StressPoint::Part::branch_of_tee
                                                : StressPoint::Part::run_of_tee;
      point.tee = site->tee->kind;
      point.pad = site->tee->pad;
      point.crotch_radius = site->tee->crotch_radius;
      point.run_diameter = 2. * run.outer_radius;
      point.run_wall = run.wall;
    }
    return point;
  }

  /// @param force N, Vy, Vz, Mx, My, Mz
  StressForces forces(const Station &station, const Motion &force, const double pressure) const {
    StressForces result;
    result.axial = force[0];
    result.torsion = force[3];
    result.pressure = pressure;
    Vector3 normal = station.bend_axis;
    if (const TeeSite *const site = tee_at(station))
      normal = site->normal;
    const Vector3 moment = force[4] * station.y + force[5] * station.z;
    result.in_plane = moment * normal;
    result.out_of_plane =
        std::sqrt(std::max(0., moment.norm_square() - result.in_plane * result.in_plane));
    return result;
  }

  const Scene &scene;
  const Results &results;
  const std::unique_ptr<const StressCode> code;

private:
  const TeeSite *tee_at(const Station &station) const {
    if (station.node)
      for (const TeeSite &site : tees)
        if (site.position.distance(station.position) < 1e-9 * (1. + station.position.norm()))
          return &site;
    return nullptr;
  }

  const std::vector<TeeSite> tees;
};

/// Factors of every station, for who asks.
void add_factors(const StressEvaluation &evaluation, StressCase &result) {
  for (const Station &station : result.frame.line) {
    const StressPoint point = evaluation.point(station);
    const StressCode::Factors i = evaluation.code->intensification(point);
    const double k = point.part == StressPoint::Part::bend
                         ? b31_3_bend(point.diameter, point.wall, point.bend_radius,
                                      point.youngs_modulus, point.stiffening_pressure)
                               .k
                         : 1.;
    result.factors.push_back({{k, i.in_plane, i.out_of_plane}});
  }
}

void find_worst(StressCase &result) {
  for (unsigned int i = 0; i < result.stress.size(); ++i)
    if (result.stress[i] / result.allowed[i] >
        result.stress[result.worst] / result.allowed[result.worst])
      result.worst = i;
}

} // namespace

double pressure_in(const Scene &scene, const std::string &step, const unsigned int pipe) {
  double largest = 0.;
  for (const LoadStep &declared : scene.steps)
    if (declared.name == step)
      for (const auto &[l, factor] : declared.loads) {
        const Load &load = scene.loads[l];
        const auto &pipes = load.pipes;
        if (load.kind == Load::Kind::pressure &&
            (pipes.empty() || std::count(pipes.begin(), pipes.end(), scene.pipes[pipe].name) > 0))
          largest = std::max(largest, std::abs(factor * load.value));
      }
  for (const Combination &combination : scene.combinations)
    if (combination.name == step)
      for (const auto &part : combination.cases)
        largest = std::max(largest, pressure_in(scene, part.first, pipe));
  return largest;
}

std::vector<StressCase>
evaluate_stresses(const Scene &scene, const LineMesh &mesh, const Results &results,
                  const std::function<double(const std::string &, const unsigned int)> &pressure) {
  std::vector<StressCase> cases;
  if (scene.stress.code.empty())
    return cases;
  const StressEvaluation evaluation(scene, mesh, results);
  const StressCode &code = *evaluation.code;
  const auto add = [&](const std::string &step, const bool occasional) {
    const Frame *const frame = evaluation.frame_of(step);
    if (frame == nullptr)
      return;
    StressCase result;
    result.name = result.step = step;
    result.kind = occasional ? "occasional" : "sustained";
    result.frame = *frame;
    for (const Station &station : frame->line) {
      const StressPoint point = evaluation.point(station);
      result.stress.push_back(code.sustained(
          point, evaluation.forces(station, station.force, pressure(step, station.pipe))));
      result.allowed.push_back(occasional ? code.allowed_occasional(point, scene.stress)
                                          : code.allowed_sustained(point));
    }
    find_worst(result);
    cases.push_back(std::move(result));
  };
  for (const std::string &step : scene.stress.sustained)
    add(step, false);
  const std::size_t n_sustained = cases.size();
  for (const std::string &step : scene.stress.occasional)
    add(step, true);
  for (const auto &[from, to] : scene.stress.expansion) {
    const Frame *const before = evaluation.frame_of(from), *const after = evaluation.frame_of(to);
    if (before == nullptr || after == nullptr)
      continue;
    AssertDimension(before->line.size(), after->line.size());
    StressCase result;
    result.name = from + " to " + to;
    result.step = to;
    result.kind = "expansion";
    result.frame = *after;
    for (unsigned int i = 0; i < after->line.size(); ++i) {
      const Station &station = after->line[i];
      Motion range = station.force;
      for (unsigned int c = 0; c < 6; ++c)
        range[c] -= before->line[i].force[c];
      const StressPoint point = evaluation.point(station);
      double sustained = 0.;
      for (std::size_t s = 0; s < n_sustained; ++s)
        sustained = std::max(sustained, cases[s].stress[i]);
      result.stress.push_back(code.expansion_range(point, evaluation.forces(station, range, 0.)));
      result.allowed.push_back(code.allowed_range(point, scene.stress, sustained));
    }
    find_worst(result);
    cases.push_back(std::move(result));
  }
  for (StressCase &result : cases) {
    result.code = code.name();
    add_factors(evaluation, result);
  }
  return cases;
}

std::optional<double> stress_quantity(const Quantity &quantity, const LineMesh &mesh,
                                      const Results &results) {
  const std::string &what = quantity.what;
  std::optional<double> largest;
  for (const StressCase &one : results.stresses) {
    const bool range = one.kind == "expansion";
    if ((what == "SL" && range) || (what == "SE" && !range) ||
        (!quantity.step.empty() && quantity.step != one.step))
      continue;
    for (unsigned int i = 0; i < one.stress.size(); ++i) {
      if (!quantity.where.empty() &&
          one.frame.line[i].position.distance(mesh.vertices[mesh.points.at(quantity.where)]) > 1e-9)
        continue;
      const double value = what == "flexibility"   ? one.factors[i][0]
                           : what == "sif_in"      ? one.factors[i][1]
                           : what == "sif_out"     ? one.factors[i][2]
                           : what == "utilization" ? one.stress[i] / one.allowed[i]
                                                   : one.stress[i];
      largest = std::max(largest.value_or(0.), value);
    }
  }
  return largest;
}

std::vector<NozzleUse> evaluate_nozzles(const Scene &scene, const Results &results) {
  std::vector<NozzleUse> uses;
  for (const NozzleLimit &nozzle : scene.nozzles)
    for (const Frame &frame : results.frames) {
      if (!frame.end_of_step)
        continue;
      for (unsigned int i = 0; i < results.restraints.size(); ++i) {
        const std::string &name = results.restraints[i].name;
        if (name != nozzle.support && name.substr(0, name.rfind('.')) != nozzle.support)
          continue;
        NozzleUse use{nozzle.name,        name,           step_name(scene, frame),
                      frame.reactions[i], nozzle.allowed, 0.};
        for (unsigned int c = 0; c < 6; ++c)
          if (nozzle.allowed[c] > 0.)
            use.utilization = std::max(use.utilization, std::abs(use.force[c]) / nozzle.allowed[c]);
        uses.push_back(use);
      }
    }
  return uses;
}

} // namespace frictionbeam
