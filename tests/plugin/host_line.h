// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/fe_arc_beam.h>
#include <frictionbeam/fe_friction_beam.h>
#include <frictionbeam/fe_timoshenko_beam.h>
#include <frictionbeam/law_library.h>
#include <frictionbeam/line/assemble_line.h>
#include <frictionbeam/line_triangulation.h>
#include <frictionbeam/vertex_dofs.h>

#include "../check.h"
#include "section_laws.h"

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/lac/sparse_matrix.h>

#include <string>
#include <vector>

/// What a host's program has around a line; installed headers alone.
namespace host {

using namespace dealii;
using namespace frictionbeam;

inline LawLibrary &laws() {
  static LawLibrary library;
  static const bool loaded = (library.load_builtin(), library.add(section_laws::plastic), true);
  (void)loaded;
  return library;
}

inline BoundLaw law(const std::string &name, const std::map<std::string, double> &values) {
  return BoundLaw(laws().find(name), law_parameters(laws().find(name), values));
}

const double EA = 300., GA = 70., GJ = 0.9, EI = 1.3;
const double shear_flexibility = 12 * EI / GA;
const std::map<std::string, double> rigidities = {{"Axial rigidity", EA},
                                                  {"Shear rigidity", GA},
                                                  {"Torsional rigidity", GJ},
                                                  {"Bending rigidity", EI}};

inline BoundLaw elastic() { return law("elastic_section", rigidities); }

inline BoundLaw plastic(std::map<std::string, double> values) {
  values.insert(rigidities.begin(), rigidities.end());
  return law("plastic_section", values);
}

constexpr std::array<bool, 6> all = {{true, true, true, true, true, true}};

/// A line with its system; material ids are places in the collection.
struct Line {
  Triangulation<1, 3> triangulation;
  hp::FECollection<1, 3> fes;
  DoFHandler<1, 3> dof_handler{triangulation};
  AffineConstraints<double> constraints;
  SparsityPattern pattern;
  SparseMatrix<double> K;
  Vector<double> u;
  LineMaterials materials;
  LawPointData points;

  Line(const std::vector<Point<3>> &vertices, const std::vector<LineCell> &cells,
       const hp::FECollection<1, 3> &fes, const LineMaterials &materials)
      : fes(fes), materials(materials) {
    create_line_triangulation(vertices, cells, triangulation);
    distribute();
  }

  void distribute() {
    if (fes.size() > 1)
      for (const auto &cell : dof_handler.active_cell_iterators())
        cell->set_active_fe_index(cell->material_id());
    dof_handler.distribute_dofs(fes);
    u.reinit(dof_handler.n_dofs());
    constraints.clear();
  }

  void hold(const unsigned int vertex, const std::array<bool, 6> &fixed = all) {
    VertexDofs(dof_handler).constrain(vertex, fixed, constraints);
  }

  /// When all is held.
  void close(const unsigned int n_points = 0) {
    constraints.close();
    DynamicSparsityPattern places(dof_handler.n_dofs());
    DoFTools::make_sparsity_pattern(dof_handler, places, constraints, true);
    K.clear();
    pattern.copy_from(places);
    K.reinit(pattern);
    points = LawPointData(dof_handler, materials, n_points);
  }

  Vector<double> no_load() const { return Vector<double>(dof_handler.n_dofs()); }

  types::global_dof_index dof(const unsigned int vertex, const unsigned int component) const {
    return VertexDofs(dof_handler).index(vertex, component);
  }
  double at(const unsigned int vertex, const unsigned int component) const {
    return u[dof(vertex, component)];
  }
  Tensor<1, 3> at(const unsigned int vertex) const {
    return Tensor<1, 3>({at(vertex, 0), at(vertex, 1), at(vertex, 2)});
  }

  /// An increment by Newton's method: the norms of its residuals, not finite if it failed.
  std::vector<double> newton(const Vector<double> &load, LineIncrement increment = {},
                             const double tolerance = 1e-12) {
    std::vector<double> norms;
    for (unsigned int iteration = 0; iteration < 25; ++iteration) {
      increment.tangent = newton_tangent(iteration);
      K = 0.;
      Vector<double> residual(load);
      if (assemble_line(dof_handler, materials, u, increment, constraints, points, K, residual) !=
          LawStatus::ok)
        return {std::nan("")};
      constraints.set_zero(residual);
      norms.push_back(residual.l2_norm());
      if (norms.back() < tolerance) {
        points.commit();
        return norms;
      }
      SparseDirectUMFPACK inverse;
      inverse.initialize(K);
      Vector<double> update(residual);
      inverse.solve(update);
      constraints.distribute(update);
      u += update;
    }
    return {std::nan("")};
  }
};

/// What an exception of deal.II says, empty if there is none.
template <typename Function>
std::string message_of(const Function &function) {
  try {
    function();
  } catch (const ExceptionBase &error) {
    return error.what();
  }
  return "";
}

inline bool says(const std::string &message, const std::string &words) {
  if (message.find(words) != std::string::npos)
    return true;
  std::cerr << "found: " << message << '\n';
  return false;
}

} // namespace host
