// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/combination/governing_cases.h"

#include "results/file/csv_writer.h"
#include "results/file/output_file.h"
#include "results/page/html.h"
#include "results/report/limits.h"
#include "results/text.h"

#include <algorithm>
#include <map>

namespace frictionbeam {

namespace {

using Kind = Combination::Kind;

constexpr std::array<const char *, 6> motion_words{{"ux", "uy", "uz", "rx", "ry", "rz"}},
    section_words{{"N", "Vy", "Vz", "Mx", "My", "Mz"}},
    reaction_words{{"fx", "fy", "fz", "mx", "my", "mz"}};
constexpr std::array<const char *, n_shown_support_numbers> support_words{
    {"fn", "ft1", "ft2", "gap", "slip1", "slip2", "work_friction", "mt"}};

/// Places among the numbers of a frame, in the order of numbers_of().
std::size_t of_station(const std::size_t i) { return 12 * i; }
std::size_t of_support(const Frame &frame, const std::size_t i) {
  return of_station(frame.line.size()) + n_shown_support_numbers * i;
}
std::size_t of_reaction(const Frame &frame, const std::size_t i) {
  return of_support(frame, frame.supports.size()) + 6 * i;
}

/// The case, or of a range both: "hot - cold".
std::string case_of(const GoverningCases &governing, const std::size_t number) {
  const std::string &name = governing.cases[governing.of[number]];
  return governing.least.empty() ? name : name + " - " + governing.cases[governing.least[number]];
}

/// The case behind a number of a case, which may be a combination that has some itself.
class Resolver {
public:
  Resolver(const Combination &combination, const Results &results, GoverningCases &into)
      : into(into) {
    for (const auto &part : combination.cases) {
      const auto found = std::find_if(
          results.governing.begin(), results.governing.end(),
          [&](const GoverningCases &one) { return one.name == part.first && one.least.empty(); });
      names.push_back(part.first);
      inner.push_back(found == results.governing.end() ? nullptr : &*found);
    }
  }

  unsigned int operator()(const unsigned int part, const Eigen::Index number) {
    const GoverningCases *const own = inner[part];
    const std::string &name = own != nullptr ? own->cases[own->of[number]] : names[part];
    const auto [place, is_new] = places.emplace(name, into.cases.size());
    if (is_new)
      into.cases.push_back(name);
    return place->second;
  }

private:
  GoverningCases &into;
  std::vector<std::string> names;
  std::vector<const GoverningCases *> inner;  ///< null: the case itself
  std::map<std::string, unsigned int> places; ///< in GoverningCases::cases
};

/// A table of words, a row for each of @p names.
template <typename Number>
std::string word_table(const GoverningCases *const governing, const std::string &what,
                       const std::vector<std::string> &names, const char *const *const words,
                       const unsigned int n, const Number &number) {
  if (governing == nullptr || names.empty())
    return "";
  HtmlTable table;
  const std::size_t n_rows = std::min(names.size(), n_rows_at_most);
  table.text(what, {names.begin(), names.begin() + n_rows});
  for (unsigned int c = 0; c < n; ++c) {
    std::vector<std::string> cells;
    for (std::size_t i = 0; i < n_rows; ++i)
      cells.push_back(case_of(*governing, number(i) + c));
    table.text(words[c], cells);
  }
  return "<h3>The case that gave it</h3>\n" + table.str() +
         (n_rows < names.size() ? html_note("governing.csv has all.") : "");
}

template <typename Info>
std::vector<std::string> names_of(const std::vector<Info> &all) {
  std::vector<std::string> names;
  for (const Info &one : all)
    names.push_back(one.name);
  return names;
}

} // namespace

bool has_governing_cases(const Kind kind) {
  return kind == Kind::envelope || kind == Kind::maximum || kind == Kind::minimum ||
         kind == Kind::range;
}

GoverningCases governing_cases(const Combination &combination, const std::vector<CaseRange> &cases,
                               const Results &results) {
  GoverningCases governing;
  governing.name = combination.name;
  const std::vector<NumberBounds> bounds = bounds_of(combination, cases);
  Resolver resolve(combination, results, governing);
  const bool least_counts = combination.kind != Kind::maximum,
             largest_counts = combination.kind != Kind::minimum;
  for (Eigen::Index n = 0; n < bounds.front().least.size(); ++n) {
    unsigned int lowest = 0, highest = 0;
    for (unsigned int i = 1; i < bounds.size(); ++i) {
      lowest = bounds[i].least[n] < bounds[lowest].least[n] ? i : lowest;
      highest = bounds[i].largest[n] > bounds[highest].largest[n] ? i : highest;
    }
    if (combination.kind == Kind::range) {
      governing.of.push_back(resolve(highest, n));
      governing.least.push_back(resolve(lowest, n));
      continue;
    }
    const bool is_least =
        least_counts && (!largest_counts ||
                         std::abs(bounds[lowest].least[n]) > std::abs(bounds[highest].largest[n]));
    governing.of.push_back(resolve(is_least ? lowest : highest, n));
  }
  return governing;
}

const GoverningCases *governing_of(const Results &results, const Frame &frame) {
  for (const GoverningCases &one : results.governing)
    if (one.name == frame.name)
      return &one;
  return nullptr;
}

std::string governing_support_table(const Results &results, const Frame &frame) {
  constexpr unsigned int n_columns = 6; // forces, gap, slip
  return word_table(governing_of(results, frame), "support", names_of(results.supports),
                    support_words.data(), n_columns,
                    [&](const std::size_t i) { return of_support(frame, i); });
}

std::string governing_reaction_table(const Results &results, const Frame &frame) {
  return word_table(governing_of(results, frame), "restraint", names_of(results.restraints),
                    reaction_words.data(), 6,
                    [&](const std::size_t i) { return of_reaction(frame, i); });
}

std::string governing_point_table(const Results &results, const Frame &frame) {
  std::vector<std::string> names;
  std::vector<std::size_t> stations;
  for (const PointInfo &point : results.points)
    for (std::size_t i = 0; i < frame.line.size(); ++i)
      if (frame.line[i].vertex == point.vertex) {
        names.push_back(point.name);
        stations.push_back(i);
        break;
      }
  return word_table(governing_of(results, frame), "point", names, motion_words.data(), 6,
                    [&](const std::size_t i) { return of_station(stations[i]); });
}

void write_governing_cases(const Scene &scene, const Results &results, const std::string &folder) {
  if (results.governing.empty())
    return;
  OutputFile file(folder + "/governing.csv");
  file.stream() << "combination,of,name,s,number,value,case\n";
  for (const Frame &in_si : results.frames) {
    const GoverningCases *const governing = governing_of(results, in_si);
    if (governing == nullptr)
      continue;
    Frame converted;
    const Frame &frame = in_units(scene.units, in_si, converted);
    const auto row = [&](const std::string &of, const std::string &name, const std::string &s,
                         const char *const word, const double value, const std::size_t number) {
      file.stream() << csv_field(frame.name) << ',' << of << ',' << csv_field(name) << ',' << s
                    << ',' << word << ',' << exact_number(value) << ','
                    << csv_field(case_of(*governing, number)) << '\n';
    };
    for (std::size_t i = 0; i < frame.line.size(); ++i) {
      const Station &station = frame.line[i];
      const std::string &pipe = scene.pipes[station.pipe].name, s = exact_number(station.s);
      for (unsigned int c = 0; c < 6; ++c)
        row("pipe", pipe, s, motion_words[c], station.displacement[c], of_station(i) + c);
      for (unsigned int c = 0; c < 6; ++c)
        row("pipe", pipe, s, section_words[c], station.force[c], of_station(i) + 6 + c);
    }
    for (std::size_t i = 0; i < frame.supports.size(); ++i)
      for (unsigned int k = 0; k < n_shown_support_numbers; ++k)
        row("support", results.supports[i].name, "", support_words[k],
            frame.supports[i].*support_numbers[k], of_support(frame, i) + k);
    for (std::size_t i = 0; i < frame.reactions.size(); ++i)
      for (unsigned int c = 0; c < 6; ++c)
        row("restraint", results.restraints[i].name, "", reaction_words[c], frame.reactions[i][c],
            of_reaction(frame, i) + c);
  }
  file.flush();
}

} // namespace frictionbeam
