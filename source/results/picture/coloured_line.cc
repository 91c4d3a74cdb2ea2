// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/picture/coloured_line.h"

#include "results/picture/isometric.h"
#include "results/picture/label_placer.h"
#include "results/picture/marker.h"
#include "results/text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <set>

namespace frictionbeam {

namespace {

constexpr double wide = 960., margin = 40., above = 34., below = 44., most_height = 520.;

/// From dark blue over purple and orange to yellow, growing in lightness (after plasma): told apart
/// with any kind of colour vision.
std::string heat(const double part) {
  static constexpr int stops[5][3] = {
      {13, 8, 135}, {126, 3, 168}, {204, 71, 120}, {248, 149, 64}, {238, 205, 40}};
  const double at = 4. * std::clamp(std::isfinite(part) ? part : 0., 0., 1.);
  const int i = std::min(3, static_cast<int>(at));
  char text[8];
  int mixed[3];
  for (int c = 0; c < 3; ++c)
    mixed[c] =
        static_cast<int>(std::lround(stops[i][c] + (at - i) * (stops[i + 1][c] - stops[i][c])));
  std::snprintf(text, sizeof(text), "#%02x%02x%02x", mixed[0] & 255, mixed[1] & 255,
                mixed[2] & 255);
  return text;
}

const std::string nothing_known = "#c8c8c8";

/// One of some colours, so that neighbours of the same one are drawn in one go; not below the
/// value.
double in_steps(const double part) { return std::ceil(40. * part) / 40.; }

/**
 * The pipes as polylines, each of one colour. Stations closer than a pixel are drawn as one; the
 * largest of their values counts. @param look attributes of a value over the largest, nan: unknown
 */
template <typename Place, typename Look>
std::string draw_stretches(const Frame &frame, const ColouredLine &what, const Place &place,
                           const Look &look) {
  std::string text, open; // open: attributes of the polyline that goes on
  const auto point = [](const Pixel &at) { return px(at.x) + "," + px(at.y) + " "; };
  const auto end = [&]() {
    text += open.empty() ? "" : "\"/>\n";
    open.clear();
  };
  std::size_t from = 0;
  double value = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < frame.line.size(); ++i) {
    if (i == 0 || frame.line[i - 1].pipe != frame.line[i].pipe) {
      end();
      from = i;
      value = what.values[i] / what.largest;
      continue;
    }
    value = std::fmax(value, what.values[i] / what.largest); // of two, the one that is a number
    const Pixel a = place(frame.line[from]), b = place(frame.line[i]);
    const bool ends_pipe =
        i + 1 == frame.line.size() || frame.line[i + 1].pipe != frame.line[i].pipe;
    if (std::hypot(a.x - b.x, a.y - b.y) < 1. && !ends_pipe)
      continue;
    if (const std::string attributes = look(value); attributes != open) {
      end();
      text += "<polyline " + attributes + " points=\"" + point(a);
      open = attributes;
    }
    text += point(b);
    from = i;
    value = what.values[i] / what.largest;
  }
  end();
  return text;
}

std::string ring(const Pixel &at, const std::string &tooltip) {
  return "<circle cx=\"" + px(at.x) + "\" cy=\"" + px(at.y) +
         "\" r=\"7\" fill=\"none\" stroke=\"#000\" stroke-width=\"2\">" +
         (tooltip.empty() ? "" : "<title>" + escape_xml(tooltip) + "</title>") + "</circle>\n";
}

/// The names of points of routes, each once, where there is room for them.
template <typename Place>
std::string draw_names(const Scene &scene, const Results &results, const Frame &frame,
                       const Place &place, LabelPlacer placer) {
  constexpr double font_size = 11.;
  std::string names;
  Pixel last{-1e9, -1e9};
  for (std::size_t i = 0; i < frame.line.size(); ++i) {
    const Pixel at = place(frame.line[i]);
    const bool begins = i == 0 || frame.line[i - 1].pipe != frame.line[i].pipe;
    if (!begins && std::hypot(at.x - last.x, at.y - last.y) < 3.)
      continue;
    if (!begins)
      placer.avoid_stroke(last.x, last.y, at.x, at.y);
    last = at;
  }
  std::set<std::string> unnamed; // corners of routes
  for (const Pipe &pipe : scene.pipes)
    for (const RoutePoint &point : pipe.route)
      unnamed.insert(point.name);
  for (const Station &station : frame.line)
    for (const PointInfo &point : results.points)
      if (point.vertex == station.vertex && unnamed.erase(point.name) > 0) {
        const Pixel at = place(station);
        if (const auto found = placer.place(point.name, font_size, at.x, at.y))
          names += text_at(found->x, found->y, point.name,
                           "font-size=\"11\" fill=\"#444\" text-anchor=\"" + found->anchor + "\"");
      }
  return names;
}

/// The colours from 0 to the largest value. @param bottom of the line's picture [px]
std::string draw_key(const double bottom, const std::string &legend) {
  std::string key;
  for (unsigned int i = 0; i < 40; ++i)
    key += "<rect x=\"" + px(margin + 5. * i) + "\" y=\"" + px(bottom + 6.) +
           "\" width=\"5.2\" height=\"11\" fill=\"" + heat((i + 0.5) / 40.) + "\"/>\n";
  return key + text_at(margin + 210., bottom + 16., legend);
}

} // namespace

std::string draw_coloured_line(const Scene &scene, const Results &results, const Frame &frame,
                               const ColouredLine &what) {
  AssertDimension(what.values.size(), frame.line.size());
  const auto moved = [&](const Station &station) {
    Point3 p = station.position;
    for (unsigned int d = 0; d < 3; ++d)
      p[d] += what.scale * station.displacement[d];
    return p;
  };
  IsometricView view;
  for (const Station &station : frame.line) {
    view.include(station.position);
    view.include(moved(station));
  }
  view.fit(margin, above + margin, wide - 2. * margin, most_height);
  const double bottom = above + view.height() + 2. * margin;

  std::string built, coloured;
  if (what.scale != 0.)
    built = draw_stretches(
        frame, what, [&](const Station &station) { return view.place(station.position); },
        [](const double) { return std::string("stroke=\"#c8c8c8\" stroke-width=\"2\""); });
  coloured = draw_stretches(
      frame, what, [&](const Station &station) { return view.place(moved(station)); },
      [&](const double value) {
        return "stroke=\"" + (std::isnan(value) ? nothing_known : heat(in_steps(value))) + "\"";
      });
  std::string rings;
  for (const ColouredLine::Ring &one : what.rings)
    rings += ring(view.place(moved(frame.line[one.station])), one.tooltip);
  const std::string names = draw_names(
      scene, results, frame, [&](const Station &station) { return view.place(moved(station)); },
      LabelPlacer(wide, above, bottom));
  std::string key = draw_key(bottom, what.legend);
  if (!what.rings.empty())
    key += ring({wide - margin - 250., bottom + 11.}, "") +
           text_at(wide - margin - 235., bottom + 16., what.ring_meaning);
  return svg_picture(
      wide, bottom + below, what.title,
      "<g fill=\"none\" stroke-width=\"4\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n" +
          built + coloured + "</g>\n" + rings + names + key);
}

} // namespace frictionbeam
