// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/picture/marker.h"
#include "results/text.h"

namespace frictionbeam {

std::string px(const double value) { return fixed_number(value, 1); }

std::string status_marker(const ContactStatus status, const double x, const double y,
                          const double size, const std::string &tooltip) {
  const std::string at = px(x) + " " + px(y);
  const auto path = [&](const std::string &shape, const std::string &fill) {
    return "<path d=\"" + shape + "\" fill=\"" + fill + "\" stroke=\"#fff\" stroke-width=\"0.8\">";
  };
  const auto circle = [&](const std::string &style) {
    return "<path d=\"M" + px(x - size) + " " + px(y) + "a" + px(size) + " " + px(size) +
           " 0 1 0 " + px(2. * size) + " 0a" + px(size) + " " + px(size) + " 0 1 0 " +
           px(-2. * size) + " 0z\" " + style + ">";
  };
  std::string marker;
  switch (status) {
  case ContactStatus::stick:
    marker = circle("fill=\"#0072b2\" stroke=\"#fff\" stroke-width=\"0.8\"");
    break;
  case ContactStatus::slip: {
    const std::string r = px(1.3 * size), minus = px(-1.3 * size);
    marker = path("M" + px(x) + " " + px(y - 1.3 * size) + "l" + r + " " + r + " " + minus + " " +
                      r + " " + minus + " " + minus + "z",
                  "#d55e00");
    break;
  }
  case ContactStatus::open:
    marker = circle("fill=\"#fff\" stroke=\"#333\" stroke-width=\"1.4\"");
    break;
  case ContactStatus::closed:
    marker = path("M" + px(x - size) + " " + px(y - size) + "h" + px(2. * size) + "v" +
                      px(2. * size) + "h" + px(-2. * size) + "z",
                  "#009e73");
    break;
  case ContactStatus::none:
    marker = circle("fill=\"#999\" stroke=\"#fff\" stroke-width=\"0.8\"");
    break;
  }
  return marker + (tooltip.empty() ? "" : "<title>" + escape_xml(tooltip) + "</title>") +
         "</path>\n";
}

std::string status_cell(const ContactStatus status) {
  return "<svg viewBox=\"0 0 13 13\">" + status_marker(status, 6.5, 6.5, 4.6) + "</svg>" +
         status_word(status);
}

std::string restraint_marker(const double x, const double y, const std::string &tooltip) {
  return "<path d=\"M" + px(x) + " " + px(y) +
         "l5.5 10h-11z\" fill=\"#111\" stroke=\"#fff\" "
         "stroke-width=\"0.8\"><title>" +
         escape_xml(tooltip) + "</title></path>\n";
}

} // namespace frictionbeam
