// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/report/report_tree.h"

#include "results/page/html.h"
#include "results/picture/marker.h"
#include "results/text.h"
#include "scene/steps/step_tree.h"

#include <algorithm>

namespace frictionbeam {

namespace {

constexpr unsigned int n_steps_at_most = 100;
constexpr double row_height = 22., lane_width = 24., margin = 12., letter_width = 7.8; // [px]

/// In which lane each step stands: steps that follow each other in one, those that go back to the
/// same step, or are gone back from, beside it.
std::vector<unsigned int> lanes_of(const Scene &scene, const unsigned int n) {
  std::vector<unsigned int> lanes;
  for (unsigned int s = 0; s < n; ++s) {
    const auto before = step_before(scene, s);
    lanes.push_back(before ? lanes[*before] + (is_returned_to(scene, *before) ? 1 : 0) : 0);
  }
  return lanes;
}

double centre(const unsigned int place, const double size) { return margin + place * size; }

} // namespace

std::string step_tree(const Scene &scene) {
  const unsigned int n = std::min<std::size_t>(scene.steps.size(), n_steps_at_most);
  bool any = false;
  for (unsigned int s = 0; s < n; ++s)
    any = any || is_branch(scene, s);
  if (!any)
    return "";
  const std::vector<unsigned int> lanes = lanes_of(scene, n);
  std::string lines, names;
  double width = 0.;
  for (unsigned int s = 0; s < n; ++s) {
    const double x = centre(lanes[s], lane_width), y = centre(s, row_height);
    if (const auto before = step_before(scene, s))
      lines += "<path d=\"M" + px(centre(lanes[*before], lane_width)) + " " +
               px(centre(*before, row_height)) + "V" + px(y) + "H" + px(x) + "\"/>\n";
    const std::string &name = scene.steps[s].name;
    names += "<circle cx=\"" + px(x) + "\" cy=\"" + px(y) + "\" r=\"5\"/><text x=\"" +
             px(x + margin) + "\" y=\"" + px(y + 4.5) + "\">" + escape_xml(name) + "</text>\n";
    width = std::max(width, x + 2. * margin + letter_width * name.size());
  }
  const std::string w = px(width), h = px(2. * margin + (n - 1) * row_height);
  return "<svg role=\"img\" aria-label=\"From which step each step starts\" width=\"" + w +
         "\" height=\"" + h + "\" viewBox=\"0 0 " + w + " " + h +
         "\" style=\"max-width:100%;height:auto\">\n<g fill=\"none\" stroke=\"#57606a\" "
         "stroke-width=\"1.6\">\n" +
         lines + "</g>\n<g fill=\"#1b4f8f\" font-size=\"13.5\">\n" + names + "</g>\n</svg>\n" +
         html_note("Each step starts from the state at the end of the one that its line comes "
                   "from." +
                   std::string(n < scene.steps.size()
                                   ? " The first " + std::to_string(n) + " steps are shown."
                                   : ""));
}

} // namespace frictionbeam
