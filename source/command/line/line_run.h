// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/sequence/load_sequence.h"
#include "command/line/frames_of_step.h"
#include "command/line/progress_line.h"
#include "results/envelope/envelope.h"
#include "results/envelope/kept_instants.h"
#include "results/file/checkpoint.h"
#include "results/file/contact_problem_writer.h"
#include "results/file/csv_writer.h"
#include "results/file/vtu_writer.h"
#include "results/inelastic/section_watch.h"
#include "results/quantity/collector.h"

#include <deal.II/base/timer.h>

#include <memory>
#include <optional>

namespace frictionbeam {

/// Runs a sequence, and has all look on that gather results and write files while it goes: into
/// Scene::output.directory, none if that is empty.
class LineRun {
public:
  LineRun(const Model &model, LoadSequence &sequence, Results &results);
  ~LineRun();

  /// From the beginning, or from the checkpoint. @return whether every step converged
  bool run();
  /// What the states that were seen give together: modes and combinations, stresses, quantities,
  /// files.
  void conclude(const bool converged);

private:
  void open_files();
  void transfer(Archive &archive);
  void observe(const Progress &progress, const LineState &state);
  /// Between increments: write a checkpoint if it is time, and end if a signal came.
  void pause();
  bool needs_line(const Progress &progress, const double time);

  const Model &model;
  const Scene &scene;
  LoadSequence &sequence;
  Results &results;
  std::unique_ptr<CsvWriter> csv; ///< these three: null if it writes none
  std::unique_ptr<VtuWriter> vtu;
  std::unique_ptr<ContactProblemWriter> contact_problems;
  Collector collector;
  Envelope envelope;
  SectionWatch sections;
  std::optional<Checkpoint> checkpoint;
  std::optional<LineState> modal_state; ///< at the end of the step that modes start from
  bool line_is_known = true;            ///< of a reduced line, not at every instant
  FramesOfStep vtu_frames;
  KeptInstants kept_instants;
  ProgressLine progress_line;
  dealii::Timer output_timer;
};

} // namespace frictionbeam
