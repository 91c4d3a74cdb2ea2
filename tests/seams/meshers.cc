// Routes that are divided without gmsh shall be what gmsh makes of them: the same vertices to 1e-9
// of the line's extent, the same cells, points, supports and remarks; of the examples and of two
// racks the same answers, too, to 1e-6. gmsh is the reference.
//   check_meshers <project folder>
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "command/line/run_line.h"
#include "mesh/build_line_mesh.h"
#include "scene/read_scene.h"

#include "base/temporary_folder.h"
#include "base/user_error.h"

#include "../check.h"

#include <algorithm>
#include <filesystem>

using namespace frictionbeam;
namespace fs = std::filesystem;

namespace {

constexpr double tolerance = 1e-9;
/// Along a bend gmsh itself is off: it takes a circle's tangents by difference quotients, which are
/// wrong by up to 7e-9 (gmsh 4.8.4, getDerivative()), and its nodes by 2.5e-9 of the bend.
constexpr double tolerance_of_bends = 5e-9;

double extent(const LineMesh &mesh) {
  double result = 0.;
  for (const Point3 &vertex : mesh.vertices)
    result = std::max(result, vertex.distance(mesh.vertices.front()));
  return result;
}

void compare_sites(const std::vector<std::vector<Site>> &own,
                   const std::vector<std::vector<Site>> &reference) {
  CHECK(own.size() == reference.size());
  for (unsigned int i = 0; i < own.size(); ++i) {
    CHECK(own[i].size() == reference[i].size());
    for (unsigned int k = 0; k < own[i].size(); ++k) {
      CHECK(own[i][k].vertex == reference[i][k].vertex);
      CHECK_NEAR((own[i][k].tangent - reference[i][k].tangent).norm(), 0., 1e-6);
      CHECK_NEAR(own[i][k].tributary, reference[i][k].tributary, tolerance);
    }
  }
}

void compare(const LineMesh &own, const LineMesh &reference) {
  CHECK(own.vertices.size() == reference.vertices.size());
  CHECK(own.pipes.size() == reference.pipes.size());
  CHECK(own.points == reference.points);
  CHECK(own.remarks == reference.remarks);
  const double length = extent(reference);
  std::vector<bool> bends(reference.vertices.size(), false);
  for (const MeshedPipe &pipe : reference.pipes)
    for (const auto &[cell, axis] : pipe.bend_axis)
      bends[pipe.vertices[cell]] = bends[pipe.vertices[cell + 1]] = true;
  for (unsigned int v = 0; v < reference.vertices.size(); ++v)
    CHECK_NEAR(own.vertices[v].distance(reference.vertices[v]) / length, 0.,
               bends[v] ? tolerance_of_bends : tolerance);
  for (unsigned int p = 0; p < reference.pipes.size(); ++p) {
    const MeshedPipe &pipe = own.pipes[p], &other = reference.pipes[p];
    CHECK(pipe.vertices == other.vertices);
    CHECK(pipe.s == other.s);
    CHECK(pipe.bend_radius == other.bend_radius);
    CHECK(pipe.arc_centre == other.arc_centre);
    CHECK(pipe.bend_axis == other.bend_axis);
  }
  compare_sites(own.supports, reference.supports);
  compare_sites(own.restraints, reference.restraints);
}

/// Largest difference of the frames' displacements and forces, each beside the largest of its kind;
/// what a rotation does over the line's length, and a moment over it, counts as well.
double difference(const Results &own, const Results &reference, const double length) {
  std::array<double, 4> scale{}, worst{}; // translations, rotations, forces, moments
  CHECK(own.frames.size() == reference.frames.size());
  for (unsigned int f = 0; f < own.frames.size(); ++f) {
    CHECK(own.frames[f].line.size() == reference.frames[f].line.size());
    for (unsigned int i = 0; i < own.frames[f].line.size(); ++i)
      for (unsigned int c = 0; c < 12; ++c) {
        const auto value = [&](const Results &results) {
          const Station &station = results.frames[f].line[i];
          return c < 6 ? station.displacement[c] : station.force[c - 6];
        };
        scale[c / 3] = std::max(scale[c / 3], std::abs(value(reference)));
        worst[c / 3] = std::max(worst[c / 3], std::abs(value(own) - value(reference)));
      }
  }
  scale[0] = std::max(scale[0], length * scale[1]);
  scale[2] = std::max(scale[2], scale[3] / length);
  double result = 0.;
  for (unsigned int kind = 0; kind < 4; ++kind)
    if (scale[kind] > 0.)
      result = std::max(result, worst[kind] / scale[kind]);
  return result;
}

/// Beyond a limit load rounding decides how a line moves.
bool is_short_static(const Scene &scene, const LineMesh &mesh) {
  return mesh.vertices.size() < 300 && !scene.takes_many_runs() &&
         std::none_of(scene.steps.begin(), scene.steps.end(), [](const LoadStep &step) {
           return step.transient || step.finds_limit || step.n_increments > 20;
         });
}

unsigned int n_lines = 0, n_solved = 0;

void compare_meshers(const std::string &file, const std::vector<std::string> &overrides,
                     const bool solve) {
  LawLibrary laws;
  laws.load_builtin();
  Scene scene;
  try {
    scene = read_scene(file, overrides, laws);
  } catch (const UserError &) { // whether files can be read is the business of other tests
    std::cout << file << " cannot be read" << std::endl;
    return;
  }
  if (scene.pipes.empty() || !scene.mesh.file.empty())
    return;
  ++n_lines;
  const int n_before = check::n_failures;
  Scene by_gmsh = scene;
  by_gmsh.mesh.mesher = Mesher::gmsh;
  const LineMesh mesh = build_line_mesh(scene);
  compare(mesh, build_line_mesh(by_gmsh));
  if (solve && is_short_static(scene, mesh)) {
    const TemporaryFolder folder;
    scene.output.directory = by_gmsh.output.directory = folder.path;
    scene.output.vtu = by_gmsh.output.vtu = false;
    CHECK_NEAR(difference(solve_scene(scene, laws), solve_scene(by_gmsh, laws), extent(mesh)), 0.,
               1e-6);
    ++n_solved;
  }
  if (check::n_failures > n_before)
    std::cerr << "  in " << file << (overrides.empty() ? "" : " with " + overrides[0]) << '\n';
}

} // namespace

int main(int, char **argv) {
  const fs::path project = argv[1];
  for (const std::string folder : {"prm/example", "prm/verification"})
    for (const auto &entry : fs::directory_iterator(project / folder))
      if (entry.path().extension() == ".prm")
        compare_meshers(entry.path(), {}, folder == "prm/example");
  for (const char *const kind : {"plant", "planar"})
    compare_meshers(project / "prm/benchmark/rack_family.prm", {std::string("Rack/Kind = ") + kind},
                    true);
  std::cout << n_lines << " lines compared, " << n_solved << " of them solved\n";
  CHECK(n_lines > 30);
  CHECK(n_solved >= 2);
  return check::report();
}
