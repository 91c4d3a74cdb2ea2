// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/picture/coloured_line.h"
#include "results/text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

namespace frictionbeam {

namespace {

constexpr double width = 960., margin = 40., header = 34., legend = 44.;
constexpr double most_height = 520.;

struct Pixel {
  double x, y;
};

/// x to the lower right, y to the upper right, z up.
Pixel isometric(const Point3 &p) {
  const double c = std::sqrt(3.) / 2.;
  return {c * (p[0] + p[1]), (p[0] - p[1]) / 2. - p[2]};
}

std::string px(const double value) { return fixed_number(value, 1); }

/// From blue over green and yellow to red.
std::string colour(const double part) {
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

std::string text_at(const double x, const double y, const std::string &text,
                    const std::string &style = "") {
  return "<text x=\"" + px(x) + "\" y=\"" + px(y) + "\" " + style + ">" + escape_xml(text) +
         "</text>\n";
}

std::string segment(const Pixel &a, const Pixel &b, const std::string &style) {
  return "<line x1=\"" + px(a.x) + "\" y1=\"" + px(a.y) + "\" x2=\"" + px(b.x) + "\" y2=\"" +
         px(b.y) + "\" " + style + "/>\n";
}

} // namespace

std::string draw_coloured_line(const Scene &scene, const Frame &frame, const ColouredLine &what) {
  AssertDimension(what.values.size(), frame.line.size());
  const auto moved = [&](const Station &station) {
    Point3 p = station.position;
    for (unsigned int d = 0; d < 3; ++d)
      p[d] += what.scale * station.displacement[d];
    return p;
  };
  Pixel low{1e300, 1e300}, high{-1e300, -1e300};
  for (const Station &station : frame.line)
    for (const Point3 &p : {station.position, moved(station)}) {
      const Pixel at = isometric(p);
      low = {std::min(low.x, at.x), std::min(low.y, at.y)};
      high = {std::max(high.x, at.x), std::max(high.y, at.y)};
    }
  const double wide = std::max(high.x - low.x, 1e-9), tall = std::max(high.y - low.y, 1e-9);
  const double factor = std::min((width - 2. * margin) / wide, most_height / tall);
  const double bottom = header + factor * tall + 2. * margin;
  const auto place = [&](const Point3 &p) {
    const Pixel raw = isometric(p);
    return Pixel{(width - factor * wide) / 2. + (raw.x - low.x) * factor,
                 header + margin + (raw.y - low.y) * factor};
  };

  std::string built, coloured, names;
  Pixel last{-1e9, -1e9}; // stations closer than a pixel are left out
  for (std::size_t i = 1; i < frame.line.size(); ++i) {
    const Station &a = frame.line[i - 1], &b = frame.line[i];
    if (a.pipe != b.pipe || a.position.distance(b.position) == 0.)
      continue;
    if (what.scale != 0.)
      built +=
          segment(place(a.position), place(b.position), "stroke=\"#c8c8c8\" stroke-width=\"2\"");
    const double value = std::max(what.values[i - 1], what.values[i]) / what.largest;
    coloured +=
        segment(place(moved(a)), place(moved(b)),
                "stroke=\"" + colour(value) + "\" stroke-width=\"4\" stroke-linecap=\"round\"");
  }
  std::set<std::string> named;
  for (const Station &station : frame.line)
    for (const Pipe &pipe : scene.pipes)
      for (const RoutePoint &point : pipe.route)
        if (!point.name.empty() && station.node &&
            point.position.distance(station.position) < 1e-9 && named.insert(point.name).second) {
          const Pixel at = place(moved(station));
          if (std::hypot(at.x - last.x, at.y - last.y) > 24.)
            names += text_at(at.x + 6., at.y - 6., point.name, "font-size=\"11\" fill=\"#444\"");
          last = at;
        }
  std::string key;
  for (unsigned int i = 0; i < 40; ++i)
    key += "<rect x=\"" + px(margin + 5. * i) + "\" y=\"" + px(bottom + 6.) +
           "\" width=\"5.2\" height=\"11\" fill=\"" + colour((i + 0.5) / 40.) + "\"/>\n";
  key += text_at(margin + 210., bottom + 16., what.legend);
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + px(width) + " " +
         px(bottom + legend) +
         "\" font-family=\"sans-serif\" font-size=\"12\" fill=\"#222\">\n<rect width=\"" +
         px(width) + "\" height=\"" + px(bottom + legend) + "\" fill=\"#fff\"/>\n" +
         text_at(14., 22., what.title, "font-size=\"15\" font-weight=\"bold\"") + built + coloured +
         names + key + "</svg>\n";
}

} // namespace frictionbeam
