// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/turnable/model_section.h"
#include "results/page/embedded.h"
#include "results/page/html.h"
#include "results/turnable/model_data.h"

#include <deal.II/base/utilities.h>

namespace frictionbeam {

namespace {

/// Something packed, for a script of the page to find by its id.
std::string packed_element(const std::string &id, const std::string &bytes) {
  return "<script type=\"application/gzip\" id=\"" + id + "\">" +
         dealii::Utilities::encode_base64({bytes.begin(), bytes.end()}) + "</script>\n";
}

const char *const controls =
    R"(<div class="model" role="group" aria-label="model that can be turned">
<div class="model-bar">
<label>state <select id="model-step"></select></label>
<button id="model-play" type="button" aria-pressed="false" title="play">&#9654; play</button>
<label id="model-time-label" hidden>instant <input id="model-time" type="range" min="0" value="0"></label>
<label>colour by <select id="model-field"></select></label>
<label>displacements &times; <output id="model-scale-shown"></output>
<input id="model-scale" type="range" min="0" max="300" value="100"></label>
<label>names <select id="model-names"><option value="">none</option><option>points</option><option>supports</option><option>pipes</option><option>all</option></select></label>
<label><input id="model-arrows" type="checkbox"> forces</label>
<label><input id="model-built" type="checkbox" checked> as built</label>
<span class="model-views" role="group" aria-label="views"><button type="button" data-view="1 -1 0.82">3D</button><button type="button" data-view="0 -0.0001 1">top</button><button type="button" data-view="0 -1 0">front</button><button type="button" data-view="1 0 0">side</button></span>
</div>
<div class="model-view"><canvas id="model-canvas" tabindex="0" role="img" aria-label="The line in three dimensions; every number in it is in the tables of this page"></canvas>
<canvas id="model-overlay" aria-hidden="true"></canvas>
<div id="model-legend" class="model-legend"></div><div id="model-status" class="model-status"></div>
<p id="model-message" class="model-message" role="status">The model is being unpacked.</p></div>
<div id="model-table" class="model-table" aria-live="polite"><p class="note">Drag to turn, with the right button or two fingers to move, wheel to come closer. Click on a support, a point or a pipe for its numbers over all steps.</p></div>
</div>
)";

} // namespace

std::string model_section(const Scene &scene, const Results &results,
                          const std::vector<const Frame *> &frames, const double scale) {
  if (embedded::three_js.empty())
    return html_note("There is no model to turn here: FrictionBeam was built where three.js "
                     "(Debian's libjs-three) was missing.");
  return controls +
         packed_element("model-data",
                        dealii::Utilities::compress(model_data(scene, results, frames, scale))) +
         packed_element("model-three", embedded::three_js) + "<script id=\"model-script\">\n" +
         embedded::turnable_js + "</script>\n" +
         "<p class=\"screen-only note\">Drawn by three.js (MIT licence, threejs.org/license), "
         "which "
         "is within this page.</p>\n";
}

} // namespace frictionbeam
