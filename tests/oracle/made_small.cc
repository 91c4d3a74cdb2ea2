// SPDX-License-Identifier: LGPL-2.1-or-later
#include "judge.h"

#include <algorithm>
#include <functional>
#include <set>

namespace oracle {

namespace {

using Change = std::function<bool(Scene &)>; ///< @return whether there was something to change

/// Leave out part @p i of a list.
template <typename List>
bool leave_out(List &list, const std::size_t i) {
  if (i >= list.size())
    return false;
  list.erase(list.begin() + i);
  return true;
}

bool leave_out_load(Scene &scene, const std::size_t i) {
  if (!leave_out(scene.loads, i))
    return false;
  for (Step &step : scene.steps) {
    auto &loads = step.loads;
    loads.erase(std::remove_if(loads.begin(), loads.end(),
                               [&](const auto &l) { return l.first == static_cast<int>(i); }),
                loads.end());
    for (auto &load : loads)
      if (load.first > static_cast<int>(i))
        --load.first;
  }
  return true;
}

template <typename Value>
bool set(Value &value, const Value &simple) {
  if (value == simple)
    return false;
  value = simple;
  return true;
}

/// All changes to try, the large ones first.
std::vector<Change> changes(const Scene &scene) {
  std::vector<Change> list;
  const auto each = [&](const std::size_t n, const std::function<bool(Scene &, std::size_t)> &f) {
    for (std::size_t i = n; i-- > 0;)
      list.push_back([=](Scene &s) { return f(s, i); });
  };
  each(scene.pipes.size(), [](Scene &s, const std::size_t i) { return leave_out(s.pipes, i); });
  each(scene.steps.size(), [](Scene &s, const std::size_t i) { return leave_out(s.steps, i); });
  each(scene.loads.size(), leave_out_load);
  each(scene.supports.size(),
       [](Scene &s, const std::size_t i) { return leave_out(s.supports, i); });
  each(scene.springs.size(), [](Scene &s, const std::size_t i) { return leave_out(s.springs, i); });
  each(scene.masses.size(), [](Scene &s, const std::size_t i) { return leave_out(s.masses, i); });
  each(scene.joints.size(), [](Scene &s, const std::size_t i) { return leave_out(s.joints, i); });
  each(scene.tees.size(), [](Scene &s, const std::size_t i) { return leave_out(s.tees, i); });
  each(scene.hangers.size(), [](Scene &s, const std::size_t i) { return leave_out(s.hangers, i); });
  each(scene.initial.size(), [](Scene &s, const std::size_t i) { return leave_out(s.initial, i); });
  each(scene.more.size(), [](Scene &s, const std::size_t i) { return leave_out(s.more, i); });
  each(scene.settings.size(),
       [](Scene &s, const std::size_t i) { return leave_out(s.settings, i); });
  each(scene.spectra.size(), [](Scene &s, const std::size_t i) { return leave_out(s.spectra, i); });
  each(scene.combinations.size(),
       [](Scene &s, const std::size_t i) { return leave_out(s.combinations, i); });
  each(scene.nozzles.size(), [](Scene &s, const std::size_t i) { return leave_out(s.nozzles, i); });
  each(scene.points.size(), [](Scene &s, const std::size_t i) { return leave_out(s.points, i); });
  each(scene.monitors.size(),
       [](Scene &s, const std::size_t i) { return leave_out(s.monitors, i); });
  for (std::size_t p = 0; p < scene.pipes.size(); ++p) {
    for (std::size_t c = scene.pipes[p].route.size(); c-- > 1;) {
      list.push_back([=](Scene &s) { // a corner less
        return s.pipes[p].route.size() > 2 && leave_out(s.pipes[p].route, c);
      });
      list.push_back([=](Scene &s) {
        return c < s.pipes[p].route.size() && set(s.pipes[p].route[c].bend, 0.);
      });
    }
    list.push_back([=](Scene &s) { return set(s.pipes[p].rigid, false); });
    list.push_back([=](Scene &s) { return set(s.pipes[p].mass, -1.); });
    list.push_back([=](Scene &s) { return set(s.pipes[p].end_section, -1); });
    list.push_back([=](Scene &s) { return set(s.pipes[p].section, 0); });
    list.push_back([=](Scene &s) { return set(s.pipes[p].material, 0); });
    list.push_back([=](Scene &s) { return set(s.pipes[p].flexibility, Pipe::Flexibility::none); });
    list.push_back([=](Scene &s) { return set(s.pipes[p].stiffening_pressure, 0.); });
  }
  list.push_back([](Scene &s) { return set(s.units, std::string("si")); });
  list.push_back([](Scene &s) { return set(s.modes, 0); });
  list.push_back([](Scene &s) { return set(s.quantities, false); });
  list.push_back([](Scene &s) { return set(s.large_displacements, false); });
  list.push_back([](Scene &s) { return set(s.stations, 0); });
  list.push_back([](Scene &s) { return set(s.cell_length, 0.); });
  list.push_back([](Scene &s) { return set(s.arcs, true); });
  list.push_back([](Scene &s) { return set(s.installation_temperature, 20.); });
  list.push_back([](Scene &s) { return set(s.sections_reversed, false); });
  for (std::size_t i = 0; i < scene.supports.size(); ++i) {
    list.push_back([=](Scene &s) { return set(s.supports[i].kind, std::string("anchor")); });
    list.push_back([=](Scene &s) { return set(s.supports[i].ground, std::string()); });
    list.push_back([=](Scene &s) { return set(s.supports[i].pad, std::string()); });
    list.push_back([=](Scene &s) { return set(s.supports[i].torsional_rigidity, 0.); });
    list.push_back([=](Scene &s) { return set(s.supports[i].patch_radius, 0.); });
    list.push_back([=](Scene &s) { return set(s.supports[i].dynamic_friction, -1.); });
    list.push_back([=](Scene &s) { return set(s.supports[i].restitution, 0.); });
    list.push_back([=](Scene &s) { return set(s.supports[i].normal_force, 0.); });
    each(scene.supports[i].ground_motion.size(), [=](Scene &s, const std::size_t row) {
      return leave_out(s.supports[i].ground_motion, row);
    });
    list.push_back([=](Scene &s) { return set(s.supports[i].friction, 0.); });
    list.push_back([=](Scene &s) { return set(s.supports[i].gap, 0.); });
    list.push_back([=](Scene &s) { return set(s.supports[i].axial_rigidity, 0.); });
    list.push_back([=](Scene &s) { return set(s.supports[i].shear_rigidity, 0.); });
    list.push_back([=](Scene &s) { return set(s.supports[i].ratio, 1.); });
    list.push_back(
        [=](Scene &s) { return set(s.supports[i].rotations, Support::Rotations::none); });
    list.push_back([=](Scene &s) { return set(s.supports[i].length, 1.); });
    list.push_back([=](Scene &s) { return set(s.supports[i].normal, Vec(0., 0., 1.)); });
  }
  for (std::size_t i = 0; i < scene.steps.size(); ++i) {
    list.push_back([=](Scene &s) { return set(s.steps[i].increments, 1); });
    list.push_back([=](Scene &s) { return set(s.steps[i].ramp, 0.); });
    each(scene.steps[i].loads.size(),
         [=](Scene &s, const std::size_t l) { return leave_out(s.steps[i].loads, l); });
  }
  for (std::size_t i = 0; i < scene.loads.size(); ++i) {
    each(scene.loads[i].history.size(),
         [=](Scene &s, const std::size_t row) { return leave_out(s.loads[i].history, row); });
    list.push_back([=](Scene &s) { return set(s.loads[i].run_time, false); });
    list.push_back([=](Scene &s) { return set(s.loads[i].follow, false); });
  }
  for (std::size_t i = 0; i < scene.sections.size(); ++i) {
    list.push_back([=](Scene &s) { return set(s.sections[i].shear, Section::Shear::none); });
    list.push_back([=](Scene &s) { return set(s.sections[i].contents, 0.); });
    list.push_back([=](Scene &s) { return set(s.sections[i].added_mass, 0.); });
    list.push_back([=](Scene &s) { return set(s.sections[i].insulation, 0.); });
  }
  for (std::size_t i = 0; i < scene.materials.size(); ++i)
    list.push_back([=](Scene &s) {
      const bool had = !s.materials[i].table.empty();
      s.materials[i].table.clear();
      return had;
    });
  each(scene.sections.size(), [](Scene &s, const std::size_t i) {
    for (const Pipe &pipe : s.pipes)
      if (pipe.section >= static_cast<int>(i) || pipe.end_section >= static_cast<int>(i))
        return false;
    return leave_out(s.sections, i);
  });
  each(scene.materials.size(), [](Scene &s, const std::size_t i) {
    for (const Pipe &pipe : s.pipes)
      if (pipe.material >= static_cast<int>(i))
        return false;
    return leave_out(s.materials, i);
  });
  return list;
}

/// Drop what refers to points and pipes that are no longer there.
void tidy(Scene &scene) {
  std::set<std::string> points, pipes;
  for (const Point &point : scene.points)
    points.insert(point.name);
  for (Pipe &pipe : scene.pipes) {
    pipes.insert(pipe.name);
    for (Corner &corner : pipe.route) {
      corner.by_name = corner.by_name && points.count(corner.name) > 0;
      if (!corner.name.empty())
        points.insert(corner.name);
    }
    pipe.route.front().relative = false;
  }
  const auto lost = [&](const std::string &name) {
    return !name.empty() && points.count(name) == 0;
  };
  const auto drop = [](auto &list, const auto &condition) {
    list.erase(std::remove_if(list.begin(), list.end(), condition), list.end());
  };
  drop(scene.supports, [&](Support &s) {
    drop(s.at, lost);
    return s.at.empty() && pipes.count(s.pipe) == 0;
  });
  for (Support &s : scene.supports) { // a post that nothing carries any more is no ground
    const bool is_post = s.ground.rfind("post", 0) == 0 &&
                         std::none_of(scene.springs.begin(), scene.springs.end(),
                                      [&](const Spring &spring) { return spring.at == s.ground; });
    if (lost(s.ground) || is_post)
      s.ground.clear();
  }
  drop(scene.springs, [&](const Spring &s) { return lost(s.at) || lost(s.to); });
  drop(scene.hangers, [&](const Hanger &h) { return lost(h.at); });
  drop(scene.masses, [&](Mass &m) {
    drop(m.at, lost);
    return m.at.empty();
  });
  drop(scene.joints, [&](const Joint &j) { return lost(j.at) || pipes.count(j.pipe) == 0; });
  drop(scene.tees, [&](const Tee &t) { return lost(t.at) || pipes.count(t.branch) == 0; });
  drop(scene.initial, [&](Initial &i) {
    drop(i.at, lost);
    drop(i.pipes, [&](const std::string &pipe) { return pipes.count(pipe) == 0; });
    return (i.at.empty() && i.pipes.empty()) || lost(i.about);
  });
  drop(scene.monitors, lost);
  for (std::size_t l = scene.loads.size(); l-- > 0;) {
    Load &load = scene.loads[l];
    drop(load.pipes, [&](const std::string &pipe) { return pipes.count(pipe) == 0; });
    const bool off = !load.at.empty() && lost(load.at.front().first);
    if (off)
      leave_out_load(scene, l);
  }
}

} // namespace

Scene made_small(Scene scene, Judge &judge, const std::uint64_t seed) {
  // What is left must be wrong by as much, or another fault takes the place of this one.
  double worst = 1.;
  try {
    worst = judge.judge(scene, seed).worst;
  } catch (const std::exception &) { // a program that throws is not made smaller
    return scene;
  }
  const double enough = 0.1 * std::min(1., worst);
  for (bool smaller = true; smaller;) {
    smaller = false;
    for (const Change &change : changes(scene)) {
      Scene candidate = scene;
      if (!change(candidate))
        continue;
      tidy(candidate);
      if (candidate.pipes.empty() || candidate.steps.empty())
        continue;
      try {
        const Verdict verdict = judge.judge(candidate, seed);
        if (verdict.kind != Verdict::Kind::wrong || verdict.worst < enough)
          continue;
      } catch (const std::exception &) { // no scene any more
        continue;
      }
      scene = candidate;
      smaller = true;
      break; // the list of changes is another now
    }
  }
  return scene;
}

} // namespace oracle
