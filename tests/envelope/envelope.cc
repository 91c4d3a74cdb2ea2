// SPDX-License-Identifier: LGPL-2.1-or-later
// Envelope shall hold the least and the largest of every number over all instants of a transient
// step, its start included, with the first instant of each, and stresses as the code's formula
// gives them at each instant. References: frames made at every instant, and B31.3's formula for
// straight pipe, written out here.
#include "../check.h"

#include "analysis/sequence/load_sequence.h"
#include "model/line_model.h"
#include "results/envelope/envelope.h"
#include "results/frame/frame_builder.h"
#include "results/support/support_states.h"
#include "scene/read_scene.h"

#include <algorithm>
#include <functional>
#include <map>

using namespace frictionbeam;

namespace {

/// Least and largest of numbers that are found by their names.
using Course = std::map<std::string, Extremes>;

/// Largest size of all whose names begin alike.
double size_of(const Course &course, const std::string &kind) {
  double size = 0.;
  for (const auto &[name, values] : course)
    if (name.compare(0, kind.size(), kind) == 0)
      size = std::max(size, std::abs(values.extreme()));
  return size;
}

void compare(const Extremes &found, const Extremes &wanted, const double size) {
  const double rounding = 1e-9 * size;
  CHECK(std::abs(found.least - wanted.least) <= rounding);
  CHECK(std::abs(found.largest - wanted.largest) <= rounding);
}

std::string label(const char *const kind, const std::size_t i, const unsigned int c) {
  return std::string(kind) + std::to_string(c / 3) + " " + std::to_string(i) + " " +
         std::to_string(c);
}

/// Longitudinal stress of straight pipe by B31.3, 320.2: index 1, pressure's thrust.
double straight_stress(const Motion &f, const double D, const double t, const double p) {
  const double d = D - 2. * t, pi = 3.14159265358979323846, A = pi * (D - t) * t,
               Z = pi / 32. * (std::pow(D, 4) - std::pow(d, 4)) / D,
               axial =
                   std::abs(f[0] / A + p * d * d / (D * D - d * d)) + std::hypot(f[4], f[5]) / Z;
  return std::sqrt(axial * axial + f[3] * f[3] / (Z * Z));
}

/// What frames at every instant say.
class Reference {
public:
  Reference(const Model &model, const Results &results)
      : model(model), results(results), builder(model, true) {}

  void include(const LineState &state, const bool is_start, const double pressure,
               const std::function<bool(unsigned int)> &may_strike) {
    const Frame frame = builder.make(state);
    for (unsigned int i = 0; i < frame.line.size(); ++i)
      for (unsigned int c = 0; c < 6; ++c)
        course[label("line", i, c)].include(frame.line[i].force[c], state.time);
    for (unsigned int i = 0; i < frame.reactions.size(); ++i)
      for (unsigned int c = 0; c < 6; ++c)
        course[label("reaction", i, c)].include(frame.reactions[i][c], state.time);
    for (unsigned int i = 0; i < frame.supports.size(); ++i) {
      const SupportState &s = frame.supports[i];
      const bool strikes = !is_start && may_strike(i) && before[i] == ContactStatus::open &&
                           s.status != ContactStatus::open;
      n_strikes += strikes ? 1 : 0;
      if (!strikes)
        course[label("support", i, 0)].include(s.fn, state.time);
      course[label("gap", i, 0)].include(s.gap, state.time);
    }
    double displacement = 0.;
    for (const Station &station : frame.line) {
      const Motion &u = station.displacement;
      if (station.is_node())
        displacement = std::max(displacement, std::hypot(u[0], u[1], u[2]));
      stress.push_back(straight_stress(station.force, 0.2191, 0.0082, pressure));
    }
    course["displacement"].include(displacement, state.time);
    worst.resize(frame.line.size(), 0.);
    for (unsigned int i = 0; i < frame.line.size(); ++i)
      worst[i] = std::max(worst[i], stress[i]);
    stress.clear();
    before = state.contact_status;
    last = frame;
    ++n_instants;
  }

  const Model &model;
  const Results &results;
  FrameBuilder builder;
  Course course;
  std::vector<double> stress, worst; ///< by station, as if all were straight
  std::vector<ContactStatus> before;
  Frame last;
  unsigned int n_instants = 0, n_strikes = 0;
};

void run(const std::string &file, const std::vector<std::string> &options, const bool combined) {
  LawLibrary laws;
  laws.load_builtin();
  Scene scene = read_scene(file, options, laws);
  if (combined)
    scene.combinations.push_back({Combination::Kind::sum, "both", {{"hold", 1.}, {"shake", -2.}}});
  const LineModel line(scene, laws);
  const Model &model = line.model();
  Results results;
  Reference reference(model, results);
  results.supports = support_infos(model);
  results.restraints = reference.builder.restraint_infos();
  for (const auto &[name, vertex] : model.mesh.points)
    results.points.push_back({name, vertex});
  auto envelope = std::make_unique<Envelope>(model, results);
  Results read; // by an envelope that goes on from a checkpoint
  read.supports = results.supports;
  read.restraints = results.restraints;
  read.points = results.points;
  std::unique_ptr<Envelope> other;
  const auto may_strike = [&](const unsigned int i) {
    return results.supports[i].name.compare(0, 6, "guides") == 0 ||
           results.supports[i].name.compare(0, 5, "rests") == 0;
  };
  LoadSequence sequence(model);
  const bool converged = sequence.run([&](const Progress &progress, const LineState &state) {
    if (progress.behind_jump) {
      for (Envelope *const one : {envelope.get(), other.get()})
        if (one != nullptr)
          one->observe_behind_jump(state, true);
      reference.include(state, false, 1e6, may_strike);
      return;
    }
    const bool end = progress.n_increments > 0 && progress.increment == progress.n_increments;
    if (end) { // as the program keeps them
      Frame frame = FrameBuilder(model, true).make(state);
      frame.name = scene.steps[progress.step].name;
      frame.step = progress.step;
      results.frames.push_back(frame);
    }
    envelope->observe(progress.step, progress.increment, progress.n_increments, state);
    if (other) {
      read.frames = results.frames;
      other->observe(progress.step, progress.increment, progress.n_increments, state);
    }
    if (progress.step == 0 && end)
      reference.include(state, true, 0., may_strike);
    if (progress.step == 1)
      reference.include(state, false, 1e6, may_strike);
    if (progress.step == 1 && progress.increment == 20) {
      Archive out;
      envelope->transfer(out);
      Archive in(out.bytes());
      read.frames = results.frames;
      other = std::make_unique<Envelope>(model, read);
      other->transfer(in);
    }
  });
  CHECK(converged);
  CHECK(results.envelopes.size() == 1);
  const StepEnvelope &found = results.envelopes.front();
  CHECK(found.step == 1 && found.n_instants == reference.n_instants && found.n_instants > 100);
  Course &course = reference.course;
  const std::size_t n = results.stations.size();
  CHECK(n == reference.last.line.size() && found.least.size() == 6 * n);
  unsigned int n_at_end = 0;
  for (std::size_t i = 0; i < n; ++i) {
    CHECK(std::abs(results.stations[i].s - reference.last.line[i].s) < 1e-12);
    for (unsigned int c = 0; c < 6; ++c) {
      const std::size_t k = 6 * i + c;
      const double size = size_of(course, c < 3 ? "line0" : "line1");
      compare({found.least[k], found.largest[k], found.least_at[k], found.largest_at[k]},
              course[label("line", i, c)], size);
      // Beyond what the end of the step shows.
      n_at_end += found.largest[k] > reference.last.line[i].force[c] + 0.05 * size ? 1 : 0;
    }
  }
  CHECK(n_at_end > n);
  for (std::size_t i = 0; i < found.restraints.size(); ++i)
    for (unsigned int c = 0; c < 6; ++c)
      compare(found.restraints[i].values[c], course[label("reaction", i, c)],
              size_of(course, c < 3 ? "reaction0" : "reaction1"));
  const bool events = scene.time.is_exact();
  unsigned int n_impacts = 0;
  for (std::size_t i = 0; i < found.supports.size(); ++i) {
    n_impacts += found.supports[i].n_impacts;
    if (!events)
      compare(found.supports[i].values[0], course[label("support", i, 0)],
              size_of(course, "support"));
    compare(found.supports[i].values[3], course[label("gap", i, 0)], size_of(course, "gap"));
    CHECK_NEAR(found.supports[i].impulse, sequence.state().contacts.impulse[i],
               1e-9); // none before the step, none after it
  }
  CHECK(events ? n_impacts == 0 : n_impacts == reference.n_strikes && n_impacts > 0);
  compare(found.displacement, course["displacement"], found.displacement.largest);

  // Stresses: one case of occasional, one range from hold.
  CHECK(found.stresses.size() == 2 && found.stresses[1].from == "hold");
  std::size_t n_asked = 0, n_straight = 0; // of bends there are as many cells as wind asks for
  for (std::size_t i = 0; i < n; ++i) {
    const Station &station = reference.last.line[i];
    const bool at_tee =
        station.position.distance(model.mesh.vertices[model.mesh.points.at("T")]) < 1e-9;
    if (station.bend_radius > 0. || at_tee)
      continue;
    ++n_asked;
    // The start has no pressure inside in the frame's sense, but the step's counts throughout.
    CHECK(found.stresses[0].stress[i] >= reference.worst[i] * (1. - 1e-9));
    n_straight += std::abs(found.stresses[0].stress[i] / reference.worst[i] - 1.) < 1e-9 ? 1 : 0;
  }
  CHECK(n_straight > n_asked / 2);
  std::cout << n_straight << " of " << n_asked << " straight stations\n";

  // Nozzles: the ratio's largest is that of the largest component.
  for (unsigned int i = 0; i < 2; ++i) {
    double use = 0.;
    for (unsigned int c = 0; c < 6; ++c)
      use = std::max(use, std::abs(course[label("reaction", i, c)].extreme()) /
                              scene.nozzles[0].allowed[c]);
    CHECK_NEAR(found.nozzles[i].utilization, use, 1e-9);
  }

  // A checkpoint changes nothing.
  CHECK(read.envelopes.size() == 1);
  const StepEnvelope &again = read.envelopes.front();
  CHECK(again.least == found.least && again.largest_at == found.largest_at);
  CHECK(again.n_instants == found.n_instants);
  CHECK(again.stresses[1].stress == found.stresses[1].stress);
  CHECK(again.supports[0].impulse == found.supports[0].impulse);

  CHECK(found.least_frame.has_value() == combined);
  if (combined)
    for (std::size_t i = 0; i < n; ++i)
      for (unsigned int c = 0; c < 6; ++c) {
        CHECK(found.least_frame->line[i].force[c] == found.least[6 * i + c]);
        CHECK(found.largest_frame->line[i].force[c] == found.largest[6 * i + c]);
      }
}

void check_extremes() {
  Extremes values;
  CHECK(!values.is_known() && values.extreme() == 0.);
  CHECK(values.include(1., 0.5) && values.include(-3., 1.) && !values.include(-3., 2.));
  CHECK(values.least == -3. && values.least_at == 1. && values.largest_at == 0.5);
  CHECK(values.extreme() == -3. && values.extreme_at() == 1.);
}

} // namespace

int main(int argc, char **argv) {
  try {
    const std::string file = argc > 1 ? argv[1] : "";
    check_extremes();
    run(file, {}, false);
    run(file, {}, true);
    run(file, {"Time/Integrator = newmark"}, false);
    run(file,
        {"Mesh/Bends = straight pieces", "Kinematics = corotational", "Time/Mass damping = 0",
         "Time/Stiffness damping = 0"},
        false);
  } catch (const std::exception &error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return check::report();
}
