// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/gmsh/own_mesh.h"

#include "base/child_process.h"
#include "base/user_error.h"
#include "scene/file/parameter_reader.h"
#include "scene/physical_bounds.h"

#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace frictionbeam {

void refuse_too_many_cells(const Scene &scene, const double n) {
  if (n <= scene.mesh.most_cells)
    return;
  constexpr double most_allowed = 1e8; // of the entry
  throw UserError(
      "Mesh/File: the mesh of '" + scene.mesh.file + "' is too large.\n  read:    some " +
      to_text(n) + " cells\n  allowed: at most " + to_text(scene.mesh.most_cells) +
      " cells, since more take very long\n  try:     longer cells in the file, or by Mesh/Cell "
      "length" +
      (1.1 * n > most_allowed ? ""
                              : "; or, if it is meant, Mesh/Most cells = " +
                                    std::to_string(static_cast<unsigned int>(1.1 * n))));
}

namespace {

double count(const int dim) {
  std::vector<int> types;
  std::vector<std::vector<std::size_t>> elements, nodes;
  gmsh::model::mesh::getElements(types, elements, nodes, dim, -1);
  double n = 0.;
  for (const auto &of_type : elements)
    n += of_type.size();
  return n;
}

/// Coarser meshes of the same geometry. What the file says of sizes holds again afterwards.
class CoarserMeshes {
public:
  CoarserMeshes() : size_factor(number(factor_option)), flexible(number(transfinite_option)) {
    gmsh::option::setNumber(transfinite_option, 1); // cells given by number follow the factor too
  }
  ~CoarserMeshes() {
    gmsh::option::setNumber(factor_option, size_factor);
    gmsh::option::setNumber(transfinite_option, flexible);
  }
  CoarserMeshes(const CoarserMeshes &) = delete;
  CoarserMeshes &operator=(const CoarserMeshes &) = delete;

  /// Cells of dimension @p dim where all are @p factor times as long.
  double number_of_cells(const int dim, const double factor) const {
    gmsh::option::setNumber(factor_option, factor * size_factor);
    gmsh::model::mesh::generate(dim);
    const double n = count(dim);
    gmsh::model::mesh::clear();
    return n;
  }

private:
  static double number(const char *const option) {
    double value;
    gmsh::option::getNumber(option, value);
    return value;
  }

  static constexpr const char *factor_option = "Mesh.MeshSizeFactor";
  static constexpr const char *transfinite_option = "Mesh.FlexibleTransfinite";
  const double size_factor, flexible;
};

void refuse_too_many_cells_of_geometry(const Scene &scene, const int dim) {
  constexpr double coarsest = 1e18, finer = 1e-3;
  constexpr double n_cells_of_curves = 200.; // in the mesh by which those of a body are estimated
  const CoarserMeshes meshes;
  // A curve has a least number of cells, however long they may be.
  const double least = meshes.number_of_cells(1, coarsest);
  double n_curves = least;
  for (double factor = finer * coarsest; factor > 0.5; factor *= finer) {
    n_curves = meshes.number_of_cells(1, factor);
    refuse_too_many_cells(scene, std::round(factor * (n_curves - least)));
  }
  if (dim == 1)
    return;
  const double factor = std::max(1., n_curves / n_cells_of_curves);
  refuse_too_many_cells(scene,
                        std::round(std::pow(factor, dim) * meshes.number_of_cells(dim, factor)));
}

void check_coordinates(const Scene &scene, const std::vector<double> &coordinates) {
  const double unit = scene.units.factor("m"), most = physical_bounds("m").largest;
  for (const double x : coordinates)
    if (!(std::abs(unit * x) <= most))
      throw UserError("Mesh/File: '" + scene.mesh.file +
                      "' has a point that is nowhere.\n  read:    a coordinate of " +
                      to_text(unit * x) + " m\n  allowed: at most " + to_text(most) +
                      " m\n  try:     the file's unit of length, which is that of Units");
}

void open_and_mesh(const Scene &scene, const int dim) {
  gmsh::open(scene.mesh.file);
  gmsh::vectorpair entities;
  gmsh::model::getEntities(entities);
  std::vector<double> corners(6), coordinates, unused;
  if (!entities.empty())
    gmsh::model::getBoundingBox(-1, -1, corners[0], corners[1], corners[2], corners[3], corners[4],
                                corners[5]);
  std::vector<std::size_t> tags;
  gmsh::model::mesh::getNodes(tags, coordinates, unused, -1, -1, false, false);
  check_coordinates(scene, tags.empty() ? corners : coordinates);
  if (tags.empty()) {
    if (dim > 1) {
      gmsh::option::setNumber("Mesh.RecombineAll", 1);
      gmsh::option::setNumber("Mesh.SubdivisionAlgorithm", dim == 3 ? 2 : 1);
    }
    refuse_too_many_cells_of_geometry(scene, dim);
    gmsh::model::mesh::generate(dim);
  }
  refuse_too_many_cells(scene, count(dim));
}

/// Of the last line of a geometry gmsh takes the first statement alone and drops the others without
/// a word, if no line end is behind it.
void refuse_unended_line(const std::string &file) {
  if (std::filesystem::path(file).extension() != ".geo")
    return;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    const std::size_t first = line.find(';'),
                      next = first < line.size() ? line.find_first_not_of(" \t\r", first + 1)
                                                 : std::string::npos;
    if (in.eof() && next != std::string::npos && line.compare(next, 2, "//") != 0)
      throw UserError("Mesh/File: gmsh would not see the end of the last line of '" + file +
                      "'.\n  read:    '" + line.substr(next, 80) +
                      "' without a line end behind it\n  allowed: lines that all end\n  "
                      "try:     an empty line at the end of the file");
  }
}

} // namespace

void open_own_mesh(const Scene &scene, const int dim) {
  const std::string &file = scene.mesh.file;
  if (!std::filesystem::exists(file))
    throw UserError("Mesh/File: there is no file '" + file +
                    "'. Give its path from the folder of the parameter file.");
  refuse_unended_line(file);
  ChildLimits limits;
  limits.seconds = 60. + scene.mesh.most_cells / 5e3; // gmsh makes some 1e5 cells a second
  limits.bytes = 8e9 + 2e3 * scene.mesh.most_cells;
  const std::string trouble = run_in_child(
                                  [&]() -> std::string {
                                    try {
                                      open_and_mesh(scene, dim);
                                    } catch (const std::string &) { // what gmsh throws
                                    } catch (const UserError &) {   // both will be met again
                                    }
                                    return "";
                                  },
                                  limits)
                                  .trouble;
  if (!trouble.empty())
    throw UserError("Mesh/File: gmsh cannot read or mesh '" + file + "'.\n  read:    gmsh " +
                    trouble +
                    "\n  allowed: a file that gmsh reads and meshes to its end, without Exit\n  "
                    "try:     gmsh -1 with this file, to see what is wrong");
  open_and_mesh(scene, dim);
}

} // namespace frictionbeam
