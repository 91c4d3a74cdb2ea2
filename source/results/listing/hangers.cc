// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/listing/hangers.h"

#include "results/file/csv_writer.h"
#include "results/file/output_file.h"
#include "results/page/html.h"
#include "results/text.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace frictionbeam {

namespace {

/// Whether a frame is a state that hangers are chosen for.
bool is_operating(const Scene &scene, const Frame &frame) {
  if (!frame.end_of_step || frame.step >= scene.steps.size())
    return false;
  const LoadStep &step = scene.steps[frame.step];
  const auto &occasional = scene.stress.occasional;
  return !step.transient && !step.finds_limit &&
         std::count(occasional.begin(), occasional.end(), step.name) == 0 &&
         std::any_of(step.loads.begin(), step.loads.end(), [&](const auto &load) {
           return scene.loads[load.first].kind == Load::Kind::weight && load.second != 0.;
         });
}

/// How far a spring's point has moved the way it pulls; empty where it is on no pipe.
std::optional<double> travel_of(const Results &results, const Frame &frame, const Spring &spring) {
  for (const PointInfo &info : results.points)
    if (info.name == spring.point)
      for (const Station &station : frame.line)
        if (station.vertex == info.vertex)
          return product(station.displacement, spring.directions[2]);
  return {};
}

/// One spring of a hanger over all states.
class Course {
public:
  Course(const Scene &scene, const Results &results, const Hanger &hanger, const std::size_t place)
      : scene(scene), results(results), hanger(hanger),
        spring(scene.springs[hanger.springs[place]]) {
    use.name = spring.name;
    use.point = spring.point;
    use.stiffness = spring.stiffness[2];
    use.cold_load = use.least_load = use.most_load = spring.preload;
    use.least_step = use.most_step = use.step = "cold";
    use.allowed_variability = hanger.largest_variation;
    if (place < hanger.items.size()) {
      use.item = hanger.items[place].name;
      use.least_allowed = hanger.items[place].least_load;
      use.most_allowed = hanger.items[place].most_load;
      use.allowed_travel = hanger.items[place].travel;
    }
    while (restraint < results.restraints.size() &&
           results.restraints[restraint].name != spring.name)
      ++restraint;
  }

  /// False if the hot step was not reached.
  bool find_hot() {
    for (const Frame &frame : results.frames)
      if (frame.end_of_step && frame.name == hanger.hot_step &&
          restraint < frame.reactions.size()) {
        use.hot_load = load(frame);
        use.travel =
            travel_of(results, frame, spring)
                .value_or(use.stiffness > 0. ? (use.cold_load - use.hot_load) / use.stiffness
                                             : std::numeric_limits<double>::quiet_NaN());
        return true;
      }
    return false;
  }

  void find_variability() {
    include("cold", use.cold_load);
    for (const Frame &frame : results.frames)
      if (is_operating(scene, frame)) {
        include(frame.name, load(frame));
        if (const auto travel = travel_of(results, frame, spring)) {
          lowest = std::min(lowest, *travel);
          highest = std::max(highest, *travel);
          use.largest_travel = highest - lowest;
        }
      }
  }

  HangerUse use;

private:
  /// The way it pulls.
  double load(const Frame &frame) const {
    return product(frame.reactions[restraint], spring.directions[2]);
  }

  void include(const std::string &step, const double load) {
    const double change = use.hot_load > 0. ? std::abs(load - use.hot_load) / use.hot_load
                                            : std::numeric_limits<double>::infinity();
    if (change > use.variability) {
      use.variability = change;
      use.step = step;
    }
    if (load < use.least_load) {
      use.least_load = load;
      use.least_step = step;
    }
    if (load > use.most_load) {
      use.most_load = load;
      use.most_step = step;
    }
  }

  const Scene &scene;
  const Results &results;
  const Hanger &hanger;
  const Spring &spring;
  std::size_t restraint = 0;
  double lowest = 0., highest = 0.; ///< travel, from before anything has moved [m]
};

} // namespace

std::vector<HangerUse> evaluate_hangers(const Scene &scene, const Results &results) {
  std::vector<HangerUse> uses;
  for (const Hanger &hanger : scene.hangers)
    for (std::size_t i = 0; i < hanger.springs.size(); ++i) {
      Course course(scene, results, hanger, i);
      if (!course.find_hot())
        continue;
      course.find_variability();
      uses.push_back(course.use);
    }
  return uses;
}

std::string hanger_section(const Results &results) {
  const auto column = [&](const auto &value) {
    std::vector<decltype(value(HangerUse()))> values;
    for (const HangerUse &use : results.hangers)
      values.push_back(value(use));
    return values;
  };
  const auto percent = [](const double part) {
    return std::isfinite(part) ? fixed_number(100. * part, 1) : dash;
  };
  const bool any_item = std::any_of(results.hangers.begin(), results.hangers.end(),
                                    [](const HangerUse &use) { return !use.item.empty(); });
  double largest = 0.;
  for (const HangerUse &use : results.hangers)
    largest = std::max({largest, use.most_load, use.cold_load, use.hot_load});
  HtmlTable table(results.units);
  table.text("hanger", column([](const HangerUse &use) { return use.name; }))
      .text("at", column([](const HangerUse &use) { return use.point; }));
  if (any_item)
    table.text("item",
               column([](const HangerUse &use) { return use.item.empty() ? dash : use.item; }));
  table.numbers("stiffness", "N/m", column([](const HangerUse &use) { return use.stiffness; }))
      .numbers("cold load", "N", column([](const HangerUse &use) { return use.cold_load; }),
               largest)
      .numbers("hot load", "N", column([](const HangerUse &use) { return use.hot_load; }), largest)
      .numbers("travel", "m", column([](const HangerUse &use) { return use.travel; }))
      .right("variability [%]", column([&](const HangerUse &use) {
               return (use.variability > use.allowed_variability ? "\u2717 " : "") +
                      percent(use.variability);
             }))
      .right("allowed [%]",
             column([&](const HangerUse &use) { return percent(use.allowed_variability); }))
      .text("in", column([](const HangerUse &use) { return use.step; }))
      .numbers("least load", "N", column([](const HangerUse &use) { return use.least_load; }),
               largest)
      .numbers("most load", "N", column([](const HangerUse &use) { return use.most_load; }),
               largest);
  if (any_item)
    table
        .numbers("range from", "N", column([](const HangerUse &use) { return use.least_allowed; }),
                 largest)
        .numbers("range to", "N", column([](const HangerUse &use) { return use.most_allowed; }),
                 largest)
        .numbers("largest travel", "m",
                 column([](const HangerUse &use) { return use.largest_travel; }))
        .numbers("travel it has", "m", column([](const HangerUse &use) {
                   return use.allowed_travel > 0. ? use.allowed_travel
                                                  : std::numeric_limits<double>::quiet_NaN();
                 }));
  return table.str() +
         html_note("Cold: before anything has moved. Variability is the largest change of load "
                   "against the hot one over all static steps with weight that are not occasional, "
                   "and the cold load; \u2717: more than the hanger's Variation, or a hot load not "
                   "above 0, of which there is none. Travel is the way "
                   "it pulls, from cold to hot. hangers.csv has the same.");
}

void write_hangers(const Results &results, const std::string &folder) {
  if (results.hangers.empty())
    return;
  const double force = results.units.factor("N");
  std::string text = "hanger,point,item,stiffness,cold_load,hot_load,travel,variability,"
                     "allowed_variability,step,least_load,least_step,most_load,most_step,"
                     "range_from,range_to,largest_travel,travel_of_item\n";
  for (const HangerUse &use : results.hangers) {
    text +=
        csv_field(use.name) + ',' + csv_field(use.point) + ',' + csv_field(use.item) + ',' +
        exact_number(use.stiffness / results.units.factor("N/m")) + ',' +
        exact_number(use.cold_load / force) + ',' + exact_number(use.hot_load / force) + ',' +
        (std::isfinite(use.travel) ? exact_number(use.travel / results.units.factor("m")) : "") +
        ',' + (std::isfinite(use.variability) ? exact_number(use.variability) : "") + ',' +
        exact_number(use.allowed_variability) + ',' + csv_field(use.step) + ',' +
        exact_number(use.least_load / force) + ',' + csv_field(use.least_step) + ',' +
        exact_number(use.most_load / force) + ',' + csv_field(use.most_step);
    text += use.item.empty() ? ",,"
                             : ',' + exact_number(use.least_allowed / force) + ',' +
                                   exact_number(use.most_allowed / force);
    text += ',' + exact_number(use.largest_travel / results.units.factor("m")) + ',' +
            (use.allowed_travel > 0. ? exact_number(use.allowed_travel / results.units.factor("m"))
                                     : "") +
            '\n';
  }
  write_file(folder + "/hangers.csv", text);
}

} // namespace frictionbeam
