// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/sequence/load_sequence.h"
#include "results/frame/section_forces.h"
#include "results/quantity/collector.h"
#include "results/stress/stress_evaluation.h"

namespace frictionbeam::study {

/**
 * The numbers of a study's run (names_of()) from the states of a line, without what is only drawn
 * or written: places, axes, formulas of the stress code and section forces of unit motions are
 * worked out once for all runs on the model. For linear cells in static steps; can_do() says
 * whether it has all that the scene asks for.
 */
class QuickLine {
public:
  static bool can_do(const Scene &scene);

  explicit QuickLine(const Model &model);

  /// To be called with the state at the end of each step, in their order.
  void observe(const unsigned int step, const LineState &state);
  /// After the last step: results that have these numbers, and nothing else.
  const Results &conclude();

private:
  /// A stress case: formulas and what they allow, by station.
  struct Case {
    std::string kind, name;
    unsigned int step = 0, from = 0;
    bool is_range = false;
    std::vector<StressCode::Formula> formulas; ///< of each of the points
    std::vector<StressEvaluation::Axes> axes;
    std::vector<double> allowed; ///< of a range: with nothing sustained
  };

  void find_points();
  void add_case(const std::string &kind, const std::string &from, const std::string &to);
  /// Stress at all stations of its frames [Pa].
  void evaluate(const Case &of, std::vector<double> &stress) const;
  /// Forces of all stations; the frame gets them where a quantity of its step asks for some.
  void set_forces(const LineState &state, Frame &frame);
  double evaluate(const Quantity &quantity, const Frame &frame, const LineState &state);
  void find_stresses();
  void find_quantities();

  const Model &model;
  const Scene &scene;
  Results results;
  Collector collector;
  FrameBuilder builder;
  SectionForces section_forces;
  std::vector<std::vector<double>> forces;      ///< by step: six of each station, as in Station
  std::unique_ptr<StressEvaluation> evaluation; ///< null without a code
  std::vector<StressPoint> points;              ///< all different ones
  std::vector<unsigned int> point_of;           ///< of each station, among these
  std::vector<Case> cases;                      ///< as evaluate_stresses() has them
  std::vector<std::optional<double>> values;    ///< beside Scene::quantities, SI
};

} // namespace frictionbeam::study
