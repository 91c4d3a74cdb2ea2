// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <limits>
#include <vector>

namespace frictionbeam::study {

using Points = std::vector<std::vector<double>>; ///< by run, by variable

/// A continuous distribution of one number; normal and log-normal ones may be cut.
struct Distribution {
  enum class Kind { uniform, normal, log_normal } kind = Kind::uniform;
  double mean = 0., deviation = 0.; ///< of what is not cut; not of uniform
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();
};

/// Of one result, by variable: share of its variance.
struct SobolIndices {
  std::vector<double> first, ///< of the variable alone
      total;                 ///< with all that it does together with others
  std::vector<double> first_low, first_high, total_low, total_high; ///< 95 % confidence
};

/**
 * Distributions, designs and sensitivities, all of them by OpenTURNS (Baudin, Dutfoy, Iooss,
 * Popelin: OpenTURNS, in: Handbook of Uncertainty Quantification, 2016,
 * doi 10.1007/978-3-319-11259-6_64-1), which only a study needs. So it is in a shared library of
 * its own, which load_sampling() opens.
 *
 * Designs are points of the unit cube; equal seeds give equal points.
 */
class Sampling {
public:
  virtual ~Sampling() = default;

  /// The distribution's quantiles by their probability.
  virtual std::function<double(double)> quantiles(const Distribution &distribution) const = 0;

  virtual Points random(const unsigned int n_runs, const unsigned int n_variables,
                        const unsigned int seed) const = 0;
  virtual Points latin_hypercube(const unsigned int n_runs, const unsigned int n_variables,
                                 const unsigned int seed) const = 0;
  /// Points of the Sobol sequence; with another seed than 1, shifted by a random vector
  /// (Cranley and Patterson).
  virtual Points sobol_sequence(const unsigned int n_runs, const unsigned int n_variables,
                                const unsigned int seed) const = 0;
  /// Saltelli's design: blocks A, B and, for each variable, A with that column of B.
  /// @param n_rows of a block
  virtual Points saltelli(const unsigned int n_rows, const unsigned int n_variables,
                          const unsigned int seed) const = 0;

  /// Of a result of all points of such a design, by Martinez' estimator, with its asymptotic
  /// confidence intervals.
  virtual SobolIndices sobol_indices(const Points &design, const std::vector<double> &result,
                                     const unsigned int n_rows) const = 0;
  /// Spearman's rank correlation of each result with each variable.
  /// @param results each of all runs
  virtual Points rank_correlations(const Points &points, const Points &results) const = 0;
};

/// The one there is. @throws UserError if the program was built without, that says how to get it
const Sampling &load_sampling();

} // namespace frictionbeam::study
