// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/picture/line_picture.h"
#include "results/picture/isometric.h"
#include "results/picture/label_placer.h"
#include "results/picture/marker.h"
#include "results/text.h"

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace frictionbeam {

namespace {

constexpr double width = 1120., header = 34., legend = 92., margin_x = 70., margin_y = 34.;
constexpr unsigned int n_colours = 16;

Vector3 translation(const Station &station) {
  return Vector3({station.displacement[0], station.displacement[1], station.displacement[2]});
}

bool is_finite(const Station &station) {
  return std::isfinite(translation(station).norm()) && std::isfinite(station.position.norm());
}

/// From dark violet to light green, growing in lightness (after viridis).
std::string colour(const unsigned int bin) {
  static const std::array<std::array<double, 3>, 5> map{
      {{{68, 1, 84}}, {{59, 82, 139}}, {{33, 145, 140}}, {{94, 201, 98}}, {{170, 220, 50}}}};
  const double at = 4. * bin / (n_colours - 1.);
  const auto below = std::min(static_cast<unsigned int>(at), 3u);
  std::string text = "rgb(";
  for (unsigned int c = 0; c < 3; ++c)
    text += (c > 0 ? "," : "") +
            fixed_number(map[below][c] + (at - below) * (map[below + 1][c] - map[below][c]), 0);
  return text + ")";
}

/// One picture while it is made.
class Picture {
public:
  Picture(const Scene &scene, const Results &results, const Frame &frame, const double scale);
  std::string draw();

private:
  struct Vertex {
    Pixel built, displaced;
    double displacement;
  };

  void fit();
  void collect_line();
  std::string draw_pipes();
  std::string draw_supports();
  std::string draw_restraints();
  std::string draw_labels();
  std::string draw_legend() const;
  /// The axes, each of a round length.
  std::string draw_axes() const;
  /// What the pipes' colours mean.
  std::string draw_colours(const double baseline) const;
  /// What the markers of supports and restraints mean, and how many there are.
  std::string draw_markers(const double baseline) const;
  void add_label(const std::string &text, const Pixel &at, const std::string &style);

  const Scene &scene;
  const Results &results;
  const Frame &frame;
  double scale, largest = 0., bottom = 0.;
  IsometricView view;
  std::vector<std::vector<Vertex>> pipes; ///< unbroken runs
  std::vector<unsigned int> pipe_of_run;
  std::vector<std::pair<std::string, Pixel>> support_labels;
  std::map<ContactStatus, unsigned int> n_status;
  bool markers_shared = false;
  std::optional<LabelPlacer> placer;
  std::string labels;
};

Picture::Picture(const Scene &scene, const Results &results, const Frame &frame, const double scale)
    : scene(scene), results(results), frame(frame), scale(scale) {}

void Picture::fit() {
  for (const Station &station : frame.line)
    if (is_finite(station)) {
      view.include(station.position);
      view.include(station.position + scale * translation(station));
      largest = std::max(largest, translation(station).norm());
    }
  for (const auto &info : results.supports)
    view.include(info.position);
  for (const auto &info : results.restraints)
    view.include(info.position);
  view.fit(margin_x, header + margin_y, width - 2. * margin_x, 500.);
  bottom = header + 2. * margin_y + std::max(view.height(), 60.);
}

void Picture::collect_line() {
  const auto far = [](const Pixel &a, const Pixel &b) {
    return std::hypot(a.x - b.x, a.y - b.y) > 1.2;
  };
  const Station *previous = nullptr;
  Vertex skipped;
  bool pending = false;
  const auto flush = [&]() {
    if (pending)
      pipes.back().push_back(skipped);
    pending = false;
  };
  for (const Station &station : frame.line) {
    if (!is_finite(station)) {
      flush();
      previous = nullptr;
      continue;
    }
    const Vertex vertex{view.place(station.position),
                        view.place(station.position + scale * translation(station)),
                        translation(station).norm()};
    if (previous == nullptr || previous->pipe != station.pipe) {
      flush();
      pipes.push_back({vertex});
      pipe_of_run.push_back(station.pipe);
    } else if (far(vertex.built, pipes.back().back().built) ||
               far(vertex.displaced, pipes.back().back().displaced)) {
      pending = false;
      pipes.back().push_back(vertex);
    } else {
      skipped = vertex;
      pending = true;
    }
    previous = &station;
  }
  flush();
}

std::string Picture::draw_pipes() {
  std::string built, displaced;
  const auto point = [](const Pixel &p) { return px(p.x) + "," + px(p.y) + " "; };
  for (const auto &run : pipes) {
    built += "<polyline points=\"";
    for (const Vertex &vertex : run)
      built += point(vertex.built);
    built += "\"/>\n";
    unsigned int last = n_colours;
    for (std::size_t i = 1; i < run.size(); ++i) {
      const double mean = (run[i - 1].displacement + run[i].displacement) / 2.;
      const unsigned int bin =
          largest > 0.
              ? std::min(static_cast<unsigned int>(n_colours * mean / largest), n_colours - 1)
              : 0;
      if (bin != last)
        displaced += (last == n_colours ? "" : "\"/>\n") + std::string("<polyline stroke=\"") +
                     colour(bin) + "\" points=\"" + point(run[i - 1].displaced);
      displaced += point(run[i].displaced);
      last = bin;
      placer->avoid_stroke(run[i - 1].built.x, run[i - 1].built.y, run[i].built.x, run[i].built.y);
      placer->avoid_stroke(run[i - 1].displaced.x, run[i - 1].displaced.y, run[i].displaced.x,
                           run[i].displaced.y);
    }
    displaced += last == n_colours ? "" : "\"/>\n";
  }
  return "<g fill=\"none\" stroke=\"#b4b4b4\" stroke-width=\"2\" stroke-linejoin=\"round\">\n" +
         built +
         "</g>\n<g fill=\"none\" stroke-width=\"3.2\" stroke-linejoin=\"round\" "
         "stroke-linecap=\"round\">\n" +
         displaced + "</g>\n";
}

std::string Picture::draw_supports() {
  AssertDimension(frame.supports.size(), results.supports.size());
  const bool many = frame.supports.size() > 100;
  const double size = many ? 3.5 : 5.;
  std::string text;
  std::set<std::array<int, 2>> taken; // squares of a grid
  // What matters most goes first, to be kept, and is drawn last, on top.
  for (const ContactStatus status : {ContactStatus::open, ContactStatus::slip, ContactStatus::stick,
                                     ContactStatus::closed, ContactStatus::none})
    for (unsigned int i = 0; i < frame.supports.size(); ++i) {
      const auto &info = results.supports[i];
      const auto &state = frame.supports[i];
      if (state.status != status)
        continue;
      ++n_status[status];
      const Pixel at = view.place(info.position);
      const std::array<int, 2> square{{static_cast<int>(at.x / 7.), static_cast<int>(at.y / 7.)}};
      if (many && !taken.insert(square).second) {
        markers_shared = true;
        continue;
      }
      const DisplayUnit unit = display_unit(scene.units, "N", std::abs(state.fn));
      text = status_marker(status, at.x, at.y, size,
                           info.name + ": " + status_word(status) + ", fn " +
                               rounded_number(unit.factor * state.fn) + " " + unit.name) +
             text;
      placer->avoid(at.x, at.y, size + 1.);
      support_labels.emplace_back(info.name, at);
    }
  return text;
}

std::string Picture::draw_restraints() {
  std::string text;
  std::set<std::array<int, 2>> drawn;
  for (const auto &info : results.restraints) {
    const Pixel at = view.place(info.position);
    if (!drawn
             .insert(std::array<int, 2>{{static_cast<int>(at.x / 5.), static_cast<int>(at.y / 5.)}})
             .second)
      continue;
    text += restraint_marker(at.x, at.y, info.name + (info.kind.empty() ? "" : ": " + info.kind));
    placer->avoid(at.x, at.y + 6., 7.);
  }
  return text;
}

void Picture::add_label(const std::string &text, const Pixel &at, const std::string &style) {
  if (const auto found = placer->place(text, 11., at.x, at.y))
    labels += text_at(found->x, found->y, text,
                      "font-size=\"11\" text-anchor=\"" + found->anchor + "\" " + style);
}

std::string Picture::draw_labels() {
  for (const auto &name : scene.monitors) {
    std::optional<Point3> position;
    for (const auto &point : scene.points)
      if (point.name == name)
        position = point.position;
    for (const auto &pipe : scene.pipes)
      for (const auto &point : pipe.route)
        if (point.name == name && point.bend_radius == 0.)
          position = point.position;
    if (!position)
      continue;
    const Pixel at = view.place(*position);
    labels += "<circle cx=\"" + px(at.x) + "\" cy=\"" + px(at.y) +
              "\" r=\"2.5\" fill=\"#fff\" stroke=\"#111\"/>\n";
    add_label(name, at, "fill=\"#111\" font-weight=\"bold\"");
  }
  if (results.restraints.size() <= 40)
    for (const auto &info : results.restraints)
      add_label(info.name, view.place(info.position), "fill=\"#111\"");
  if (scene.pipes.size() <= 20) {
    std::set<unsigned int> named;
    for (unsigned int run = 0; run < pipes.size(); ++run)
      if (named.insert(pipe_of_run[run]).second)
        add_label(scene.pipes[pipe_of_run[run]].name, pipes[run][pipes[run].size() / 2].built,
                  "fill=\"#555\" font-style=\"italic\"");
  }
  if (results.supports.size() <= 60)
    for (const auto &[name, at] : support_labels)
      add_label(name, at, "fill=\"#777\"");
  return "<g>\n" + labels + "</g>\n";
}

std::string Picture::draw_legend() const {
  return stroke({0., bottom}, {width, bottom}, "stroke=\"#ddd\"") + draw_axes() +
         draw_colours(bottom + 28.) + draw_markers(bottom + 64.);
}

std::string Picture::draw_axes() const {
  std::string text;
  const double foreshortening = std::sqrt(2. / 3.);
  const double metre = scene.units.factor("m");
  const double room = 34. / (foreshortening * view.scale() * metre);
  const double power = std::pow(10., std::floor(std::log10(room)));
  const double length = power * std::floor(room / power);
  const double axis = length * metre * foreshortening * view.scale();
  const Pixel origin{46., bottom + 52.};
  const std::array<std::string, 3> names{{"x", "y", "z"}};
  for (unsigned int d = 0; d < 3; ++d) {
    Point3 unit;
    unit[d] = 1. / foreshortening;
    const Pixel to = isometric(unit);
    text += stroke(origin, {origin.x + axis * to.x, origin.y + axis * to.y},
                   "stroke=\"#111\" stroke-width=\"1.5\"");
    text += text_at(origin.x + (axis + 9.) * to.x, origin.y + (axis + 9.) * to.y + 4., names[d],
                    "font-size=\"12\" text-anchor=\"middle\" fill=\"#111\"");
  }
  text += text_at(origin.x, bottom + legend - 6.,
                  "axes " + rounded_number(length) + " " + scene.units.name("m"),
                  "font-size=\"11\" text-anchor=\"middle\" fill=\"#555\"");
  return text;
}

std::string Picture::draw_colours(const double baseline) const {
  double x = 130.;
  std::string text =
      stroke({x, baseline - 4.}, {x + 26., baseline - 4.}, "stroke=\"#b4b4b4\" stroke-width=\"2\"");
  text += text_at(x + 34., baseline, "as built");
  const DisplayUnit unit = display_unit(scene.units, "m", largest);
  x = 230.;
  for (unsigned int bin = 0; bin < n_colours; ++bin)
    text += "<rect x=\"" + px(x + 10. * bin) + "\" y=\"" + px(baseline - 10.) +
            "\" width=\"10.2\" height=\"11\" fill=\"" + colour(bin) + "\"/>\n";
  text += text_at(x + 10. * n_colours + 8., baseline,
                  largest == 0.
                      ? "no displacement"
                      : "displacement, 0 to " + rounded_number(unit.factor * largest) + " " +
                            unit.name +
                            (scale > 0. ? ", drawn " + rounded_number(scale) + " times as large"
                                        : ", which are no shape and not drawn"));
  return text;
}

std::string Picture::draw_markers(const double baseline) const {
  std::string text;
  double x = 136.;
  const auto entry = [&](const std::string &marker, const std::string &label) {
    text += marker + text_at(x + 12., baseline, label);
    x += 40. + 7. * label.size();
  };
  for (const auto &[status, n] : n_status)
    entry(status_marker(status, x, baseline - 4., 5.),
          (status == ContactStatus::none ? "no status" : status_word(status)) + " (" +
              std::to_string(n) + ")");
  if (!results.restraints.empty())
    entry(restraint_marker(x, baseline - 10., ""),
          "restraint or spring (" + std::to_string(results.restraints.size()) + ")");
  if (markers_shared)
    text += text_at(x, baseline, "close supports share a marker: open before slip before stick",
                    "fill=\"#555\"");
  return text;
}

std::string Picture::draw() {
  fit();
  placer.emplace(width, header, bottom);
  collect_line();
  std::string text = draw_pipes();
  text += draw_supports() + draw_restraints();
  text += draw_labels() + draw_legend();
  return svg_picture(width, bottom + legend,
                     frame.name + (is_finished(results, frame) ? "" : " (not finished)"), text);
}

} // namespace

std::string draw_line(const Scene &scene, const Results &results, const Frame &frame,
                      const double scale) {
  return Picture(scene, results, frame, scale).draw();
}

} // namespace frictionbeam
