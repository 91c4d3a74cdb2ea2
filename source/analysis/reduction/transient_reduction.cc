// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/reduction/transient_reduction.h"

#include "base/user_error.h"

#include <deal.II/base/timer.h>

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {

constexpr double small_part = 0.01; ///< of the largest: differences are relative to no less
constexpr unsigned int first_modes =
    10; ///< of the first trial, at least; else as many as kept unknowns
constexpr double next_eigenvalue = 4.; ///< of the next trial: twice the frequency
constexpr double expected_ratio = 0.1; ///< of one difference to the one before
constexpr double safety = 2.;          ///< of the estimate
constexpr double worth_while = 0.25;   ///< of the line's unknowns

double frequency(const double eigenvalue) { return std::sqrt(eigenvalue) / (2. * M_PI); }

/// Largest of these quotients, with sizes no smaller than a part of the largest size.
double largest_quotient(const Vector &differences, const Vector &sizes) {
  const double least = sizes.size() > 0 ? small_part * sizes.maxCoeff() : 0.;
  double largest = 0.;
  for (int i = 0; i < sizes.size(); ++i)
    if (differences[i] > 0.)
      largest = std::max(largest, differences[i] / std::max(sizes[i], least));
  return largest;
}

/// The displacements of points, or their rotations.
Vector select(const Vector &motions, const bool rotations) {
  Vector result(motions.size() / 2);
  for (int i = 0; i < result.size(); ++i)
    result[i] = motions[6 * (i / 3) + i % 3 + (rotations ? 3 : 0)];
  return result;
}

/// The loads in a step, on a line that is reduced.
LoadCourse course_of(const TransientStep &start, const Model &reduced) {
  LoadCourse course(reduced);
  course.begin_step(start.step, start.from, start.target, start.start,
                    reduced.scene.steps[start.step].ramp);
  return course;
}

} // namespace

MotionDifference difference(const MotionRecord &coarse, const MotionRecord &fine) {
  Vector force_changes, forces, motion_changes, motions;
  for (std::size_t i = 0, j = 0; i < coarse.time.size() && j < fine.time.size();) {
    if (coarse.time[i] != fine.time[j]) {
      ++(coarse.time[i] < fine.time[j] ? i : j);
      continue;
    }
    if (forces.size() + motions.size() == 0) {
      force_changes = forces = Vector::Zero(fine.forces[j].size());
      motion_changes = motions = Vector::Zero(fine.motions[j].size());
    }
    force_changes += (coarse.forces[i] - fine.forces[j]).cwiseAbs2();
    forces += fine.forces[j].cwiseAbs2();
    motion_changes = motion_changes.cwiseMax((coarse.motions[i] - fine.motions[j]).cwiseAbs());
    motions = motions.cwiseMax(fine.motions[j].cwiseAbs());
    ++i;
    ++j;
  }
  MotionDifference result;
  result.forces = largest_quotient(force_changes.cwiseSqrt(), forces.cwiseSqrt());
  for (const bool rotations : {false, true})
    result.motions = std::max(result.motions, largest_quotient(select(motion_changes, rotations),
                                                               select(motions, rotations)));
  return result;
}

TransientReduction::TransientReduction(const Model &model, const PieceObserver &observer)
    : model(model), settings(model.scene.time.reduction), of_pieces(observer) {}

std::vector<bool> TransientReduction::acting(const TransientStep &start) const {
  std::vector<bool> result;
  for (unsigned int l = 0; l < start.target.size(); ++l)
    result.push_back(start.from[l] != 0. || start.target[l] != 0.);
  return result;
}

bool TransientReduction::prepare(const TransientStep &start, const LineState &state,
                                 ReductionAccount &account) {
  march.reset();
  line.reset();
  if (!parts)
    parts = std::make_unique<LineParts>(model);
  account.n_line = model.space.n_unknowns();
  account.n_kept = parts->kept().size();
  if (parts->n_inner() == 0) {
    account.remark = "not reduced: all unknowns are those of contact nodes";
    return false;
  }
  choice = settings.modes == ReductionSettings::Modes::number ? parts->lowest(settings.n_modes)
                                                              : choose(start, state, account);
  if (!account.remark.empty())
    return false;
  begun = state;
  line = std::make_unique<ReducedLine>(model, *parts, choice, state, acting(start));
  account.is_reduced = true;
  account.n_reduced = line->model().space.n_unknowns();
  account.n_modes = choice.n;
  account.n_static_shapes = line->n_static_shapes();
  account.n_left_out = parts->n_modes() - choice.n;
  account.highest_frequency = frequency(choice.highest);
  account.next_frequency = frequency(choice.next);
  return true;
}

LineParts::Choice TransientReduction::choose(const TransientStep &start, const LineState &state,
                                             ReductionAccount &account) {
  account.demanded = settings.tolerance;
  const bool has_point = std::any_of(
      model.scene.quantities.begin(), model.scene.quantities.end(),
      [&](const Quantity &quantity) { return model.mesh.points.count(quantity.where) > 0; });
  if (model.contacts.size() == 0 && model.scene.monitors.empty() && !has_point)
    throw UserError("Time/Modes = auto has nothing to judge by: there is no contact and no point "
                    "in Monitors or Quantities. Name one, or set Modes to a number.");
  LineParts::Choice coarser =
      parts->below(parts->lowest(std::max(first_modes, account.n_kept)).highest);
  if (coarser.n + account.n_kept > worth_while * account.n_line) {
    account.remark = "not reduced: the line has too few unknowns for it to be worth while";
    return coarser;
  }
  account.trials.emplace_back();
  MotionRecord record = try_out(start, state, coarser, account.trials.back());
  double last = -1.; // difference before; negative: not known
  for (double bound = coarser.highest;;) {
    if (coarser.next == 0.) { // all modes there are
      account.estimate = 0.;
      return coarser;
    }
    bound = std::max(next_eigenvalue * bound, coarser.next);
    const LineParts::Choice finer = parts->below(bound);
    if (finer.n + account.n_kept > worth_while * account.n_line) {
      account.remark = "not reduced: with " + std::to_string(coarser.n) +
                       " modes the error is not small enough, and with more it is not worth while";
      return coarser;
    }
    account.trials.emplace_back();
    ReductionAccount::Trial &trial = account.trials.back();
    MotionRecord finer_record = try_out(start, state, finer, trial);
    const bool both = trial.converged && account.trials[account.trials.size() - 2].converged;
    if (both) {
      const MotionDifference change = difference(record, finer_record);
      trial.forces = change.forces;
      trial.motions = change.motions;
      // Differences do not shrink evenly, and one may be small by chance.
      const double now = change.largest(), estimate = safety * std::max(now, last * expected_ratio);
      const bool enough = last >= 0.; // two differences
      last = now;
      if (enough && estimate <= settings.tolerance) {
        account.estimate = estimate;
        return finer;
      }
    } else
      last = -1.;
    coarser = finer;
    record = std::move(finer_record);
  }
}

MotionRecord TransientReduction::try_out(const TransientStep &start, const LineState &state,
                                         const LineParts::Choice &modes,
                                         ReductionAccount::Trial &trial) const {
  const dealii::Timer timer;
  const ReducedLine attempt(model, *parts, modes, state, acting(start));
  MotionRecord record;
  TimeMarch march(attempt.model());
  const auto take = [&](const Progress &progress, const LineState &now) {
    if (progress.behind_jump)
      return;
    const Contacts &contacts = attempt.model().contacts;
    Vector forces(3 * contacts.size()), motions(6 * attempt.monitored().size());
    for (unsigned int i = 0; i < contacts.size(); ++i)
      forces.segment<3>(3 * i) = contacts[i].share() * now.contact_stress[i].head<3>();
    for (unsigned int m = 0; m < attempt.monitored().size(); ++m)
      for (unsigned int c = 0; c < 6; ++c) {
        const int dof = attempt.monitored()[m][c];
        motions[6 * m + c] = dof >= 0 ? now.dofs[dof] : 0.;
      }
    record.time.push_back(now.time);
    record.forces.push_back(forces);
    record.motions.push_back(motions);
  };
  trial.n_modes = modes.n;
  LineState reduced = attempt.reduce(state);
  StepReport of_trial;
  trial.converged = march.run(start, course_of(start, attempt.model()), reduced, of_trial, {take});
  trial.seconds = timer.wall_time();
  return record;
}

void TransientReduction::expand(const LineState &now, const bool everything, LineState &to) const {
  line->expand(now, everything, to);
  if (!everything)
    return;
  model.space.expand(to.unknowns, to.dofs);
  to.dofs += course->imposed(now.time);
}

void TransientReduction::begin_march() {
  PieceObserver of_reduced_pieces;
  if (of_pieces)
    of_reduced_pieces = [this](const MotionPiece &piece) {
      within = *whole;
      const auto state_at = [&](const double time) -> const LineState & {
        expand(piece.state_at(time), true, within);
        return within;
      };
      of_pieces({piece.begin, piece.end, state_at, true});
    };
  march = std::make_unique<TimeMarch>(line->model(), of_reduced_pieces);
}

bool TransientReduction::run(const TransientStep &start, const LoadCourse &course_of_step,
                             LineState &state, StepReport &report, const Observers &observers,
                             const bool resumed) {
  Assert(line, dealii::ExcMessage("The step is not prepared."));
  course = &course_of_step;
  whole = &state;
  if (!resumed) {
    begin_march();
    reduced = line->reduce(state);
  }
  const bool done = march->run(
      start, course_of(start, line->model()), reduced, report,
      {[&](const Progress &progress, const LineState &now) {
         expand(now, !observers.needs_line || observers.needs_line(progress, now.time), state);
         observers.of_instants(progress, state);
       },
       {},
       observers.pause},
      resumed);
  expand(reduced, true, state);
  state.auxiliary = Vector::Zero(model.space.n_unknowns());
  name = march->integrator_name();
  march.reset();
  return done;
}

void TransientReduction::transfer(const TransientStep &start, Archive &archive) {
  bool is_cut = parts != nullptr, is_within = is_within_step();
  archive(name, is_cut, is_within);
  if (archive.reads() && is_cut)
    parts = std::make_unique<LineParts>(model);
  if (is_cut)
    archive(*parts);
  if (!is_within)
    return;
  archive(choice, begun, reduced);
  if (archive.reads()) {
    line = std::make_unique<ReducedLine>(model, *parts, choice, begun, acting(start));
    begin_march();
  }
  archive(*march);
}

} // namespace frictionbeam
