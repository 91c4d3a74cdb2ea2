// SPDX-License-Identifier: LGPL-2.1-or-later
// Of made-up sections that yield and creep: neighbours above the strain of first yield are one
// hinge, each pipe has its worst section with the step that did most to it, dissipation is summed
// over lengths, tables and page take hard names, and a line that cannot yield has none of it.
#include "../check.h"
#include "sample.h"

#include "results/file/csv_writer.h"
#include "results/file/output_file.h"
#include "results/inelastic/section_charts.h"
#include "results/inelastic/yielding.h"
#include "results/report/report.h"

#include <filesystem>
#include <fstream>
#include <sstream>

using namespace frictionbeam;

namespace {

const std::string folder = "yield-test";

std::string read(const std::string &name) {
  std::ostringstream text;
  text << std::ifstream(folder + "/" + name).rdbuf();
  return text.str();
}

std::size_t count(const std::string &text, const std::string &part) {
  std::size_t n = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size())
    ++n;
  return n;
}

/// Eleven sections, 12 m from one to the next.
Sample yielding_sample() {
  Sample sample = make_sample(8, 50);
  sample.scene.sections[0].law = "fibre_pipe";
  const std::vector<std::vector<double>> plastic{
      {5e-4, 0., 0., 0., 0., 0., 0., 0., 0., 0., 0.},
      {3e-3, 2e-3, 0., 0., 0., 1.1e-3, 0., 0., 0., 4e-4, 4e-4}};
  SectionHistory history;
  history.name = hard_name;
  for (Frame &frame : sample.results.frames) {
    if (!frame.end_of_step)
      continue;
    for (unsigned int i = 0; i < 11; ++i) {
      SectionState section;
      section.s = 12. * i;
      section.length = i == 0 || i == 10 ? 6. : 12.;
      section.plastic_strain = plastic[frame.step][i];
      section.creep_strain = 1e-4 * i * (1. + frame.step);
      section.utilization = 0.7 + 0.1 * frame.step;
      section.yield_strain = 1e-3;
      section.dissipated = 10. * frame.step;
      section.strain[5] = 1e-3 * frame.step;
      section.force[5] = 2e3 * frame.step;
      frame.sections.push_back(section);
    }
    history.time.push_back(frame.time);
    history.states.push_back(frame.sections[1]);
  }
  sample.results.section_histories = {history};
  return sample;
}

void check_numbers(const Results &results) {
  const std::vector<const Frame *> frames = frames_of_sections(results);
  CHECK(frames.size() == 2);
  const std::vector<Hinge> hinges = hinges_of(frames);
  CHECK(hinges.size() == 2);
  CHECK(hinges[0].from == 0. && hinges[0].to == 12. && hinges[0].worst.s == 0.);
  CHECK(hinges[0].flows && hinges[0].since == frames[1]->name);
  CHECK(hinges[1].from == 60. && hinges[1].to == 60.);
  CHECK(hinges_of({frames[0]}).empty());

  const std::vector<PipeYield> pipes = yield_of_pipes(results);
  CHECK(pipes.size() == 1 && pipes[0].n_hinges == 2);
  CHECK(pipes[0].plastic.value == 3e-3 && pipes[0].plastic.s == 0.);
  CHECK(pipes[0].plastic.step == frames[1]->name);
  CHECK(pipes[0].creep.value == 2e-3 && pipes[0].creep.s == 120.);
  CHECK(pipes[0].creep.step == frames[0]->name); // by as much in both: the first
  CHECK(pipes[0].utilization.value == 0.7 + 0.1);
  CHECK_NEAR(pipes[0].dissipated, 10. * 120., 1e-9);
}

void check_files(const Sample &sample) {
  CsvWriter csv(sample.scene, sample.results, folder);
  for (const Frame &frame : sample.results.frames)
    csv.append(frame);
  const std::string table = read("sections.csv");
  CHECK(count(table, "\n") == 1 + 2 * 11);
  CHECK(table.find("step,pipe,s,eps,gamma_y,gamma_z,chi,kappa_y,kappa_z,N,Vy,Vz,Mx,My,Mz,"
                   "utilization,plastic_strain,creep_strain,dissipation\n"
                   "weight,\"pipe, 1\",0,0,0,0,0,0,0,0,0,0,0,0,0,0.7,5e-04,0,0\n") == 0);
  write_section_histories(sample.scene, sample.results, folder);
  CHECK(count(read("section_history.csv"), "\"rest, \"\"north\"\"") == 2);

  write_report(sample.scene, sample.results, folder);
  const std::string page = read("report.html");
  CHECK(count(page, "<section id=\"yield\">") == 1 && count(page, "<h3>Hinges</h3>") == 1);
  CHECK(count(page, "hinge, plastic strain 0.3 %") == 2); // in the pictures of both strains
  CHECK(count(page, "<b>&'1") == 0);
  CHECK(count(read("sections.svg"), "<title>hinge") == 2);
}

void check_elastic() {
  const Sample sample = make_sample(8, 50);
  std::filesystem::remove(folder + "/sections.svg");
  std::filesystem::remove(folder + "/sections.csv");
  CsvWriter csv(sample.scene, sample.results, folder);
  write_report(sample.scene, sample.results, folder);
  CHECK(count(read("report.html"), "<section id=\"yield\">") == 0);
  CHECK(!std::filesystem::exists(folder + "/sections.svg"));
  CHECK(!std::filesystem::exists(folder + "/sections.csv"));
}

/// Moment over curvature keeps its sign, and does not depend on the axes it is given in.
void check_charts(const Sample &sample) {
  Results results = sample.results;
  SectionHistory &history = results.section_histories[0];
  history.states[0].force[4] = -1e3;
  history.states[0].force[5] = -1e3;
  history.states[0].strain[4] = -1e-3;
  history.states[0].strain[5] = -1e-3;
  history.states[1].force[4] = history.states[1].force[5] = 2e3;
  history.states[1].strain[4] = history.states[1].strain[5] = 3e-3;
  const std::vector<Plot> plots = section_charts(results);
  CHECK(plots.size() == 4); // M over kappa, both strains and the moment over time
  const Plot::Series &series = plots[0].series[0];
  CHECK_NEAR(series.x[0], -std::sqrt(2.) * 1e-3, 1e-12);
  CHECK_NEAR(series.x[1], std::sqrt(2.) * 3e-3, 1e-12);
  CHECK_NEAR(series.y[0], -std::sqrt(2.), 1e-9); // kN m
  CHECK_NEAR(series.y[1], std::sqrt(8.), 1e-9);
}

} // namespace

int main() {
  prepare_output_folder(folder);
  const Sample sample = yielding_sample();
  check_numbers(sample.results);
  check_files(sample);
  check_charts(sample);
  check_elastic();
  return check::report();
}
