// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/picture/coloured_line.h"

#include "results/picture/isometric.h"
#include "results/picture/marker.h"
#include "results/text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

namespace frictionbeam {

namespace {

constexpr double wide = 960., margin = 40., above = 34., below = 44., most_height = 520.;

/// From blue over green and yellow to red.
std::string heat(const double part) {
  static constexpr int stops[5][3] = {
      {49, 91, 168}, {66, 160, 176}, {122, 186, 92}, {240, 190, 60}, {200, 40, 40}};
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

std::string ring(const Pixel &at, const std::string &tooltip) {
  return "<circle cx=\"" + px(at.x) + "\" cy=\"" + px(at.y) +
         "\" r=\"7\" fill=\"none\" stroke=\"#000\" stroke-width=\"2\">" +
         (tooltip.empty() ? "" : "<title>" + escape_xml(tooltip) + "</title>") + "</circle>\n";
}

/// The names of points of routes, each once; those that come too close to the one before are left
/// out.
template <typename Place>
std::string draw_names(const Scene &scene, const Results &results, const Frame &frame,
                       const Place &place) {
  std::string names;
  Pixel last{-1e9, -1e9};
  std::set<std::string> unnamed; // corners of routes
  for (const Pipe &pipe : scene.pipes)
    for (const RoutePoint &point : pipe.route)
      unnamed.insert(point.name);
  for (const Station &station : frame.line)
    for (const PointInfo &point : results.points)
      if (point.vertex == station.vertex && unnamed.erase(point.name) > 0) {
        const Pixel at = place(station);
        if (std::hypot(at.x - last.x, at.y - last.y) > 24.)
          names += text_at(at.x + 6., at.y - 6., point.name, "font-size=\"11\" fill=\"#444\"");
        last = at;
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
  for (std::size_t i = 1; i < frame.line.size(); ++i) {
    const Station &a = frame.line[i - 1], &b = frame.line[i];
    if (a.pipe != b.pipe || a.position.distance(b.position) == 0.)
      continue;
    if (what.scale != 0.)
      built += stroke(view.place(a.position), view.place(b.position),
                      "stroke=\"#c8c8c8\" stroke-width=\"2\"");
    const double value = std::max(what.values[i - 1], what.values[i]) / what.largest;
    coloured += stroke(view.place(moved(a)), view.place(moved(b)),
                       "stroke=\"" + (std::isnan(value) ? nothing_known : heat(value)) +
                           "\" stroke-width=\"4\" stroke-linecap=\"round\"");
  }
  std::string rings;
  for (const ColouredLine::Ring &one : what.rings)
    rings += ring(view.place(moved(frame.line[one.station])), one.tooltip);
  const std::string names = draw_names(
      scene, results, frame, [&](const Station &station) { return view.place(moved(station)); });
  std::string key = draw_key(bottom, what.legend);
  if (!what.rings.empty())
    key += ring({wide - margin - 250., bottom + 11.}, "") +
           text_at(wide - margin - 235., bottom + 16., what.ring_meaning);
  return svg_picture(wide, bottom + below, what.title, built + coloured + rings + names + key);
}

} // namespace frictionbeam
