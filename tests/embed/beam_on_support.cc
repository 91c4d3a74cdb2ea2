// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A cantilever whose tip rests on a friction support: pressed on, pushed aside until it slips, and
// released. A deal.II program of its own that takes only elements and laws from FrictionBeam.
#include <frictionbeam/fe_friction_beam.h>
#include <frictionbeam/fe_timoshenko_beam.h>
#include <frictionbeam/law_library.h>
#include <frictionbeam/line/assemble_line.h>
#include <frictionbeam/line_triangulation.h>
#include <frictionbeam/vertex_dofs.h>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/lac/sparse_matrix.h>

#include <cmath>
#include <iostream>

using namespace dealii;
using namespace frictionbeam;

// A steel pipe of mass m a metre, and a support of height l. SI units.
const double L = 6., EA = 1.2e9, GA = 2.3e8, GJ = 1.5e7, EI = 2.0e7, m = 100.;
const double l = 0.2, ES = 4e6, GS = 1e6, f = 0.3, half_load = 2e4;

class BeamOnSupport {
public:
  explicit BeamOnSupport(const LineMaterials &materials);
  /// One increment, or a time step of length @p h.
  void solve(const Tensor<1, 3> &tip_force, const double h = 0.);
  /// Of the motion and of the pipe's elasticity [J].
  double energy();
  Tensor<1, 3> tip_displacement() const;

private:
  Triangulation<1, 3> triangulation;
  const hp::FECollection<1, 3> fes;
  DoFHandler<1, 3> dof_handler;
  const LineMaterials materials; // by material id
  LawPointData points;           // what the laws remember
  AffineConstraints<double> constraints;
  SparsityPattern sparsity_pattern;
  SparseMatrix<double> tangent, mass;
  Vector<double> solution, velocity, acceleration;
};

// [step 1: mesh and elements]
BeamOnSupport::BeamOnSupport(const LineMaterials &materials)
    : fes(FE_TimoshenkoBeam({12 * EI / GA}), FE_FrictionBeam()), dof_handler(triangulation),
      materials(materials) {
  // The pipe from vertex 0 to its tip 1; the support from the pipe, 1, to the ground, 2. Here the
  // material id is the number of the finite element, too.
  create_line_triangulation({Point<3>(0, 0, 0), Point<3>(L, 0, 0), Point<3>(L, 0, -l)},
                            {{{{0, 1}}, 0}, {{{1, 2}}, 1}}, triangulation);
  for (const auto &cell : dof_handler.active_cell_iterators())
    cell->set_active_fe_index(cell->material_id());
  dof_handler.distribute_dofs(fes); // 6 + 6, and 3 of the ground: the tip's are shared

  const VertexDofs vertex_dofs(dof_handler);
  vertex_dofs.constrain(0, {{true, true, true, true, true, true}}, constraints);
  vertex_dofs.constrain(2, {{true, true, true}}, constraints);
  constraints.close();
  // [end of step 1]

  DynamicSparsityPattern pattern(dof_handler.n_dofs());
  DoFTools::make_sparsity_pattern(dof_handler, pattern, constraints, true);
  sparsity_pattern.copy_from(pattern);
  tangent.reinit(sparsity_pattern);
  mass.reinit(sparsity_pattern);
  for (Vector<double> *vector : {&solution, &velocity, &acceleration})
    vector->reinit(dof_handler.n_dofs());
  // [step 2: states and mass]
  points = LawPointData(dof_handler, materials);
  assemble_line_mass(dof_handler, materials, constraints, mass);
  // [end of step 2]
}

// [step 3: Newton's method]
void BeamOnSupport::solve(const Tensor<1, 3> &tip_force, const double h) {
  const VertexDofs vertex_dofs(dof_handler);
  const Vector<double> start(solution);
  // Newmark's average acceleration; statics if h is 0.
  const auto new_acceleration = [&]() {
    Vector<double> a(solution);
    a -= start;
    a *= 4. / (h * h);
    a.add(-4. / h, velocity, -1., acceleration);
    return a;
  };
  for (unsigned int iteration = 0; iteration < 20; ++iteration) {
    LineIncrement increment;
    increment.length = h;
    increment.tangent = newton_tangent(iteration); // elastic in the first, then consistent
    Vector<double> residual(solution.size());
    for (unsigned int d = 0; d < 3; ++d)
      residual[vertex_dofs.index(1, d)] = tip_force[d];
    tangent = 0.;
    const LawStatus status = assemble_line(dof_handler, materials, solution, increment, constraints,
                                           points, tangent, residual);
    AssertThrow(status == LawStatus::ok,
                ExcMessage("The law has no answer: try a smaller increment."));
    if (h > 0.) {
      Vector<double> inertia(residual.size());
      mass.vmult(inertia, new_acceleration());
      residual -= inertia;
      tangent.add(4. / (h * h), mass);
    }
    constraints.set_zero(residual);
    if (residual.l2_norm() < 1e-9 * tip_force.norm()) {
      points.commit();
      if (h > 0.) {
        const Vector<double> a = new_acceleration();
        velocity.add(h / 2., acceleration, h / 2., a);
        acceleration = a;
      }
      return;
    }
    SparseDirectUMFPACK inverse; // the tangent of friction is not symmetric
    inverse.initialize(tangent);
    Vector<double> update(residual.size());
    inverse.vmult(update, residual);
    constraints.distribute(update);
    solution += update;
  }
  AssertThrow(false, ExcMessage("Newton's method does not converge: try smaller increments."));
}
// [end of step 3]

double BeamOnSupport::energy() {
  Vector<double> residual(solution.size()); // less the internal forces
  const LawStatus status =
      assemble_line(dof_handler, materials, solution, {}, constraints, points, residual);
  AssertThrow(status == LawStatus::ok, ExcInternalError());
  return mass.matrix_norm_square(velocity) / 2. - residual * solution / 2.;
}

Tensor<1, 3> BeamOnSupport::tip_displacement() const {
  const VertexDofs vertex_dofs(dof_handler);
  Tensor<1, 3> u;
  for (unsigned int d = 0; d < 3; ++d)
    u[d] = solution[vertex_dofs.index(1, d)];
  return u;
}

/// Let go above its support, which does not pull, the pipe swings: with its frequency, and without
/// gaining or losing energy. (One cell has it 0.5 % high, and shear lowers it.)
bool swings(BeamOnSupport &problem) {
  const double k = 1 / (L * L * L / 3 / EI + L / GA), root = 1.875104068711961;
  const double period = 2. * numbers::PI * L * L / (root * root) * std::sqrt(m / EI),
               h = period / 200.;
  const Tensor<1, 3> lift({0., 0., 2e4}), hold({0., 0., 1e4}); // swings about 1e4 / k
  problem.solve(lift);
  const double middle = hold[2] / k;
  double before = problem.tip_displacement()[2], first = 0., last = 0., gained = 0.;
  double total = 0.; // behind the first step, whose acceleration began at zero
  unsigned int n_crossings = 0;
  for (unsigned int step = 1; step <= 1000; ++step) {
    problem.solve(hold, h);
    const double now = problem.tip_displacement()[2];
    const double energy = problem.energy() - hold[2] * now;
    if (step == 1)
      total = energy;
    gained = std::max(gained, std::abs(energy - total));
    if ((before - middle) * (now - middle) < 0.) {
      last = h * (step - (now - middle) / (now - before));
      if (n_crossings++ == 0)
        first = last;
    }
    before = now;
  }
  const double found = 2. * (last - first) / (n_crossings - 1);
  std::cout << "  swings with a period of " << found << " s, a beam's is " << period
            << " s; energy is kept to " << gained / (hold[2] * middle) << '\n';
  return std::abs(found - period) < 0.02 * period && gained < 1e-8 * hold[2] * middle;
}

/// Load steps and their closed form. @p threshold is the largest friction force under the force R.
template <typename Threshold>
bool run(const std::string &law, const LawLibrary &library, const Threshold &threshold) {
  // [materials]
  const LawDescription &section = library.find("elastic_section"), &support = library.find(law);
  std::map<std::string, double> values = {
      {"Axial rigidity", ES}, {"Shear rigidity", GS}, {"Friction coefficient", f}};
  if (law == "pad")
    values["Half load"] = half_load;
  LineMaterials materials;
  materials[0].law = BoundLaw(section, law_parameters(section, {{"Axial rigidity", EA},
                                                                {"Shear rigidity", GA},
                                                                {"Torsional rigidity", GJ},
                                                                {"Bending rigidity", EI}}));
  materials[0].mass = m;
  materials[1].law = BoundLaw(support, law_parameters(support, values));
  // [end of materials]
  BeamOnSupport problem(materials);

  // Stiffness of the cantilever's tip and of the support; reaction and friction limit.
  const double k = 1 / (L * L * L / 3 / EI + L / GA), k_n = ES / l, k_t = GS / l;
  const double P = 1e4, w = P / (k + k_n), T = threshold(k_n * w);
  const double stick = 0.5 * T / k_t * (k + k_t), slip = 3 * T, v_slip = (slip - T) / k;
  // Released, the support holds the tip back if T is not reached the other way.
  const double v_released = std::min(k_t * (v_slip - T / k_t) / (k + k_t), T / k);

  struct Step {
    double lateral_force, lateral_displacement;
  };
  bool passed = true;
  std::cout << law << '\n';
  for (const Step &step :
       {Step{0., 0.}, Step{stick, stick / (k + k_t)}, Step{slip, v_slip}, Step{0., v_released}}) {
    problem.solve(Tensor<1, 3>({0., step.lateral_force, -P}));
    const Tensor<1, 3> u = problem.tip_displacement();
    std::cout << "  force " << step.lateral_force << " N: tip moves to " << u << " m, expected 0 "
              << step.lateral_displacement << ' ' << -w << '\n';
    passed = passed && std::abs(u[1] - step.lateral_displacement) < 1e-9 * v_slip &&
             std::abs(u[2] + w) < 1e-9 * w && std::abs(u[0]) < 1e-9 * w;
  }
  return swings(problem) && passed;
}

/// beam_on_support [my_law.so]: with the law `coulomb`, and then with one's own law `pad`.
int main(int argc, char **argv) {
  LawLibrary library;
  library.load_builtin();
  bool passed = run("coulomb", library, [](const double R) { return f * R; });
  if (argc > 1) {
    library.load(argv[1]);
    passed =
        run("pad", library, [](const double R) { return f * R / (1 + R / half_load); }) && passed;
  }
  std::cout << (passed ? "passed\n" : "FAILED\n");
  return passed ? 0 : 1;
}
