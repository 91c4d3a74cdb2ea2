// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "mesh/line_mesh.h"

#include <gmsh.h>

#include <unordered_map>

namespace frictionbeam {

/// Takes gmsh's nodes for vertices of a line's mesh, in the order in which pipes reach them.
class GmshVertices {
public:
  /// @param unit of gmsh's coordinates [m]
  GmshVertices(const double unit, std::vector<Point3> &vertices) : unit(unit), vertices(vertices) {
    std::vector<std::size_t> tags;
    std::vector<double> unused;
    gmsh::model::mesh::getNodes(tags, coordinates, unused, -1, -1, false, false);
    place.reserve(tags.size());
    for (std::size_t i = 0; i < tags.size(); ++i)
      place[tags[i]] = i;
    number.resize(tags.size(), dealii::numbers::invalid_unsigned_int);
  }

  /// The vertex of a node, made if there is none.
  unsigned int operator()(const std::size_t tag) {
    const std::size_t i = place.at(tag);
    if (number[i] == dealii::numbers::invalid_unsigned_int) {
      number[i] = vertices.size();
      const double *const x = &coordinates[3 * i];
      vertices.emplace_back(unit * x[0], unit * x[1], unit * x[2]);
    }
    return number[i];
  }
  /// Whether a pipe has reached a node; a bend's centre is reached by none.
  bool has(const std::size_t tag) const {
    const auto known = place.find(tag);
    return known != place.end() && number[known->second] != dealii::numbers::invalid_unsigned_int;
  }

private:
  const double unit;
  std::vector<Point3> &vertices;
  std::vector<double> coordinates;
  std::unordered_map<std::size_t, std::size_t> place; ///< of a tag among the coordinates
  std::vector<unsigned int> number;                   ///< of the vertex, by that place
};

} // namespace frictionbeam
