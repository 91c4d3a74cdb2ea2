// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/file/output_file.h"
#include "results/page/html.h"
#include "results/page/plot.h"
#include "results/picture/isometric.h"
#include "results/solid/solid_files.h"
#include "results/text.h"
#include "scene/file/parameter_file.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

using namespace dealii;

namespace {

/// From dark to light, for readers with any kind of colour vision (viridis at five places).
std::string stress_colour(const double part) {
  constexpr unsigned int n = 5;
  constexpr std::array<std::array<double, 3>, n> at = {{{{68., 1., 84.}},
                                                        {{59., 82., 139.}},
                                                        {{33., 145., 140.}},
                                                        {{94., 201., 98.}},
                                                        {{253., 231., 37.}}}};
  const double place = std::clamp(part, 0., 1.) * (n - 1);
  const unsigned int i = std::min(static_cast<unsigned int>(place), n - 2);
  std::string text = "rgb(";
  for (unsigned int c = 0; c < 3; ++c)
    text += std::to_string(std::lround(at[i][c] + (place - i) * (at[i + 1][c] - at[i][c]))) +
            (c < 2 ? "," : ")");
  return text;
}

/// The wall's surface as facets: its outside and its ends, or, cut open, what is seen of the half
/// that is turned away from the viewer.
class WallPicture {
public:
  /// @param cut_open leave out the half of the wall that looks at the viewer
  WallPicture(const Scene &scene, const PipeWall &wall, const WallFrame &frame, const bool cut_open)
      : scene(scene), wall(wall), frame(frame), cut_open(cut_open) {
    for (unsigned int r = 0; r < wall.rings.size(); ++r) {
      for (unsigned int i = 0; i < n_points; ++i)
        view.include(place({r, i, 1}));
      largest =
          std::max({largest, frame.rings[r].largest_mises(0), frame.rings[r].largest_mises(1)});
    }
    view.fit(margin, above, width - 2. * margin, 560.);
  }
  std::string draw();

private:
  struct Corner {
    unsigned int ring, point, side; ///< side: inside, outside
  };
  struct Facet {
    double nearness; ///< to the viewer
    std::string polygon;
  };

  Vector3 radius(const unsigned int ring, const unsigned int point) const {
    const double angle = 2. * numbers::PI * point / n_points;
    const WallRing &at = wall.rings[ring];
    return std::cos(angle) * at.a + std::sin(angle) * at.b;
  }
  Point3 place(const Corner &corner) const {
    return wall.rings[corner.ring].centre +
           (corner.side == 0 ? wall.inner : wall.outer) * radius(corner.ring, corner.point);
  }
  /// Whether the strip of cells from a point to the next is there.
  bool is_there(const unsigned int ring, const unsigned int point) const {
    return !cut_open || radius(ring, point) * to_viewer <= 0.;
  }
  /// @param always or only if its corners turn to the left as the viewer sees them
  void add(const std::array<Corner, 4> &corners, const bool always);

  static constexpr double width = 760., margin = 20., above = 44., key_height = 60.;
  const Vector3 to_viewer = Vector3({1., -1., 1.}) / std::sqrt(3.);
  const Scene &scene;
  const PipeWall &wall;
  const WallFrame &frame;
  const bool cut_open;
  const unsigned int n_points = 2 * wall.around;
  IsometricView view;
  double largest = 0.; ///< stress [Pa]
  std::vector<Facet> facets;
};

void WallPicture::add(const std::array<Corner, 4> &corners, const bool always) {
  const Vector3 out = cross_product_3d(place(corners[2]) - place(corners[0]),
                                       place(corners[3]) - place(corners[1]));
  if (!always && out * to_viewer <= 0.)
    return;
  double nearness = 0., stress = 0.;
  std::string points;
  for (const Corner &corner : corners) {
    const Point3 at = place(corner);
    const Pixel pixel = view.place(at);
    points += rounded_number(pixel.x, 5) + ',' + rounded_number(pixel.y, 5) + ' ';
    nearness += 0.25 * (Vector3(at) * to_viewer);
    stress += 0.25 * frame.rings[corner.ring].stress[corner.side][corner.point].mises();
  }
  const std::string colour = stress_colour(largest > 0. ? stress / largest : 0.);
  facets.push_back({nearness, "<polygon points=\"" + points + "\" fill=\"" + colour +
                                  "\" stroke=\"" + colour + "\" stroke-width=\"0.4\"/>\n"});
}

std::string WallPicture::draw() {
  const unsigned int n = wall.n_layers();
  for (unsigned int i = 0; i < n_points; ++i) {
    const unsigned int next = (i + 1) % n_points;
    for (unsigned int r = 0; r < n; ++r) {
      if (is_there(r, i)) {
        add({{{r, i, 1}, {r, next, 1}, {r + 1, next, 1}, {r + 1, i, 1}}}, false);
        add({{{r, i, 0}, {r + 1, i, 0}, {r + 1, next, 0}, {r, next, 0}}}, false);
      }
      if (is_there(r, i) != is_there(r, next)) // the cut
        add({{{r, next, 0}, {r, next, 1}, {r + 1, next, 1}, {r + 1, next, 0}}}, true);
    }
    for (unsigned int r = 1; r < n; ++r)
      if (is_there(r - 1, i) != is_there(r, i)) // where the cut goes from one strip to the next
        add({{{r, i, 0}, {r, i, 1}, {r, next, 1}, {r, next, 0}}}, true);
    if (is_there(0, i))
      add({{{0, i, 0}, {0, next, 0}, {0, next, 1}, {0, i, 1}}}, false);
    if (is_there(n, i))
      add({{{n, i, 0}, {n, i, 1}, {n, next, 1}, {n, next, 0}}}, false);
  }
  std::stable_sort(facets.begin(), facets.end(),
                   [](const Facet &a, const Facet &b) { return a.nearness < b.nearness; });
  std::string content;
  for (const Facet &facet : facets)
    content += facet.polygon;
  const double bottom = above + view.height() + 24.;
  const DisplayUnit unit = display_unit(scene.units, "Pa", largest);
  for (unsigned int i = 0; i < 64; ++i)
    content += "<rect x=\"" + rounded_number(margin + 5. * i, 5) + "\" y=\"" +
               rounded_number(bottom, 5) + "\" width=\"5.2\" height=\"12\" fill=\"" +
               stress_colour((i + 0.5) / 64.) + "\"/>\n";
  content += text_at(margin, bottom + 28., "0") +
             text_at(margin + 280., bottom + 28.,
                     rounded_number(unit.factor * largest, 3) + " " + unit.name) +
             text_at(margin + 400., bottom + 10., "von Mises stress of the wall");
  return svg_picture(width, bottom + key_height,
                     "Wall at the end of step " + scene.steps[frame.step].name, content);
}

/// Where a ring lies along its pipe, or along the chain of pipes [m].
double place_of(const PipeWall &wall, const unsigned int ring) {
  return wall.rings[ring].s - wall.pipe_start.front();
}

/// A number of each ring along the pipes, at the ends of the steps. @param unit of the number, SI
template <typename Number>
Plot ring_plot(const Scene &scene, const PipeWall &wall, const std::vector<WallFrame> &frames,
               const std::string &label, const std::string &unit, const Number &number) {
  constexpr std::size_t most = 6; // curves
  Plot plot;
  std::vector<double> places;
  for (unsigned int r = 0; r < wall.rings.size(); ++r)
    places.push_back(place_of(wall, r));
  double largest = 0.;
  for (std::size_t f = frames.size() > most ? frames.size() - most : 0; f < frames.size(); ++f) {
    Plot::Series series;
    series.label = scene.steps[frames[f].step].name;
    for (const RingState &ring : frames[f].rings) {
      series.y.push_back(number(ring));
      largest = std::max(largest, std::abs(series.y.back()));
    }
    plot.series.push_back(series);
  }
  const DisplayUnit across = display_unit(scene.units, unit, largest);
  for (Plot::Series &series : plot.series) {
    for (const double s : places)
      series.x.push_back(s / scene.units.factor("m"));
    for (double &value : series.y)
      value *= across.factor;
  }
  plot.x_label = "s along the pipes [" + scene.units.name("m") + "]";
  plot.y_label = label + " [" + across.name + "]";
  return plot;
}

/// Of a bend in which no point has a name, the ring in its middle.
void name_bends(const PipeWall &wall, RingNames &names) {
  unsigned int bend = 0;
  for (unsigned int k = 0; k < wall.segments.size(); ++k) {
    if (wall.segments[k].path.radius == 0.)
      continue;
    ++bend;
    std::vector<unsigned int> layers;
    for (unsigned int layer = 0; layer < wall.n_layers(); ++layer)
      if (wall.layer_segment[layer] == k)
        layers.push_back(layer);
    if (layers.size() < 2)
      continue;
    const auto named = names.upper_bound(layers.front()); // rings before and after a layer
    if (named == names.end() || named->first > layers.back())
      names[layers[layers.size() / 2]] = {"bend " + std::to_string(bend) + ", middle"};
  }
}

/// How sections have lost their shape and what stress they have, at the end of a step.
std::string shape_table(const Scene &scene, const PipeWall &wall, const WallFrame &frame,
                        RingNames names) {
  name_bends(wall, names);
  const double diameter = 2. * wall.outer;
  std::vector<std::pair<unsigned int, std::string>> rows;
  for (const auto &[ring, points] : names)
    rows.emplace_back(ring, join(points));
  const auto by_ovality = [&](const RingState &a, const RingState &b) {
    return a.ovality(diameter) < b.ovality(diameter);
  };
  rows.emplace_back(std::max_element(frame.rings.begin(), frame.rings.end(), by_ovality) -
                        frame.rings.begin(),
                    "where it is most oval");
  std::vector<std::string> what, ovality;
  std::vector<double> s, mode2, mode3, widening, inside, outside;
  for (const auto &[at, name] : rows) {
    const RingState &ring = frame.rings[at];
    what.push_back(name);
    s.push_back(place_of(wall, at));
    ovality.push_back(rounded_number(100. * ring.ovality(diameter), 3) + " %");
    mode2.push_back(std::hypot(ring.mode2[0], ring.mode2[1]));
    mode3.push_back(std::hypot(ring.mode3[0], ring.mode3[1]));
    widening.push_back(ring.widening);
    inside.push_back(ring.largest_mises(0));
    outside.push_back(ring.largest_mises(1));
  }
  return HtmlTable(scene.units)
      .text("Section", what)
      .numbers("s along the pipes", "m", s)
      .right("Ovality", ovality)
      .numbers("Mode 2", "m", mode2)
      .numbers("Mode 3", "m", mode3)
      .numbers("Widening", "m", widening)
      .numbers("von Mises, inside", "Pa", inside)
      .numbers("outside", "Pa", outside)
      .str();
}

std::string shape_tables(const Scene &scene, const PipeWall &wall,
                         const std::vector<WallFrame> &frames, const RingNames &names,
                         const std::string &id) {
  constexpr std::size_t most = 8; // steps
  std::vector<std::pair<std::string, std::string>> panels;
  for (std::size_t f = frames.size() > most ? frames.size() - most : 0; f < frames.size(); ++f)
    panels.emplace_back(scene.steps[frames[f].step].name,
                        shape_table(scene, wall, frames[f], names));
  return html_tabs(id + "shape", panels) +
         html_note("Ovality is (D_max - D_min)/D; modes 2 and 3 are the amplitudes of the radius, "
                   "widening its mean. A beam's sections keep their shape.");
}

} // namespace

std::string wall_report(const Scene &scene, const PipeWall &wall,
                        const std::vector<WallFrame> &frames, const RingNames &names,
                        const std::string &id, const std::string &folder) {
  std::vector<Plot> plots;
  plots.push_back(ring_plot(scene, wall, frames, "ovality (D_max - D_min)/D", "-",
                            [&](const RingState &ring) { return ring.ovality(2. * wall.outer); }));
  plots.push_back(ring_plot(scene, wall, frames, "widening", "m",
                            [](const RingState &ring) { return ring.widening; }));
  for (const unsigned int side : {0u, 1u})
    plots.push_back(ring_plot(scene, wall, frames,
                              std::string("von Mises, ") + (side == 0 ? "inside" : "outside"), "Pa",
                              [&](const RingState &ring) { return ring.largest_mises(side); }));
  const std::string closed = WallPicture(scene, wall, frames.back(), false).draw(),
                    open = WallPicture(scene, wall, frames.back(), true).draw();
  write_file(folder + "/solid.svg", closed);
  write_file(folder + "/solid_open.svg", open);
  return html_tabs(id + "view", {{"cut open", open}, {"outside", closed}}) +
         shape_tables(scene, wall, frames, names, id) + html_of_plots(plots, id) +
         html_note("Largest of each ring. solid.csv and wall.csv have the numbers, solid.pvd the "
                   "field for ParaView.");
}

} // namespace frictionbeam
