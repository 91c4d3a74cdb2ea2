// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/turnable/model_data.h"
#include "results/frame/frame_choice.h"
#include "results/held_directions.h"
#include "results/text.h"
#include "results/turnable/model_envelopes.h"
#include "results/turnable/model_fields.h"
#include "results/turnable/model_stations.h"
#include "results/turnable/packed_numbers.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace frictionbeam {

namespace {

using Json = nlohmann::ordered_json; // numbers that are not finite become null

constexpr std::size_t n_supports_at_most = 1500, n_points_at_most = 400, n_modes_at_most = 12;

/// Names of the columns of a state's rows, as in the csv files.
Json columns_of_states() {
  return {
      {"supports", {"status", "fn", "ft1", "ft2", "gap", "slip1", "slip2", "work_friction", "mt"}},
      {"reactions", {"fx", "fy", "fz", "mx", "my", "mz"}},
      {"points", {"ux", "uy", "uz", "rx", "ry", "rz"}}};
}

template <typename Numbers>
Json rounded_list(const Numbers &numbers, const unsigned int digits) {
  Json list = Json::array();
  for (const double number : numbers)
    list.push_back(rounded(number, digits));
  return list;
}

Json list(const Point3 &point) {
  return rounded_list(std::array<double, 3>{{point[0], point[1], point[2]}}, 6);
}

Json list(const Vector3 &vector) { return list(Point3(vector)); }

/// A state that the model can take.
struct Shown {
  const Frame *frame;
  std::string kind, name;          ///< step, case, instant or mode
  std::vector<std::size_t> places; ///< in the frame's line, of the stations that are kept
};

/// Places in Results::supports of those that are shown: all, or those with the largest forces.
std::vector<std::size_t> supports_to_show(const Results &results) {
  std::vector<std::size_t> supports_kept;
  std::vector<double> weight(results.supports.size(), 0.);
  for (const Frame &frame : results.frames)
    for (std::size_t i = 0; i < frame.supports.size() && frame.end_of_step; ++i)
      weight[i] = std::max(weight[i], frame.supports[i].fn);
  for (std::size_t i = 0; i < weight.size(); ++i)
    supports_kept.push_back(i);
  if (supports_kept.size() > n_supports_at_most) {
    std::stable_sort(
        supports_kept.begin(), supports_kept.end(),
        [&](const std::size_t a, const std::size_t b) { return weight[a] > weight[b]; });
    supports_kept.resize(n_supports_at_most);
    std::sort(supports_kept.begin(), supports_kept.end());
  }
  return supports_kept;
}

std::set<unsigned int> named_vertices(const Results &results) {
  std::set<unsigned int> named;
  for (const PointInfo &point : results.points)
    if (named.size() < n_points_at_most)
      named.insert(point.vertex);
  return named;
}

std::set<std::array<double, 3>> positions_of(const Results &results,
                                             const std::vector<std::size_t> &supports) {
  std::set<std::array<double, 3>> positions;
  for (const std::size_t i : supports) {
    const Point3 &p = results.supports[i].position;
    positions.insert({{p[0], p[1], p[2]}});
  }
  return positions;
}

class ModelData {
public:
  ModelData(const Scene &scene, const Results &results, const std::vector<const Frame *> &frames);
  Json json(const double scale) const;

private:
  void choose_points();
  void choose_frames(const std::vector<const Frame *> &frames);
  Json pipes() const;
  Json supports() const;
  Json restraints() const;
  Json points() const;
  Json state(const Shown &shown) const;

  const Scene &scene;
  const Results &results;
  std::vector<Shown> shown;
  std::vector<std::size_t> supports_kept; ///< places in Results::supports
  ModelStations stations;
  std::vector<std::size_t> points_kept, point_stations;
};

ModelData::ModelData(const Scene &scene, const Results &results,
                     const std::vector<const Frame *> &frames)
    : scene(scene), results(results), supports_kept(supports_to_show(results)),
      stations(*frames.front(), named_vertices(results), positions_of(results, supports_kept)) {
  choose_points();
  choose_frames(frames);
}

void ModelData::choose_points() {
  std::map<unsigned int, std::size_t> station_of; // vertices
  for (std::size_t i = 0; i < stations.size(); ++i)
    if (stations[i].is_node())
      station_of.emplace(stations[i].vertex, i);
  for (std::size_t k = 0; k < results.points.size() && points_kept.size() < n_points_at_most; ++k)
    if (const auto found = station_of.find(results.points[k].vertex); found != station_of.end()) {
      points_kept.push_back(k);
      point_stations.push_back(found->second);
    }
}

void ModelData::choose_frames(const std::vector<const Frame *> &frames) {
  const auto add = [&](const Frame &frame, const std::string &kind, const std::string &name) {
    if (const auto places = stations.places_in(frame); !places.empty())
      shown.push_back({&frame, kind, name, places});
  };
  for (const Frame *frame : frames)
    add(*frame, frame->step < scene.steps.size() ? "step" : "case", frame->name);
  for (std::size_t step = 0; step < scene.steps.size(); ++step) {
    if (!scene.steps[step].transient)
      continue;
    std::vector<const Frame *> instants;
    for (const std::vector<Frame> *const list : {&results.instants, &results.frames})
      for (const Frame &frame : *list) // the end of the step comes last
        if (frame.step == step)
          instants.push_back(&frame);
    if (instants.size() > 1)
      for (const Frame *frame : instants)
        add(*frame, "instant", frame->name);
  }
  for (std::size_t i = 0; i < std::min(n_modes_at_most, results.modes.size()); ++i)
    add(results.modes[i].shape, "mode",
        "mode " + std::to_string(i + 1) + ", " + rounded_number(results.modes[i].frequency, 5) +
            " Hz");
}

Json ModelData::pipes() const {
  Json list = Json::array();
  for (std::size_t i = 0; i < stations.size(); ++i) {
    const unsigned int pipe = stations[i].pipe;
    if (i == 0 || stations[i - 1].pipe != pipe) {
      const auto radius = [&](const Section &section) {
        return rounded(section.outer_radius > 0. ? section.outer_radius
                                                 : std::sqrt(section.area / dealii::numbers::PI),
                       4);
      };
      const Pipe &one = scene.pipes[pipe];
      list.push_back(
          Json{{"name", one.name},
               {"from", i},
               {"radius", radius(scene.sections[one.section])},
               {"end_radius", radius(scene.sections[one.end_section.value_or(one.section)])},
               {"section", scene.sections[one.section].name},
               {"rigid", one.rigid}});
    }
    list.back()["to"] = i;
  }
  return list;
}

Json ModelData::supports() const {
  Json all = Json::array();
  for (const std::size_t i : supports_kept) {
    const SupportInfo &info = results.supports[i];
    all.push_back(Json{{"name", info.name},
                       {"kind", info.kind},
                       {"station", stations.nearest(info.position)},
                       {"at", list(info.position)},
                       {"n", list(info.normal)},
                       {"t1", list(info.t1)},
                       {"t2", list(info.t2)}});
  }
  return all;
}

Json ModelData::restraints() const {
  Json all = Json::array();
  for (std::size_t i = 0; i < results.restraints.size() && i < n_supports_at_most; ++i) {
    const RestraintInfo &info = results.restraints[i];
    const std::size_t at = stations.nearest(info.position);
    Json ways = Json::array();
    for (const Vector3 &way : held_directions(scene, info, stations[at]))
      ways.push_back(list(way));
    all.push_back(Json{{"name", info.name},
                       {"kind", info.kind},
                       {"station", at},
                       {"at", list(info.position)},
                       {"ways", ways}});
  }
  return all;
}

Json ModelData::points() const {
  Json all = Json::array();
  for (std::size_t k = 0; k < points_kept.size(); ++k)
    all.push_back(
        Json{{"name", results.points[points_kept[k]].name}, {"station", point_stations[k]}});
  return all;
}

Json ModelData::state(const Shown &one) const {
  const Frame &frame = *one.frame;
  Json json{{"name", one.name}, {"kind", one.kind}, {"time", rounded(frame.time, 6)}};
  if (frame.is_amplitude)
    json["amplitude"] = true;
  Json &u = json["u"] = Json::array();
  for (unsigned int d = 0; d < 3; ++d) {
    std::vector<double> values;
    for (const std::size_t i : one.places)
      values.push_back(frame.line[i].displacement[d]);
    u.push_back(packed(values));
  }
  if (one.kind == "mode")
    return json;
  Json &fields = json["fields"] = Json::array();
  for (const ModelField &field : model_fields()) {
    const std::vector<double> values = field.values(scene, results, frame, one.kind == "instant");
    fields.push_back(values.empty() ? Json() : packed(stations.thinned(values, one.places)));
  }
  const unsigned int digits = one.kind == "instant" ? 5 : 7;
  Frame converted;
  const Frame &in_user_units = in_units(results.units, frame, converted);
  Json &states = json["supports"] = Json::array();
  for (const std::size_t i : supports_kept) {
    const SupportState &state = in_user_units.supports[i];
    Json row{status_word(state.status)};
    for (unsigned int k = 0; k < n_shown_support_numbers; ++k)
      row.push_back(rounded(state.*support_numbers[k], digits));
    states.push_back(row);
  }
  Json &reactions = json["reactions"] = Json::array();
  for (std::size_t i = 0; i < frame.reactions.size() && i < n_supports_at_most; ++i)
    reactions.push_back(rounded_list(in_user_units.reactions[i], digits));
  Json &motions = json["points"] = Json::array();
  if (one.kind != "instant")
    for (const std::size_t k : point_stations)
      motions.push_back(rounded_list(in_user_units.line[one.places[k]].displacement, digits));
  return json;
}

Json ModelData::json(const double scale) const {
  std::array<std::vector<double>, 3> position;
  std::vector<double> s;
  for (std::size_t i = 0; i < stations.size(); ++i) {
    for (unsigned int d = 0; d < 3; ++d)
      position[d].push_back(stations[i].position[d]);
    s.push_back(stations[i].s);
  }
  Json json{
      {"scale", scale},
      {"left_out", stations.leaves_some_out() || supports_kept.size() < results.supports.size()},
      {"pipes", pipes()},
      {"position", {packed(position[0]), packed(position[1]), packed(position[2])}},
      {"s", packed(s)},
      {"supports", supports()},
      {"restraints", restraints()},
      {"points", points()},
      {"columns", columns_of_states()},
      {"envelopes", model_envelopes(scene, results, stations, supports_kept, n_supports_at_most)}};
  json["units"] = Json::object();
  for (const char *unit : {"m", "N", "N m", "J", "rad"})
    json["units"][unit] = results.units.name(unit);
  Largest motion;
  std::vector<Largest> largest(model_fields().size());
  for (const Shown &one : shown)
    if (one.kind != "mode") {
      motion(largest_motion(*one.frame));
      for (std::size_t f = 0; f < largest.size(); ++f)
        for (const double value :
             model_fields()[f].values(scene, results, *one.frame, one.kind == "instant"))
          largest[f](value);
    }
  const auto add_unit = [&](Json field, const std::string &si_unit, const double size) {
    const DisplayUnit unit =
        si_unit == "%" ? DisplayUnit{100., "%"} : display_unit(results.units, si_unit, size);
    field["unit"] = unit.name;
    field["factor"] = rounded(unit.factor, 7);
    return field;
  };
  json["length"] = {{"unit", results.units.name("m")}, {"factor", 1. / results.units.factor("m")}};
  json["displacement"] =
      add_unit({{"key", "displacement"}, {"name", "displacement"}}, "m", motion.value());
  Json &fields = json["fields"] = Json::array();
  for (std::size_t f = 0; f < largest.size(); ++f)
    fields.push_back(add_unit({{"key", model_fields()[f].key},
                               {"name", model_fields()[f].name},
                               {"signed", model_fields()[f].is_signed}},
                              model_fields()[f].si_unit, largest[f].value()));
  Json &states = json["steps"] = Json::array();
  for (const Shown &one : shown)
    states.push_back(state(one));
  return json;
}

} // namespace

std::string model_data(const Scene &scene, const Results &results,
                       const std::vector<const Frame *> &frames, const double scale) {
  return ModelData(scene, results, frames)
      .json(scale)
      .dump(-1, ' ', false, Json::error_handler_t::replace);
}

} // namespace frictionbeam
