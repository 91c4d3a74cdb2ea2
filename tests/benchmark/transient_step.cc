// SPDX-License-Identifier: LGPL-2.1-or-later
// What a time step costs, in back-substitutions with the factored matrix of the same line.
#include "analysis/increment/time_step.h"
#include "analysis/sequence/load_sequence.h"
#include "base/user_error.h"
#include "model/line_model.h"
#include "scene/read_scene.h"
#include <frictionbeam/contact/line_factorization.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <iostream>

using namespace frictionbeam;

namespace {

using Clock = std::chrono::steady_clock;

double milliseconds_since(const Clock::time_point start) {
  return 1e3 * std::chrono::duration<double>(Clock::now() - start).count();
}

double median(std::vector<double> values) {
  if (values.empty())
    return 0.;
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

double mean(const std::vector<double> &values) {
  double sum = 0.;
  for (const double value : values)
    sum += value;
  return values.empty() ? 0. : sum / values.size();
}

/// Time steps of one kind.
struct Steps {
  std::vector<double> time, iterations, factorizations, back_substitutions;

  void print(const char *const kind, const double unit) const {
    if (!time.empty())
      std::printf("  %-22s %5zu steps, %7.2f ms = %6.2f back-substitutions; %.2f counted, %.2f "
                  "iterations, %.2f factorizations\n",
                  kind, time.size(), median(time), median(time) / unit, mean(back_substitutions),
                  mean(iterations), mean(factorizations));
  }
};

/// One back-substitution with K + (4/h^2) M, the contacts' patterns included [ms].
double back_substitution(const Model &model) {
  const double h = time_step(model);
  const SparseMatrix matrix = model.linear.stiffness() + 4. / (h * h) * model.linear.mass();
  contact::LineFactorization factors;
  factors.analyze(matrix);
  const Clock::time_point start = Clock::now();
  if (!factors.factorize(matrix))
    throw std::runtime_error("The matrix is singular.");
  const double factorization = milliseconds_since(start);
  Vector x = Vector::Ones(matrix.rows());
  std::vector<double> times;
  for (int i = 0; i < 101; ++i) {
    const Clock::time_point before = Clock::now();
    x = factors.solve(x);
    x /= x.lpNorm<Eigen::Infinity>();
    times.push_back(milliseconds_since(before));
  }
  std::printf("%ld unknowns, %zu cells, %u contacts; factorization %.2f ms, back-substitution %.3f "
              "ms (median of %zu)\n",
              static_cast<long>(matrix.rows()), model.discretization.pipe_cells().size(),
              model.contacts.size(), factorization, median(times), times.size());
  return median(times);
}

void measure(const std::string &file, const std::vector<std::string> &options,
             const LawLibrary &laws, const Scene &scene) {
  const LineModel line(scene, laws);
  const Model &model = line.model();
  std::cout << file;
  for (const std::string &option : options)
    std::cout << "; " << option;
  std::cout << '\n';
  const double unit = back_substitution(model);
  LoadSequence sequence(model);
  Steps quiet, busy;
  Clock::time_point last = Clock::now();
  StepReport before;
  unsigned int n = 0;
  const bool converged =
      sequence.run([](const Progress &, const LineState &) {},
                   [&](const Progress &progress, const LineState &state) {
                     const double time = milliseconds_since(last);
                     const bool transient =
                         !sequence.reports().empty() && scene.steps[progress.step].transient;
                     if (transient && ++n > 2) { // the first ones factor
                       const StepReport &now = sequence.reports().back();
                       Steps &steps = state.events.empty() ? quiet : busy;
                       steps.time.push_back(time);
                       steps.iterations.push_back(now.iterations - before.iterations);
                       steps.factorizations.push_back(now.factorizations - before.factorizations);
                       steps.back_substitutions.push_back(1. * now.back_substitutions -
                                                          1. * before.back_substitutions);
                     }
                     if (!sequence.reports().empty())
                       before = sequence.reports().back();
                     last = Clock::now();
                   });
  std::cout << "  " << sequence.integrator_name() << (converged ? "" : ": NOT converged") << '\n';
  quiet.print("no state changes:", unit);
  busy.print("states change:", unit);
}

} // namespace

int main(int argc, char **argv) {
  try {
    const std::string file = argc > 1 ? argv[1] : "";
    std::vector<std::string> given;
    for (int i = 2; i + 1 < argc; i += 2)
      given.push_back(argv[i + 1]);
    for (const std::string shaking : {"0.1", "3"})
      for (const std::string integrator : {"moreau_jean", "newmark"}) {
        std::vector<std::string> options = {"Time/Integrator = " + integrator,
                                            "Step shake/Loads = weight, quake " + shaking};
        options.insert(options.end(), given.begin(), given.end());
        LawLibrary laws;
        laws.load_builtin();
        const Scene scene = read_scene(file, options, laws);
        measure(file, options, laws, scene);
      }
    return 0;
  } catch (const std::exception &error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
