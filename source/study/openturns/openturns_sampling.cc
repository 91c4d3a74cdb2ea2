// SPDX-License-Identifier: LGPL-2.1-or-later
#include "study/sampling.h"

#include <openturns/CorrelationAnalysis.hxx>
#include <openturns/IndependentCopula.hxx>
#include <openturns/LHSExperiment.hxx>
#include <openturns/LogNormal.hxx>
#include <openturns/LogNormalMuSigma.hxx>
#include <openturns/LowDiscrepancyExperiment.hxx>
#include <openturns/MartinezSensitivityAlgorithm.hxx>
#include <openturns/MonteCarloExperiment.hxx>
#include <openturns/Normal.hxx>
#include <openturns/ParametrizedDistribution.hxx>
#include <openturns/RandomGenerator.hxx>
#include <openturns/SobolIndicesExperiment.hxx>
#include <openturns/SobolSequence.hxx>
#include <openturns/Uniform.hxx>

#include <algorithm>
#include <cmath>

namespace frictionbeam::study {

namespace {

OT::Distribution uncut(const Distribution &distribution) {
  switch (distribution.kind) {
  case Distribution::Kind::uniform:
    return OT::Uniform(distribution.from, distribution.to);
  case Distribution::Kind::normal:
    return OT::Normal(distribution.mean, distribution.deviation);
  case Distribution::Kind::log_normal:
    break;
  }
  return OT::ParametrizedDistribution(
      OT::LogNormalMuSigma(distribution.mean, distribution.deviation, 0.));
}

/// Independent variables that are uniform from 0 to 1.
OT::Distribution unit_cube(const unsigned int n_variables) {
  return OT::IndependentCopula(n_variables);
}

Points points_of(const OT::Sample &sample) {
  Points points(sample.getSize(), std::vector<double>(sample.getDimension()));
  for (OT::UnsignedInteger i = 0; i < sample.getSize(); ++i)
    for (OT::UnsignedInteger j = 0; j < sample.getDimension(); ++j)
      points[i][j] = sample(i, j);
  return points;
}

OT::Sample sample_of(const Points &points) {
  OT::Sample sample(points.size(), points.front().size());
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < points[i].size(); ++j)
      sample(i, j) = points[i][j];
  return sample;
}

OT::Sample column_of(const std::vector<double> &values) {
  OT::Sample sample(values.size(), 1);
  for (std::size_t i = 0; i < values.size(); ++i)
    sample(i, 0) = values[i];
  return sample;
}

std::vector<double> vector_of(const OT::Point &point) { return {point.begin(), point.end()}; }

/// Points of the Sobol sequence, moved by a random vector and back into the cube from its other
/// side; the first seed leaves them as they are.
OT::LowDiscrepancyExperiment sobol_experiment(const unsigned int n_runs,
                                              const unsigned int n_variables,
                                              const unsigned int seed) {
  OT::RandomGenerator::SetSeed(seed);
  OT::LowDiscrepancyExperiment experiment(OT::SobolSequence(n_variables), unit_cube(n_variables),
                                          n_runs, true);
  experiment.setRandomize(seed != 1);
  return experiment;
}

class OpenTurnsSampling final : public Sampling {
public:
  std::function<double(double)> quantiles(const Distribution &distribution) const override {
    const OT::Distribution whole = uncut(distribution);
    if (distribution.kind == Distribution::Kind::uniform ||
        (std::isinf(distribution.from) && std::isinf(distribution.to)))
      return [whole](const double probability) { return whole.computeScalarQuantile(probability); };
    // By the distribution's own functions: F^-1(F(a) + p (F(b) - F(a))).
    const double from = distribution.from, to = distribution.to,
                 below = std::isinf(from) ? 0. : whole.computeCDF(from),
                 above = std::isinf(to) ? 1. : whole.computeCDF(to);
    return [=](const double probability) {
      return std::clamp(whole.computeScalarQuantile(below + probability * (above - below)), from,
                        to);
    };
  }

  Points random(const unsigned int n_runs, const unsigned int n_variables,
                const unsigned int seed) const override {
    OT::RandomGenerator::SetSeed(seed);
    return points_of(OT::MonteCarloExperiment(unit_cube(n_variables), n_runs).generate());
  }

  Points latin_hypercube(const unsigned int n_runs, const unsigned int n_variables,
                         const unsigned int seed) const override {
    OT::RandomGenerator::SetSeed(seed);
    return points_of(OT::LHSExperiment(unit_cube(n_variables), n_runs).generate());
  }

  Points sobol_sequence(const unsigned int n_runs, const unsigned int n_variables,
                        const unsigned int seed) const override {
    return points_of(sobol_experiment(n_runs, n_variables, seed).generate());
  }

  Points saltelli(const unsigned int n_rows, const unsigned int n_variables,
                  const unsigned int seed) const override {
    return points_of(
        OT::SobolIndicesExperiment(sobol_experiment(n_rows, n_variables, seed), false).generate());
  }

  SobolIndices sobol_indices(const Points &design, const std::vector<double> &result,
                             const unsigned int n_rows) const override {
    OT::MartinezSensitivityAlgorithm algorithm(sample_of(design), column_of(result), n_rows);
    algorithm.setUseAsymptoticDistribution(true);
    SobolIndices indices{vector_of(algorithm.getFirstOrderIndices()),
                         vector_of(algorithm.getTotalOrderIndices())};
    const OT::Interval first = algorithm.getFirstOrderIndicesInterval(),
                       total = algorithm.getTotalOrderIndicesInterval();
    indices.first_low = vector_of(first.getLowerBound());
    indices.first_high = vector_of(first.getUpperBound());
    indices.total_low = vector_of(total.getLowerBound());
    indices.total_high = vector_of(total.getUpperBound());
    return indices;
  }

  Points rank_correlations(const Points &points, const Points &results) const override {
    const OT::Sample ranks = sample_of(points).rank();
    Points correlations;
    for (const std::vector<double> &result : results)
      correlations.push_back(vector_of(
          OT::CorrelationAnalysis(ranks, column_of(result).rank()).computePearsonCorrelation()));
    return correlations;
  }
};

} // namespace

} // namespace frictionbeam::study

/// What load_sampling() asks for.
extern "C" const frictionbeam::study::Sampling *frictionbeam_sampling() {
  static const frictionbeam::study::OpenTurnsSampling sampling;
  return &sampling;
}
