// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/file/output_file.h"
#include "results/page/html.h"
#include "results/page/plot.h"
#include "results/picture/isometric.h"
#include "results/solid/solid_files.h"
#include "results/text.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

using namespace dealii;

namespace {

/// From dark to light, for readers with any kind of colour vision (viridis at five places).
std::string stress_colour(const double part) {
  constexpr unsigned int n = 5;
  constexpr std::array<std::array<double, 3>, n> at = {
      {{{68., 1., 84.}}, {{59., 82., 139.}}, {{33., 145., 140.}}, {{94., 201., 98.}},
       {{253., 231., 37.}}}};
  const double place = std::clamp(part, 0., 1.) * (n - 1);
  const unsigned int i = std::min(static_cast<unsigned int>(place), n - 2);
  std::string text = "rgb(";
  for (unsigned int c = 0; c < 3; ++c)
    text += std::to_string(
                std::lround(at[i][c] + (place - i) * (at[i + 1][c] - at[i][c]))) +
            (c < 2 ? "," : ")");
  return text;
}

/// The outside of the wall, and its inside where that is seen at an end, as facets.
class WallPicture {
public:
  WallPicture(const Scene &scene, const PipeWall &wall, const WallFrame &frame)
      : scene(scene), wall(wall), frame(frame) {}
  std::string draw() const;

private:
  Point3 corner(const unsigned int ring, const unsigned int point, const unsigned int side) const {
    const double angle = 2. * numbers::PI * point / n_points;
    const WallRing &at = wall.rings[ring];
    return at.centre + (side == 0 ? wall.inner : wall.outer) *
                           (std::cos(angle) * at.a + std::sin(angle) * at.b);
  }

  const Scene &scene;
  const PipeWall &wall;
  const WallFrame &frame;
  const unsigned int n_points = 2 * wall.around;
};

std::string WallPicture::draw() const {
  constexpr double width = 760., margin = 20., above = 44., key_height = 60.;
  const Vector3 to_viewer = Vector3({1., -1., 1.}) / std::sqrt(3.);
  IsometricView view;
  double largest = 0.;
  for (unsigned int r = 0; r < wall.rings.size(); ++r) {
    for (unsigned int i = 0; i < n_points; ++i)
      view.include(corner(r, i, 1));
    largest = std::max({largest, frame.rings[r].largest_mises(0), frame.rings[r].largest_mises(1)});
  }
  view.fit(margin, above, width - 2. * margin, 560.);
  std::vector<std::pair<double, std::string>> facets; // by their nearness
  for (unsigned int r = 0; r + 1 < wall.rings.size(); ++r)
    for (unsigned int i = 0; i < n_points; ++i)
      for (unsigned int side = 0; side < 2; ++side) {
        const unsigned int next = (i + 1) % n_points;
        const std::array<Point3, 4> corners = {{corner(r, i, side), corner(r, next, side),
                                                corner(r + 1, next, side), corner(r + 1, i, side)}};
        const Vector3 out =
            (side == 1 ? 1. : -1.) * cross_product_3d(corners[2] - corners[0], corners[3] - corners[1]);
        double middle = 0., stress = 0.;
        std::string points;
        for (const Point3 &point : corners) {
          const Pixel pixel = view.place(point);
          points += rounded_number(pixel.x, 5) + ',' + rounded_number(pixel.y, 5) + ' ';
          middle += 0.25 * (Vector3(point) * to_viewer);
        }
        for (const unsigned int ring : {r, r + 1})
          for (const unsigned int point : {i, next})
            stress += 0.25 * frame.rings[ring].stress[side][point].mises();
        if (out * to_viewer <= 0.)
          continue;
        const std::string colour = stress_colour(largest > 0. ? stress / largest : 0.);
        facets.emplace_back(middle, "<polygon points=\"" + points + "\" fill=\"" + colour +
                                        "\" stroke=\"" + colour + "\" stroke-width=\"0.4\"/>\n");
      }
  std::stable_sort(facets.begin(), facets.end(),
                   [](const auto &a, const auto &b) { return a.first < b.first; });
  std::string content;
  for (const auto &facet : facets)
    content += facet.second;
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

/// A number of each ring along the chain, at the ends of the steps.
template <typename Number>
Plot ring_plot(const Scene &scene, const PipeWall &wall, const std::vector<WallFrame> &frames,
               const std::string &label, const Number &number) {
  constexpr std::size_t most = 6; // curves
  Plot plot;
  plot.x_label = "s along the pipes [" + scene.units.name("m") + "]";
  plot.y_label = label;
  for (std::size_t f = frames.size() > most ? frames.size() - most : 0; f < frames.size(); ++f) {
    Plot::Series series;
    series.label = scene.steps[frames[f].step].name;
    for (unsigned int r = 0; r < wall.rings.size(); ++r) {
      series.x.push_back(wall.rings[r].s / scene.units.factor("m"));
      series.y.push_back(number(frames[f].rings[r]));
    }
    plot.series.push_back(series);
  }
  return plot;
}

} // namespace

std::string wall_report(const Scene &scene, const PipeWall &wall,
                        const std::vector<WallFrame> &frames, const std::string &folder) {
  const double Pa = scene.units.factor("Pa"), m = scene.units.factor("m");
  const std::string stress = " [" + scene.units.name("Pa") + "]";
  std::vector<Plot> plots;
  plots.push_back(ring_plot(
      scene, wall, frames, "ovality (D_max - D_min)/D [-]",
      [&](const RingState &ring) { return ring.ovality(2. * wall.outer); }));
  plots.push_back(ring_plot(scene, wall, frames, "widening [" + scene.units.name("m") + "]",
                            [&](const RingState &ring) { return ring.widening / m; }));
  for (const unsigned int side : {0u, 1u})
    plots.push_back(
        ring_plot(scene, wall, frames,
                  std::string("von Mises, ") + (side == 0 ? "inside" : "outside") + stress,
                  [&](const RingState &ring) { return ring.largest_mises(side) / Pa; }));
  const std::string picture = WallPicture(scene, wall, frames.back()).draw();
  write_file(folder + "/solid.svg", picture);
  return picture + html_of_plots(plots, "wall") +
         html_note("Largest of each ring. solid.csv and wall.csv have the numbers, solid.pvd the "
                   "field for ParaView.");
}

} // namespace frictionbeam
