// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/doubt/doubts.h"

#include "mesh/point_set.h"
#include "model/line_model.h"
#include "results/doubt/buckling.h"
#include "results/doubt/idle_supports.h"
#include "results/doubt/peaks_between_stations.h"
#include "results/doubt/pressed_span.h"
#include "results/doubt/soft_rigid_pipe.h"
#include "results/frame/frame_choice.h"
#include "results/stress/wall_stress.h"
#include "results/text.h"
#include "scene/file/parameter_file.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>

namespace frictionbeam {

namespace {

constexpr double large = 0.1;          ///< displacement over the line's size
constexpr double sagging = 0.01;       ///< sag over span
constexpr double instants = 10.;       ///< in a period of the highest mode
constexpr double same_place = 1e-6;    ///< [m]
constexpr unsigned int most_spans = 3; ///< that are named

double size_of(const std::vector<Station> &line) {
  Point3 low, high;
  for (unsigned int d = 0; d < 3; ++d) {
    const auto [least, most] =
        std::minmax_element(line.begin(), line.end(), [d](const Station &a, const Station &b) {
          return a.position[d] < b.position[d];
        });
    low[d] = least->position[d];
    high[d] = most->position[d];
  }
  return low.distance(high);
}

/// But for rounding.
bool are_alike(const Motion &a, const Motion &b) {
  constexpr double rounding = 1e-9;
  double largest = 0., difference = 0.;
  for (std::size_t c = 0; c < a.size(); ++c) {
    largest = std::max({largest, std::abs(a[c]), std::abs(b[c])});
    difference = std::max(difference, std::abs(a[c] - b[c]));
  }
  return difference <= rounding * largest;
}

/// Ends of static steps.
std::vector<const Frame *> static_ends(const Scene &scene, const Results &results) {
  std::vector<const Frame *> frames;
  for (const Frame &frame : results.frames)
    if (frame.end_of_step && frame.step < scene.steps.size() && !scene.steps[frame.step].transient)
      frames.push_back(&frame);
  return frames;
}

class Doubts {
public:
  Doubts(const Scene &scene, Results &results)
      : scene(scene), results(results), ends(static_ends(scene, results)), places(same_place) {
    for (const SupportInfo &info : results.supports)
      places.insert(info.position);
    for (const RestraintInfo &info : results.restraints)
      places.insert(info.position);
    holds.resize(places.points.size());
  }

  void of_displacements() {
    if (scene.kinematics != Kinematics::linear)
      return;
    double largest = 0.;
    const Frame *where = nullptr;
    for (const Frame &frame : results.frames)
      if (const double moved = frame.step < scene.steps.size() ? largest_motion(frame) : 0.;
          moved > largest) {
        largest = moved;
        where = &frame;
      }
    if (where != nullptr && largest > large * size_of(where->line))
      say("Step " + where->name + ": the line moves by " + length(largest) +
          ", more than a tenth of its size, while its displacements are taken for small ones. Look "
          "at loads, stiffnesses and units, or take Kinematics = corotational.");
  }

  void of_open_supports() {
    for (const Frame *const frame : ends)
      if (!frame->supports.empty() && has_rest() && !scene.steps[frame->step].loads.empty() &&
          std::all_of(frame->supports.begin(), frame->supports.end(),
                      [](const SupportState &state) { return stands_off(state, same_place); }))
        return say("Step " + frame->name +
                   ": no support touches the line at its end. Look at the direction of the loads.");
  }

  void of_sags() {
    std::vector<std::string> spans;
    for_each_span([&](const Frame &frame, const std::size_t begin, const std::size_t end) {
      if (sags(frame, begin, end))
        note(spans, span_in_words(frame, frame.line[begin], frame.line[end]));
    });
    if (spans.empty())
      return;
    std::string text;
    for (std::size_t i = 0; i < std::min<std::size_t>(spans.size(), most_spans); ++i)
      text += (i == 0 ? "" : ", ") + spans[i];
    if (spans.size() > most_spans)
      text += " and " + std::to_string(spans.size() - most_spans) + " more";
    say("Sag above a hundredth of the span: " + text + ".");
  }

  /// A remark on the worst step's end at which the line would buckle. With large displacements it
  /// does, but within cells that are a whole span.
  void of_buckling(const Model &model) {
    const auto &free = scene.free_motions;
    if (!(free[3] || free[4] || free[5]))
      return; // nothing bends
    const bool turns_far = scene.kinematics == Kinematics::corotational;
    constexpr unsigned int most_unknowns = 300000; // their factors take more than all else
    if (!turns_far && model.space.n_unknowns() > most_unknowns) {
      results.remarks.push_back(
          "Whether the line buckles has not been looked at, for it has more than " +
          std::to_string(most_unknowns) + " unknowns.");
      return;
    }
    constexpr double clearly = 1.05, rounding = 1e-6;
    double worst = clearly;
    std::string text;
    const auto take = [&](const Frame &frame, const Station &begin, const Station &end,
                          const double compression, const double ratio, const std::string &of) {
      if (!(ratio > (1. + rounding) * worst))
        return;
      worst = ratio;
      text = span_in_words(frame, begin, end) + " is pressed by " + force(compression) + ", " +
             rounded_number(ratio, 3) + " times " + of;
    };
    for (const Frame *const frame : ends)
      if (!turns_far) {
        if (const auto found = buckling_of(model, *frame, worst, same_place))
          take(*frame, found->begin, found->end, found->compression, found->ratio,
               "what buckles the line there as it is held, while small displacements know no "
               "buckling. Look at expansion, guides and spans, or take Kinematics = corotational.");
      } else if (const auto span = most_pressed_span(scene, results, *frame, same_place))
        take(*frame, span->begin, span->end, span->compression, span->ratio(),
             "its Euler load of " + force(span->euler_load) +
                 (span->has_free_end ? " with a free end" : " with ends that turn") +
                 ", while a single cell knows no buckling. Take a shorter Mesh/Cell length.");
    if (text.empty())
      return;
    text[0] = 'P'; // of a sentence that begins with "pipe"
    results.remarks.push_back(text);
  }

  /// Of pipes that answer elastically, nominal stresses of their walls at the ends of steps.
  void of_yielding() {
    double worst = 1.; // of the yield stress
    std::string text;
    for (const Frame &frame : results.frames) {
      if (frame.step >= scene.steps.size())
        continue;
      for (const Station &station : frame.line) {
        const Pipe &pipe = scene.pipes[station.pipe];
        const Material &material = scene.materials[pipe.material];
        const auto of_wall = material.yield_stress > 0. ? elastic_wall_stress(scene, station)
                                                        : std::optional<WallStress>();
        if (!of_wall || of_wall->von_mises <= worst * material.yield_stress)
          continue;
        const double stress = of_wall->von_mises;
        worst = stress / material.yield_stress;
        text = "Pipe " + pipe.name + ", s = " + length(station.s) + ", step " + frame.name +
               ": the equivalent stress is " +
               rounded_number(stress / scene.units.factor("Pa"), 3) + " " + scene.units.name("Pa") +
               ", " + rounded_number(worst, 3) + " times the Yield stress of material " +
               material.name +
               ", while the pipe is taken for elastic. Look at the supports, or give its Section a "
               "Law that yields.";
      }
    }
    if (!text.empty())
      say(text);
  }

  /// Remarks on what adds up in silence: temperatures, and pressures, of one pipe in one step.
  void of_sums_of_loads() {
    const auto is_any = [](const Pipe &) { return true; };
    const auto has_table = [this](const Pipe &pipe) {
      return !scene.materials[pipe.material].table.empty();
    };
    const auto note = [this](const std::string &where, const std::string &what) {
      if (!where.empty())
        results.remarks.push_back("Step " + where + ": their " + what + " add up.");
    };
    note(first_sum(Load::Kind::pressure, is_any), "pressures");
    const std::string heated = first_sum(Load::Kind::temperature, has_table);
    note(first_sum(Load::Kind::temperature, std::not_fn(has_table)), "rises of temperature");
    const std::string table = " With a mean expansion that depends on temperature this is not that "
                              "of a pipe that is so hot, which has one load with that temperature.";
    if (!heated.empty())
      results.remarks.push_back("Step " + heated +
                                ": their expansions add up, each that of its own temperature." +
                                table);
    if (const std::string part = first_part(has_table); !part.empty())
      results.remarks.push_back("Step " + part +
                                ": the expansion is a part of that of the load's "
                                "temperature, not that of a part of its rise." +
                                table);
  }

  /// Remarks on restraints of one point that hold the same: each has an even part of the force.
  void of_restraints_in_one_place() {
    if (results.frames.empty())
      return;
    std::map<std::size_t, std::size_t> first;
    const std::size_t n = results.restraints.size() - scene.springs.size(); // those come last
    for (std::size_t i = 0; i < n; ++i) {
      const auto [known, is_first] =
          first.emplace(places.insert(results.restraints[i].position), i);
      const std::size_t before = known->second;
      const std::string &name = results.restraints[i].name,
                        &other = results.restraints[before].name;
      if (!is_first &&
          std::any_of(results.frames.begin(), results.frames.end(), [&](const Frame &frame) {
            return i < frame.reactions.size() && frame.reactions[i] != Motion{} &&
                   are_alike(frame.reactions[i], frame.reactions[before]);
          }))
        results.remarks.push_back(other + " and " + name +
                                  " hold the same motions of one point: nothing says what either "
                                  "has of the force there, and each is told an even part.");
    }
  }

  void of_rigid_pipes() {
    constexpr double noticed = 0.01;
    SoftRigidPipe worst;
    const Frame *where = nullptr;
    for (const Frame *const frame : ends)
      if (const SoftRigidPipe one = softest_rigid_pipe(scene, *frame); one.share > worst.share) {
        worst = one;
        where = frame;
      }
    if (worst.share > noticed)
      results.remarks.push_back(
          "Pipe " + scene.pipes[worst.pipe].name +
          " is Rigid, a thousand times as stiff as its "
          "Section, and bends or stretches by some " +
          rounded_number(100. * worst.share, 1) + " % of the largest displacement in step " +
          where->name + ". Where it shall not, give it a Section of its own, as stiff as need be.");
  }

  void of_time_steps() {
    if (scene.time.is_exact() || scene.time.step == 0. || results.modes.empty() ||
        !has_transient_step(scene))
      return;
    const double frequency = results.modes.back().frequency;
    if (scene.time.step * frequency * instants > 1.)
      say("The time step of " + rounded_number(scene.time.step) +
          " s has fewer than ten instants "
          "in a period of mode " +
          std::to_string(results.modes.size()) + " (" + rounded_number(frequency, 4) + " Hz).");
  }

private:
  /// "NAME: loads A and B on pipe P", of the first step that has two of a kind on a pipe that is
  /// meant; empty if none has.
  template <typename IsMeant>
  std::string first_sum(const Load::Kind kind, const IsMeant &is_meant) const {
    for (const LoadStep &step : scene.steps)
      for (const Pipe &pipe : scene.pipes) {
        if (!is_meant(pipe))
          continue;
        std::vector<std::string> together;
        for (const auto &[number, factor] : step.loads)
          if (const Load &load = scene.loads[number];
              load.kind == kind && factor != 0. && load.is_on(pipe.name))
            together.push_back(load.name);
        if (together.size() > 1)
          return step.name + ", loads " + join(together) + " on pipe " + pipe.name;
      }
    return "";
  }
  /// "NAME: load A on pipe P", of the first step that heats such a pipe by a factor or a history.
  template <typename IsMeant>
  std::string first_part(const IsMeant &is_meant) const {
    for (const LoadStep &step : scene.steps)
      for (const auto &[number, factor] : step.loads)
        if (const Load &load = scene.loads[number]; load.kind == Load::Kind::temperature &&
                                                    factor != 0. &&
                                                    (factor != 1. || load.history.is_given()))
          for (const Pipe &pipe : scene.pipes)
            if (is_meant(pipe) && load.is_on(pipe.name))
              return step.name + ", load " + load.name + " on pipe " + pipe.name;
    return "";
  }
  void say(const std::string &text) { results.doubts.push_back(text); }
  static void note(std::vector<std::string> &list, const std::string &text) {
    if (std::count(list.begin(), list.end(), text) == 0)
      list.push_back(text);
  }
  std::string force(const double newtons) const {
    return rounded_number(newtons / scene.units.factor("N"), 3) + " " + scene.units.name("N");
  }
  std::string length(const double metres) const {
    return rounded_number(metres / scene.units.factor("m"), 3) + " " + scene.units.name("m");
  }
  bool has_rest() const {
    return std::any_of(results.supports.begin(), results.supports.end(),
                       [](const SupportInfo &info) { return holds_up(info); });
  }
  /// Restraints, and supports that touch the line.
  void find_what_holds(const Frame &frame) {
    std::fill(holds.begin(), holds.end(), false);
    for (const RestraintInfo &info : results.restraints)
      holds[places.insert(info.position)] = true;
    for (std::size_t i = 0; i < frame.supports.size(); ++i)
      if (!stands_off(frame.supports[i], same_place))
        holds[places.insert(results.supports[i].position)] = true;
  }
  /// Whether anything holds it there.
  bool is_held(const Station &station) {
    if (!station.is_node())
      return false;
    const std::size_t place = places.insert(station.position);
    return place < holds.size() && holds[place];
  }
  /// Call use(frame, begin, end) for each stretch of a pipe from one station that is held to the
  /// next, at the ends of static steps.
  template <typename Use>
  void for_each_span(const Use &use) {
    for (const Frame *const frame : ends) {
      find_what_holds(*frame);
      const std::vector<Station> &line = frame->line;
      for (std::size_t begin = 0; begin < line.size();) {
        std::size_t end = begin + 1;
        while (end < line.size() && line[end].pipe == line[begin].pipe && !is_held(line[end]))
          ++end;
        if (end < line.size() && line[end].pipe == line[begin].pipe && is_held(line[begin]))
          use(*frame, begin, end);
        begin = end;
      }
    }
  }
  /// Between two that are held, below the straight line from one to the other.
  static bool sags(const Frame &frame, const std::size_t begin, const std::size_t end) {
    const Station &first = frame.line[begin], &last = frame.line[end];
    const double span =
        std::hypot(last.position[0] - first.position[0], last.position[1] - first.position[1]);
    if (!(span > 0.))
      return false;
    double sag = 0.;
    for (std::size_t i = begin + 1; i < end; ++i) {
      const Station &station = frame.line[i];
      const double part = (station.s - first.s) / (last.s - first.s),
                   chord = first.displacement[2] +
                           part * (last.displacement[2] - first.displacement[2]);
      sag = std::max(sag, chord - station.displacement[2]);
    }
    return sag > sagging * span;
  }
  std::string span_in_words(const Frame &frame, const Station &begin, const Station &end) const {
    const std::string &first = scene.pipes[begin.pipe].name, &last = scene.pipes[end.pipe].name;
    return "pipe " + first + ", s = " + length(begin.s) + " to " +
           (last == first ? "" : "pipe " + last + ", s = ") + length(end.s) + " in step " +
           frame.name;
  }

  const Scene &scene;
  Results &results;
  const std::vector<const Frame *> ends;
  PointSet places;         ///< those of supports first
  std::vector<bool> holds; ///< of them, in the frame that is looked at
};

} // namespace

void add_doubts(const Model &model, Results &results) {
  const Scene &scene = model.scene;
  Doubts doubts(scene, results);
  doubts.of_displacements();
  doubts.of_open_supports();
  doubts.of_sags();
  doubts.of_buckling(model);
  doubts.of_yielding();
  doubts.of_time_steps();
  doubts.of_sums_of_loads();
  doubts.of_restraints_in_one_place();
  doubts.of_rigid_pipes();
  remark_on_idle_supports(scene, results);
  remark_on_peaks_between_stations(scene, results);
}

} // namespace frictionbeam
