// SPDX-License-Identifier: LGPL-2.1-or-later
// A case shall end with the given exit status and status word, and its quantities shall be as near
// to their references as the options say. References come from the case itself (see its text).
//
//   [--set "Section/Entry = value"]... checks...
//   --exit N, --status WORD    expected instead of 0, converged
//   --output-directory PATH    instead of a temporary folder
//   --error NAME TOLERANCE     of one quantity, relative to its reference
//   --errors TOLERANCE         of all quantities that have a reference and no --error of their own
//   --figures TOLERANCE PART   of all whose reference exceeds PART times the largest of that unit
//   --value NAME BOUND         absolute value of one quantity
//   --check NAME BOUND         line of the certificate
//   --cost NAME BOUND          of summary.json's cost
//   --null NAME                line of the certificate that has no figure
//   --energy NAME VALUE TOLERANCE  of the account of energy [J], relative; absolute if VALUE is 0
//   --ratio NAME LOW HIGH A B  its value with --set A over the one with --set B
//   --same-as OTHER TOLERANCE  all quantities as those of another parameter file
//   --strict, --resume         as the program's
//   --expect TEXT              the program's output has it in it
//   --without TEXT             it has not
//   --file NAME TEXT           the file of this name in the folder has it in it
//   --csv NAME WHERE COLUMN VALUE TOLERANCE  in rows of a table where WHERE ("step=hot s=0
//   pipe=leg") holds, of which
//                              there is one: relative; absolute if VALUE is 0
//   --message                  every line '# expect: TEXT' of the file is in the program's output
#include "case_checks.h"

#include "../check.h"
#include "base/csv_row.h"
#include "run_program.h"

#include <algorithm>
#include <functional>
#include <map>
#include <set>

namespace {

using program::Quantity;
using program::Run;

/// The words of the command line, one after the other.
class Words {
public:
  explicit Words(const std::vector<std::string> &words) : words(words) {}
  bool empty() const { return next == words.size(); }
  std::string take() {
    if (empty())
      throw std::runtime_error("A word is missing at the end of the command line.");
    return words[next++];
  }
  double take_number() { return std::stod(take()); }

private:
  const std::vector<std::string> &words;
  std::size_t next = 0;
};

void expect(const bool holds, const std::string &what) {
  ++check::n_checks;
  if (!holds) {
    ++check::n_failures;
    std::cerr << what << '\n';
  }
}

std::string text(const double value) {
  std::ostringstream out;
  out << std::setprecision(17) << value;
  return out.str();
}

/// Error of a quantity by our own count; the program must say the same.
void check_error(const Quantity &q, const double tolerance) {
  if (!q.reference || !q.error)
    return expect(false, q.name + " has no reference");
  const double difference = std::abs(q.value - *q.reference),
               error = *q.reference == 0. ? difference : difference / std::abs(*q.reference);
  expect(error <= tolerance, q.name + " = " + text(q.value) + ", reference " + text(*q.reference) +
                                 ", error " + text(error) + " > " + text(tolerance));
  expect(std::abs(error - *q.error) <= 1e-12 * std::max(error, 1e-3),
         "summary.json says error " + text(*q.error) + " of " + q.name + ", it is " + text(error));
}

void check_all(const Run &run, const double tolerance, const std::set<std::string> &others) {
  unsigned int n = 0;
  for (const Quantity &q : run.quantities)
    if (q.reference && others.count(q.name) == 0) {
      check_error(q, tolerance);
      ++n;
    }
  expect(n > 0, "no quantity has a reference");
}

void check_figures(const Run &run, const double tolerance, const double part) {
  std::map<std::string, double> largest;
  for (const Quantity &q : run.quantities)
    largest[q.unit] = std::max(largest[q.unit], std::abs(q.reference.value_or(0.)));
  unsigned int n = 0;
  for (const Quantity &q : run.quantities)
    if (q.reference && std::abs(*q.reference) > part * largest[q.unit]) {
      check_error(q, tolerance);
      ++n;
    }
  std::cout << n << " of " << run.quantities.size() << " quantities are large enough to count\n";
  expect(n > 0, "no quantity has a reference");
}

void check_same(const Run &run, const Run &other, const double tolerance) {
  expect(!run.quantities.empty() && run.quantities.size() == other.quantities.size(),
         "the quantities of the two files are not the same");
  std::map<std::string, double> largest;
  for (const Quantity &q : run.quantities)
    largest[q.unit] = std::max(largest[q.unit], std::abs(q.value));
  for (const Quantity &q : run.quantities)
    expect(std::abs(q.value - other[q.name]) <= tolerance * largest[q.unit],
           q.name + " = " + text(q.value) + ", in the other file " + text(other[q.name]));
}

void check_output(const Run &run, const std::string &part) {
  expect(run.output.find(part) != std::string::npos, "'" + part + "' is not in the output");
}

/// In a table of the results, the rows in which columns have the texts that @p where names.
void check_table(const std::string &file, const std::string &where, const std::string &column,
                 const double reference, const double tolerance) {
  std::istringstream lines(program::text_of(file)), words(where);
  std::map<std::string, std::string> wanted;
  for (std::string word; words >> word;)
    wanted[word.substr(0, word.find('='))] = word.substr(word.find('=') + 1);
  std::string line;
  std::getline(lines, line);
  const std::vector<std::string> names = frictionbeam::csv_fields(line);
  unsigned int n = 0;
  while (std::getline(lines, line)) {
    const std::vector<std::string> row = frictionbeam::csv_fields(line);
    std::map<std::string, std::string> fields;
    for (std::size_t i = 0; i < names.size() && i < row.size(); ++i)
      fields[names[i]] = row[i];
    if (!std::all_of(wanted.begin(), wanted.end(),
                     [&](const auto &one) { return fields.at(one.first) == one.second; }))
      continue;
    const double size = reference == 0. ? 1. : std::abs(reference);
    expect(std::abs(std::stod(fields.at(column)) - reference) <= tolerance * size,
           column + " = " + fields.at(column) + ", not " + text(reference) + ", in " + line);
    ++n;
  }
  expect(n > 0, file + " has no row where " + where);
}

/// The texts that a broken file's comments promise.
void check_message(const Run &run, const std::string &file) {
  std::istringstream lines(program::text_of(file));
  const std::string prefix = "# expect: ";
  unsigned int n = 0;
  for (std::string line; std::getline(lines, line);)
    if (line.compare(0, prefix.size(), prefix) == 0) {
      check_output(run, line.substr(prefix.size()));
      ++n;
    }
  expect(n > 0, "the file expects nothing");
}

} // namespace

void check_case(const std::string &binary, const std::string &file,
                const std::vector<std::string> &options_and_checks) {
  Words words(options_and_checks);
  std::vector<std::string> options;
  std::vector<std::function<void(const Run &)>> checks;
  std::set<std::string> with_own_tolerance;
  int exit_status = 0;
  std::string status = "converged";
  const program::TemporaryFolder temporary;
  std::filesystem::path folder = temporary.path / "results";
  const auto run_another = [binary](const std::string &other,
                                    const std::vector<std::string> &other_options) {
    const Run run = program::run(binary, other, other_options);
    expect(run.exit_status == 0, "the run of " + other + " failed:\n" + run.output);
    return run;
  };
  const auto with = [&options](const std::string &entry) {
    std::vector<std::string> all = options;
    all.insert(all.end(), {"--set", entry});
    return all;
  };
  while (!words.empty()) {
    const std::string word = words.take();
    if (word == "--set")
      options.insert(options.end(), {word, words.take()});
    else if (word == "--resume" || word == "--strict")
      options.push_back(word);
    else if (word == "--exit")
      exit_status = std::stoi(words.take());
    else if (word == "--status")
      status = words.take();
    else if (word == "--output-directory")
      folder = words.take();
    else if (word == "--error") {
      const std::string name = words.take();
      const double tolerance = words.take_number();
      checks.push_back([=](const Run &run) { check_error(run.quantity(name), tolerance); });
      with_own_tolerance.insert(name);
    } else if (word == "--errors") {
      const double tolerance = words.take_number();
      checks.push_back([=, &with_own_tolerance](const Run &run) {
        check_all(run, tolerance, with_own_tolerance);
      });
    } else if (word == "--figures") {
      const double tolerance = words.take_number(), part = words.take_number();
      checks.push_back([=](const Run &run) { check_figures(run, tolerance, part); });
    } else if (word == "--value") {
      const std::string name = words.take();
      const double bound = words.take_number();
      checks.push_back([=](const Run &run) {
        expect(std::abs(run[name]) <= bound, name + " = " + text(run[name]) + " > " + text(bound));
      });
    } else if (word == "--check") {
      const std::string name = words.take();
      const double bound = words.take_number();
      checks.push_back([=](const Run &run) {
        const double value = run.certificate.at(name);
        expect(value <= bound, "certificate: " + name + " = " + text(value) + " > " + text(bound));
      });
    } else if (word == "--cost") {
      const std::string name = words.take();
      const double bound = words.take_number();
      checks.push_back([=](const Run &run) {
        expect(run.cost.at(name) <= bound,
               "cost: " + name + " = " + text(run.cost.at(name)) + " > " + text(bound));
      });
    } else if (word == "--null") {
      const std::string name = words.take();
      checks.push_back([=](const Run &run) {
        expect(std::isnan(run.certificate.at(name)), "certificate: " + name + " is not null");
      });
    } else if (word == "--energy") {
      const std::string name = words.take();
      const double reference = words.take_number(), tolerance = words.take_number();
      checks.push_back([=](const Run &run) {
        const double size = reference == 0. ? 1. : std::abs(reference);
        expect(std::abs(run.energy.at(name) - reference) <= tolerance * size,
               "energy: " + name + " = " + text(run.energy.at(name)) + ", not " + text(reference));
      });
    } else if (word == "--ratio") {
      const std::string name = words.take();
      const double low = words.take_number(), high = words.take_number();
      const std::string a = words.take(), b = words.take();
      checks.push_back([=](const Run &) {
        const double ratio = run_another(file, with(a))[name] / run_another(file, with(b))[name];
        std::cout << "ratio of " << name << ": " << ratio << '\n';
        expect(ratio >= low && ratio <= high, "it is not within the bounds");
      });
    } else if (word == "--same-as") {
      const std::string other = words.take();
      const double tolerance = words.take_number();
      checks.push_back([=](const Run &run) { check_same(run, run_another(other, {}), tolerance); });
    } else if (word == "--expect") {
      const std::string part = words.take();
      checks.push_back([=](const Run &run) { check_output(run, part); });
    } else if (word == "--without") {
      const std::string part = words.take();
      checks.push_back([=](const Run &run) {
        expect(run.output.find(part) == std::string::npos, "'" + part + "' is in the output");
      });
    } else if (word == "--file") {
      const std::string name = words.take(), part = words.take();
      checks.push_back([=, &folder](const Run &) {
        expect(program::text_of(folder / name).find(part) != std::string::npos,
               "'" + part + "' is not in " + name);
      });
    } else if (word == "--csv") {
      const std::string name = words.take(), where = words.take(), column = words.take();
      const double reference = words.take_number(), tolerance = words.take_number();
      checks.push_back([=, &folder](const Run &) {
        check_table(folder / name, where, column, reference, tolerance);
      });
    } else if (word == "--message")
      checks.push_back([=](const Run &run) { check_message(run, file); });
    else
      throw std::runtime_error("There is no check '" + word + "'.");
  }

  const Run run = program::run(binary, file, options, folder);
  std::cout << run.output;
  expect(run.exit_status == exit_status, "exit status " + std::to_string(run.exit_status));
  const bool is_strict_of_results =
      run.output.find("Hardly meant, by the results") != std::string::npos;
  if (exit_status == 1 && !is_strict_of_results)
    expect(!run.summary, "there is a summary.json of a run that the input forbids");
  else
    expect(run.status == status, "status in summary.json: '" + run.status + "'");
  for (const auto &one : checks)
    one(run);
}
