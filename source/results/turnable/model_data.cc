// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/turnable/model_data.h"
#include "results/frame/frame_choice.h"
#include "results/text.h"
#include "results/turnable/model_fields.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

namespace frictionbeam {

namespace {

using Json = nlohmann::ordered_json; // numbers that are not finite become null

constexpr double levels = 20000.; ///< of a number at a station
constexpr std::size_t n_stations_at_most = 4000, n_supports_at_most = 1500, n_points_at_most = 400,
                      n_modes_at_most = 12, n_instants_at_most = 80,
                      n_numbers_of_instants = 60000; ///< stations times instants

Json rounded(const double value, const unsigned int digits) {
  return std::isfinite(value) ? Json(std::strtod(rounded_number(value, digits).c_str(), nullptr))
                              : Json();
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

/// As differences in whole numbers, null where there is no number.
Json packed(const std::vector<double> &values) {
  Largest largest;
  for (const double value : values)
    largest(value);
  const double step = std::strtod(rounded_number(largest.value() / levels, 7).c_str(), nullptr);
  Json differences = Json::array();
  long before = 0;
  for (const double value : values) {
    if (!std::isfinite(value)) {
      differences.push_back(nullptr);
      continue;
    }
    const long level = step > 0. ? std::lround(value / step) : 0;
    differences.push_back(level - before);
    before = level;
  }
  return {{"f", step}, {"d", differences}};
}

/// A state that the model can take.
struct Shown {
  const Frame *frame;
  std::string kind, name; ///< step, case, instant or mode
};

class ModelData {
public:
  ModelData(const Scene &scene, const Results &results, const std::vector<const Frame *> &frames);
  Json json(const double scale) const;

private:
  void choose_stations();
  void choose_supports();
  void choose_frames(const std::vector<const Frame *> &frames);
  Json pipes() const;
  Json supports() const;
  Json restraints() const;
  Json points() const;
  Json state(const Shown &shown) const;
  /// Of all stations; of those that are kept, the largest nearby.
  std::vector<double> thinned(const std::vector<double> &values) const;
  std::size_t nearest(const Point3 &position) const;

  const Scene &scene;
  const Results &results;
  const Frame &first;
  std::vector<Shown> shown;
  std::vector<std::size_t> stations, supports_kept; ///< places in Frame::line, Results::supports
  std::vector<std::size_t> points_kept, point_stations;
};

ModelData::ModelData(const Scene &scene, const Results &results,
                     const std::vector<const Frame *> &frames)
    : scene(scene), results(results), first(*frames.front()) {
  choose_supports();
  choose_stations();
  choose_frames(frames);
}

void ModelData::choose_supports() {
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
}

void ModelData::choose_stations() {
  std::set<unsigned int> named; // vertices
  for (const PointInfo &point : results.points)
    if (named.size() < n_points_at_most)
      named.insert(point.vertex);
  std::set<std::array<double, 3>> held;
  for (const std::size_t i : supports_kept)
    held.insert({{results.supports[i].position[0], results.supports[i].position[1],
                  results.supports[i].position[2]}});
  double length = 0.;
  for (std::size_t i = 1; i < first.line.size(); ++i)
    if (first.line[i].pipe == first.line[i - 1].pipe)
      length += first.line[i].position.distance(first.line[i - 1].position);
  const double spacing =
      first.line.size() > n_stations_at_most ? length / (n_stations_at_most / 2.) : 0.;
  constexpr double turn = 0.97; // cosine of 14 degrees
  for (std::size_t i = 0; i < first.line.size(); ++i) {
    const Station &station = first.line[i];
    const bool begins = i == 0 || first.line[i - 1].pipe != station.pipe,
               ends = i + 1 == first.line.size() || first.line[i + 1].pipe != station.pipe;
    const auto is_kept = [&]() {
      if (begins || ends || spacing == 0. || (station.is_node() && named.count(station.vertex) > 0))
        return true;
      const Point3 &p = station.position;
      const Station &last = first.line[stations.back()];
      const double far = p.distance(last.position);
      return far > spacing || held.count({{p[0], p[1], p[2]}}) > 0 ||
             (far > 0. && station.y * last.y + station.z * last.z < 2. * turn);
    };
    if (is_kept())
      stations.push_back(i);
  }
  for (std::size_t k = 0; k < results.points.size(); ++k)
    for (std::size_t i = 0; i < stations.size(); ++i)
      if (points_kept.size() < n_points_at_most &&
          first.line[stations[i]].vertex == results.points[k].vertex) {
        points_kept.push_back(k);
        point_stations.push_back(i);
        break;
      }
}

void ModelData::choose_frames(const std::vector<const Frame *> &frames) {
  const auto add = [&](const Frame &frame, const std::string &kind, const std::string &name) {
    if (frame.line.size() == first.line.size())
      shown.push_back({&frame, kind, name});
  };
  for (const Frame *frame : frames)
    add(*frame, frame->step < scene.steps.size() ? "step" : "case", frame->name);
  const std::size_t size = stations.size() + 10 * supports_kept.size();
  for (std::size_t step = 0; step < scene.steps.size(); ++step) {
    if (!scene.steps[step].transient)
      continue;
    std::vector<const Frame *> instants;
    for (const Frame &frame : results.frames)
      if (frame.step == step)
        instants.push_back(&frame);
    const std::size_t n = std::min(n_instants_at_most, n_numbers_of_instants / (size + 1));
    if (instants.size() > 1 && n > 1)
      for (const Frame *frame : few_of(instants, n))
        add(*frame, "instant", frame->name);
  }
  for (std::size_t i = 0; i < std::min(n_modes_at_most, results.modes.size()); ++i)
    add(results.modes[i].shape, "mode",
        "mode " + std::to_string(i + 1) + ", " + rounded_number(results.modes[i].frequency, 5) +
            " Hz");
}

std::vector<double> ModelData::thinned(const std::vector<double> &values) const {
  std::vector<double> result;
  for (std::size_t k = 0; k < stations.size(); ++k) {
    const std::size_t begin = stations[k],
                      end = k + 1 < stations.size() ? stations[k + 1] : begin + 1;
    double value = values[begin];
    for (std::size_t i = begin + 1; i < end; ++i)
      if (!(std::abs(values[i]) <= std::abs(value)) && std::isfinite(values[i]))
        value = values[i];
    result.push_back(value);
  }
  return result;
}

std::size_t ModelData::nearest(const Point3 &position) const {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < stations.size(); ++i)
    if (const double distance = first.line[stations[i]].position.distance_square(position);
        distance < least) {
      least = distance;
      best = i;
    }
  return best;
}

Json ModelData::pipes() const {
  Json list = Json::array();
  for (std::size_t i = 0; i < stations.size(); ++i) {
    const unsigned int pipe = first.line[stations[i]].pipe;
    if (i == 0 || first.line[stations[i - 1]].pipe != pipe) {
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
                       {"station", nearest(info.position)},
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
    const std::size_t at = nearest(info.position);
    Json ways = Json::array();
    for (const Vector3 &way : held_directions(scene, info, first.line[stations[at]]))
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
    for (const std::size_t i : stations)
      values.push_back(frame.line[i].displacement[d]);
    u.push_back(packed(values));
  }
  if (one.kind == "mode")
    return json;
  Json &fields = json["fields"] = Json::array();
  for (const ModelField &field : model_fields()) {
    const std::vector<double> values = field.values(scene, results, frame, one.kind == "instant");
    fields.push_back(values.empty() ? Json() : packed(thinned(values)));
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
      motions.push_back(rounded_list(in_user_units.line[stations[k]].displacement, digits));
  return json;
}

Json ModelData::json(const double scale) const {
  std::array<std::vector<double>, 3> position;
  std::vector<double> s;
  for (const std::size_t i : stations) {
    for (unsigned int d = 0; d < 3; ++d)
      position[d].push_back(first.line[i].position[d]);
    s.push_back(first.line[i].s);
  }
  Json json{{"scale", scale},
            {"left_out",
             stations.size() < first.line.size() || supports_kept.size() < results.supports.size()},
            {"pipes", pipes()},
            {"position", {packed(position[0]), packed(position[1]), packed(position[2])}},
            {"s", packed(s)},
            {"supports", supports()},
            {"restraints", restraints()},
            {"points", points()}};
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
  json["length"] = add_unit({{"name", "place"}}, "m", 1.);
  json["displacement"] = add_unit({{"name", "displacement"}}, "m", motion.value());
  Json &fields = json["fields"] = Json::array();
  for (std::size_t f = 0; f < largest.size(); ++f)
    fields.push_back(
        add_unit({{"name", model_fields()[f].name}, {"signed", model_fields()[f].is_signed}},
                 model_fields()[f].si_unit, largest[f].value()));
  Json &states = json["steps"] = Json::array();
  for (const Shown &one : shown)
    states.push_back(state(one));
  return json;
}

} // namespace

std::string model_data(const Scene &scene, const Results &results,
                       const std::vector<const Frame *> &frames, const double scale) {
  return ModelData(scene, results, frames).json(scale).dump();
}

} // namespace frictionbeam
