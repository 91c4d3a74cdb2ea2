// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/spectrum/modal_csv.h"

#include "base/unit_constants.h"
#include "results/file/csv_writer.h"
#include "results/page/html.h"
#include "results/report/limits.h"
#include "results/text.h"
#include "scene/spectra/curve_file.h"

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace frictionbeam {

namespace {

constexpr const char *const axis_words[] = {"x", "y", "z"};

template <typename Numbers>
std::string row_of_numbers(const Numbers &numbers) {
  std::string row;
  for (const double number : numbers)
    row += ',' + exact_number(number);
  return row;
}

/// Base force of a mode: what it takes to hold its effective mass, Gamma^2 S [N].
double force_of(const ModalExcitation &one) {
  return one.participation * one.participation * one.acceleration;
}

} // namespace

ModalCsv::ModalCsv(const Scene &scene, const Results &results, const std::string &folder)
    : scene(scene), results(results), line(folder + "/modal_line.csv"),
      supports(folder + "/modal_supports.csv"), reactions(folder + "/modal_reactions.csv") {
  line.stream() << "mode,frequency,direction,pipe,s,ux,uy,uz,rx,ry,rz,N,Vy,Vz,Mx,My,Mz\n";
  supports.stream() << "mode,frequency,direction,support,fn,ft1,ft2,mt\n";
  reactions.stream() << "mode,frequency,direction,restraint,fx,fy,fz,mx,my,mz\n";
}

void ModalCsv::append(const unsigned int mode, const unsigned int direction, const Frame &in_si) {
  Frame converted;
  const Frame &frame = in_units(scene.units, in_si, converted);
  const std::string begin =
      (mode == 0 ? "missing mass,"
                 : std::to_string(mode) + ',' + exact_number(results.modes[mode - 1].frequency)) +
      ',' + axis_words[direction] + ',';
  for (const Station &station : frame.line)
    line.stream() << begin << csv_field(scene.pipes[station.pipe].name) << ','
                  << exact_number(station.s) << row_of_numbers(station.displacement)
                  << row_of_numbers(station.force) << '\n';
  for (std::size_t i = 0; i < frame.supports.size(); ++i) {
    const SupportState &state = frame.supports[i];
    supports.stream() << begin << csv_field(results.supports[i].name)
                      << row_of_numbers(
                             std::array<double, 4>{{state.fn, state.ft1, state.ft2, state.mt}})
                      << '\n';
  }
  for (std::size_t i = 0; i < frame.reactions.size(); ++i)
    reactions.stream() << begin << csv_field(results.restraints[i].name)
                       << row_of_numbers(frame.reactions[i]) << '\n';
  for (OutputFile *const file : {&line, &supports, &reactions})
    file->flush();
}

void write_excitations(const Results &results, const std::string &folder) {
  if (results.excitations.empty())
    return;
  std::string text = "spectrum,direction,mode,frequency,period,participation,acceleration,"
                     "displacement,rigid_share\n";
  for (const ModalExcitation &one : results.excitations) {
    const double f = results.modes[one.mode - 1].frequency, w = 2. * dealii::numbers::PI * f;
    text += csv_field(one.spectrum) + ',' + axis_words[one.direction] + ',' +
            std::to_string(one.mode) +
            row_of_numbers(std::array<double, 6>{
                {f, 1. / f, one.participation, one.acceleration / results.units.factor("m/s2"),
                 one.acceleration / (w * w) / results.units.factor("m"), one.rigid}}) +
            '\n';
  }
  write_file(folder + "/spectrum_modes.csv", text);
}

std::string excitation_table(const Results &results) {
  const auto &all = results.excitations;
  if (all.empty())
    return "";
  std::vector<std::size_t> rows(all.size());
  std::iota(rows.begin(), rows.end(), std::size_t(0));
  std::stable_sort(rows.begin(), rows.end(), [&](const std::size_t a, const std::size_t b) {
    return force_of(all[a]) > force_of(all[b]);
  });
  rows.resize(std::min(rows.size(), n_rows_at_most));
  std::vector<std::string> spectrum, direction, mode, frequency, rigid;
  std::vector<std::string> in_g;
  std::vector<double> force;
  const bool any_rigid = std::any_of(all.begin(), all.end(),
                                     [](const ModalExcitation &one) { return one.rigid > 0.; });
  for (const std::size_t row : rows) {
    const ModalExcitation &one = all[row];
    spectrum.push_back(one.spectrum);
    direction.push_back(axis_words[one.direction]);
    mode.push_back(std::to_string(one.mode));
    frequency.push_back(rounded_number(results.modes[one.mode - 1].frequency, 5));
    in_g.push_back(rounded_number(one.acceleration / standard_gravity, 4));
    force.push_back(force_of(one));
    rigid.push_back(fixed_number(one.rigid, 3));
  }
  HtmlTable table(results.units);
  table.text("spectrum", spectrum)
      .text("direction", direction)
      .right("mode", mode)
      .right("frequency [Hz]", frequency)
      .right("acceleration [g]", in_g)
      .numbers("force", "N", force);
  if (any_rigid)
    table.right("rigid share", rigid);
  return "<h3>Response to the spectra</h3>\n" + table.str() +
         html_note("What each mode takes of a spectrum, the largest force first: the spectral "
                   "acceleration at its frequency, and \u0393\u00b2S, the inertia of its effective "
                   "mass. spectrum_modes.csv has all" +
                   std::string(rows.size() < all.size() ? ", also those left out here." : "."));
}

} // namespace frictionbeam
