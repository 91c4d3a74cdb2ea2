// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/file/csv_writer.h"
#include "results/quantity/fibre_quantities.h"
#include "results/text.h"

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <filesystem>
#include <set>

namespace frictionbeam {

namespace {

template <typename Numbers>
void add_numbers(std::string &row, const Numbers &numbers) {
  for (const double number : numbers)
    append_exact_number(number, row += ',');
}

std::string instant(const Frame &frame) {
  return csv_field(frame.name) + ',' + std::to_string(frame.increment) + ',' +
         exact_number(frame.time);
}

constexpr const char *section_columns =
    ",eps,gamma_y,gamma_z,chi,kappa_y,kappa_z,N,Vy,Vz,Mx,My,Mz,utilization,plastic_strain,"
    "creep_strain,dissipation\n";

/// What stands below section_columns.
void add_section(std::string &row, const SectionState &section) {
  add_numbers(row, section.strain);
  add_numbers(row, section.force);
  add_numbers(row, std::array<double, 4>{{section.utilization, section.plastic_strain,
                                          section.creep_strain, section.dissipated}});
  row += '\n';
}

/// Names of the histories' files; points that differ only in signs that no file name takes get a
/// number.
std::vector<std::string> history_names(const std::vector<History> &histories) {
  std::vector<std::string> names;
  std::set<std::string> taken;
  for (const auto &history : histories) {
    const std::string stem = "history_" + file_name_part(history.point);
    std::string name = stem;
    for (unsigned int i = 2; !taken.insert(name).second; ++i)
      name = stem + "_" + std::to_string(i);
    names.push_back(name + ".csv");
  }
  return names;
}

} // namespace

std::string csv_field(const std::string &text) {
  const auto needs_quotes = [](const char c) {
    return c == ',' || c == '"' || c == '\r' || c == '\n';
  };
  if (std::none_of(text.begin(), text.end(), needs_quotes))
    return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"')
      quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

void remove_line_tables(const std::string &folder) {
  std::error_code error; // there may be none
  for (const char *const name :
       {"supports.csv", "line.csv", "sections.csv", "reactions.csv", "envelope.csv", "nodes.csv",
        "elements.csv", "restraints.csv", "element_forces.csv", "restraint_forces.csv"})
    std::filesystem::remove(std::filesystem::path(folder) / name, error);
}

CsvWriter::CsvWriter(const Scene &scene, const Results &results, const std::string &folder,
                     const bool keep)
    : scene(scene), results(results), supports(folder + "/supports.csv", keep),
      line(folder + "/line.csv", keep), reactions(folder + "/reactions.csv", keep),
      n_written(results.histories.size(), 0) {
  if (scene.yields())
    sections = std::make_unique<OutputFile>(folder + "/sections.csv", keep);
  for (const auto &name : history_names(results.histories))
    histories.push_back(std::make_unique<OutputFile>(folder + "/" + name, keep));
  if (keep)
    return;
  supports.stream() << "support,step,increment,time,status,fn,ft1,ft2,gap,slip1,slip2,"
                       "work_friction,mt\n";
  line.stream() << "step,pipe,s,x,y,z,ux,uy,uz,rx,ry,rz,N,Vy,Vz,Mx,My,Mz,M_in,M_out\n";
  reactions.stream() << "restraint,step,increment,time,fx,fy,fz,mx,my,mz\n";
  supports.flush();
  line.flush();
  reactions.flush();
  if (sections) {
    sections->stream() << "step,pipe,s" << section_columns;
    sections->flush();
  }
  for (const auto &history : histories) {
    history->stream() << "time,ux,uy,uz,rx,ry,rz\n";
    history->flush();
  }
}

void CsvWriter::transfer(Archive &archive) {
  archive(supports, line, reactions, n_written);
  if (sections)
    archive(*sections);
  for (const auto &history : histories)
    archive(*history);
}

void CsvWriter::append(const Frame &frame) {
  append_supports(frame);
  append_reactions(frame);
  if (frame.end_of_step)
    append_line(frame);
  if (sections)
    append_sections(frame);
  finish();
}

void CsvWriter::finish() {
  AssertDimension(results.histories.size(), histories.size());
  for (unsigned int h = 0; h < histories.size(); ++h) {
    const History &history = results.histories[h];
    for (; n_written[h] < history.time.size(); ++n_written[h]) {
      std::string row = exact_number(history.time[n_written[h]]);
      Motion motion = history.displacement[n_written[h]];
      for (unsigned int d = 0; d < 3; ++d)
        motion[d] /= scene.units.factor("m");
      add_numbers(row, motion);
      histories[h]->stream() << row << '\n';
    }
    histories[h]->flush();
  }
}

void CsvWriter::append_supports(const Frame &frame) {
  AssertDimension(frame.supports.size(), results.supports.size());
  const std::string when = instant(frame);
  const auto add_row = [&](const std::size_t i, std::string &text) {
    const SupportState &state = frame.supports[i];
    text += csv_field(results.supports[i].name) + ',' + when + ',' + status_word(state.status);
    std::array<double, n_shown_support_numbers> numbers;
    for (unsigned int k = 0; k < numbers.size(); ++k)
      numbers[k] = state.*support_numbers[k];
    add_numbers(text, numbers);
    text += '\n';
  };
  write_rows(frame.supports.size(), add_row, supports);
}

void CsvWriter::append_reactions(const Frame &frame) {
  AssertDimension(frame.reactions.size(), results.restraints.size());
  const std::string when = instant(frame);
  const auto add_row = [&](const std::size_t i, std::string &text) {
    text += csv_field(results.restraints[i].name) + ',' + when;
    add_numbers(text, frame.reactions[i]);
    text += '\n';
  };
  write_rows(frame.reactions.size(), add_row, reactions);
}

void CsvWriter::append_line(const Frame &frame) {
  const std::string step = csv_field(frame.name) + ',';
  const auto add_row = [&](const std::size_t i, std::string &text) {
    const Station &station = frame.line[i];
    AssertIndexRange(station.pipe, scene.pipes.size());
    (text += step) += csv_field(scene.pipes[station.pipe].name);
    add_numbers(text, std::array<double, 4>{{station.s, station.position[0], station.position[1],
                                             station.position[2]}});
    add_numbers(text, station.displacement);
    add_numbers(text, station.force);
    // The node where a bend begins may be the last station of what is before it.
    const bool begins_cell = station.is_node() && station.bend_radius == 0. &&
                             i + 1 < frame.line.size() && frame.line[i + 1].pipe == station.pipe;
    if (frame.is_amplitude) // sizes along axes, of which no other component can be made
      text += ",,";
    else
      add_numbers(text, moments_of_bend(frame.line[begins_cell ? i + 1 : i].bend_axis, station));
    text += '\n';
  };
  write_rows(frame.line.size(), add_row, line);
}

void CsvWriter::append_sections(const Frame &frame) {
  for (const SectionState &section : frame.sections) {
    std::string row = csv_field(frame.name) + ',' + csv_field(scene.pipes[section.pipe].name) +
                      ',' + exact_number(section.s);
    add_section(row, section);
    sections->stream() << row;
  }
  sections->flush();
}

void write_section_histories(const Scene &scene, const Results &results,
                             const std::string &folder) {
  if (results.section_histories.empty())
    return;
  std::string text = std::string("section,pipe,s,time") + section_columns;
  for (const SectionHistory &history : results.section_histories)
    for (std::size_t i = 0; i < history.time.size(); ++i) {
      const SectionState state = in_units(scene.units, history.states[i]);
      text += csv_field(history.name) + ',' + csv_field(scene.pipes[state.pipe].name) + ',' +
              exact_number(state.s) + ',' + exact_number(history.time[i]);
      add_section(text, state);
    }
  write_file(folder + "/section_history.csv", text);
}

} // namespace frictionbeam
