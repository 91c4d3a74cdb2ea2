// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/file/choice.h"

#include <limits>
#include <string>
#include <vector>

/// @file What a parameter file says of a study: which entries vary, how, and in which runs.
namespace frictionbeam {

/// How the runs of a study are chosen.
enum class StudyMethod {
  latin_hypercube,
  sobol_sequence,
  random,
  factorial,
  sobol_indices,
  morris
};

struct StudyMethodRow {
  const char *word;
  StudyMethod value;
  const char *meaning;
  bool is_a_sample; ///< of the variables' distribution, so that its quantiles are theirs
};

inline constexpr StudyMethodRow study_methods[] = {
    {"latin hypercube", StudyMethod::latin_hypercube,
     "each variable's range is cut into as many parts of equal probability as there are runs, and "
     "each part is met once",
     true},
    {"sobol sequence", StudyMethod::sobol_sequence,
     "points that fill the space of the variables evenly, and go on doing so with more runs", true},
    {"random", StudyMethod::random, "points drawn at random", true},
    {"factorial", StudyMethod::factorial, "every combination of the variables' levels", false},
    {"sobol indices", StudyMethod::sobol_indices,
     "Saltelli's design, Runs times the number of variables plus two, from which each variable's "
     "share in the variance comes",
     true},
    {"morris", StudyMethod::morris,
     "Morris' screening, Runs ways of one run more than there are variables, on each of which one "
     "variable after the other is changed",
     false}};

/// A section Vary: entries of the file that are given other values.
struct Variation {
  /// list: Values, each as likely as the others.
  enum class Shape { list, uniform, normal, log_normal };

  std::string name, origin;         ///< origin: where it stands in the file
  std::vector<std::string> entries; ///< "Section/Entry", as of --set
  Shape shape = Shape::list;
  std::vector<std::string> values;                        ///< of a list, as written
  double from = -std::numeric_limits<double>::infinity(); ///< the distribution is cut there
  double to = std::numeric_limits<double>::infinity();
  double mean = 0., deviation = 0.; ///< of the distribution before it is cut
  unsigned int levels = 0;          ///< of a distribution in a factorial study
  bool independent = false;         ///< every entry, at every place of a support, on its own
  bool is_factor = false;           ///< values multiply those of the file
};

inline constexpr Word<Variation::Shape> variation_shapes[] = {
    {"uniform", Variation::Shape::uniform, "the same probability From one value To another"},
    {"normal", Variation::Shape::normal},
    {"log-normal", Variation::Shape::log_normal, "the logarithm is normal; never negative"}};

struct StudySettings {
  StudyMethod method = StudyMethod::latin_hypercube;
  unsigned int n_runs = 0, seed = 0;
  unsigned int n_threads = 0;    ///< 0: one for each processor, or one for each process of MPI
  std::vector<double> quantiles; ///< probabilities, rising
  std::vector<Variation> variations;

  const StudyMethodRow &row() const { return row_of(study_methods, method); }
};

} // namespace frictionbeam
