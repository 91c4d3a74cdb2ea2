// SPDX-License-Identifier: LGPL-2.1-or-later
// The program shall answer any input: no crash, no hang, no number that is not finite, no mistake
// of its own (exit status 3). Inputs are all files of the project with one to three changes, which
// depend on a seed and the number of the run alone. CONTRIBUTING.md says how to use it.
//   fuzz PROJECT [--runs N] [--first N] [--seed N] [--seconds N] [--law LIBRARY] [--keep FOLDER]
//   fuzz PROJECT --replay FOLDER [--time N]   the files of a folder, as they are, N seconds each
//   fuzz PROJECT --costs                      the text of costs.txt, which new files are to be put
//   into
#include "parameter_text.h"
#include "subjects.h"
#include "trial.h"

#include <frictionbeam/law_library.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>

namespace fs = std::filesystem;

namespace {

using namespace fuzz;

struct Options {
  std::string project, law, keep, replay;
  std::uint64_t runs = 1000, first = 0, seed = 1;
  double seconds = 1e9;
  unsigned int time = Trial().seconds;
};

Options read_options(const int argc, char **argv) {
  Options options;
  options.project = argv[1];
  for (int i = 2; i + 1 < argc; i += 2) {
    const std::string name = argv[i], value = argv[i + 1];
    if (name == "--runs")
      options.runs = std::stoull(value);
    else if (name == "--first")
      options.first = std::stoull(value);
    else if (name == "--seed")
      options.seed = std::stoull(value);
    else if (name == "--seconds")
      options.seconds = std::stod(value);
    else if (name == "--time")
      options.time = std::stoul(value);
    else if (name == "--law")
      options.law = value;
    else if (name == "--keep")
      options.keep = value;
    else if (name == "--replay")
      options.replay = value;
    else
      throw std::runtime_error("There is no option " + name + '.');
  }
  return options;
}

/// Leave out what the fault does not need: whole sections, then lines.
void minimize(Input &input, Subjects &subjects, const std::string &fault) {
  if (input.kind != Input::Kind::parameters)
    return;
  ParameterText text(input.text);
  unsigned int left = 150; // runs
  const auto still = [&](const ParameterText &shorter) {
    if (left == 0)
      return false;
    --left;
    Input trial = input;
    trial.text = shorter.text();
    return subjects.run(trial).fault == fault;
  };
  for (std::size_t i = text.sections.size(); i-- > 0;) {
    ParameterText shorter = text;
    shorter.sections.erase(shorter.sections.begin() + i);
    if (still(shorter))
      text = shorter;
  }
  for (std::size_t i = text.sections.size(); i-- > 0;)
    for (std::size_t j = text.sections[i].lines.size(); j-- > 0;) {
      ParameterText shorter = text;
      shorter.sections[i].lines.erase(shorter.sections[i].lines.begin() + j);
      if (still(shorter))
        text = shorter;
    }
  Input shortest = input;
  shortest.text = text.text();
  if (subjects.run(shortest).fault == fault)
    input = shortest;
}

class Record {
public:
  explicit Record(const std::string &folder) : folder(folder) {
    if (!folder.empty())
      fs::create_directories(folder);
  }

  void add(const std::uint64_t number, Input input, const Outcome &outcome, Subjects &subjects) {
    if (++n_faults[outcome.fault] > 3 || (input.kind == Input::Kind::parameters &&
                                          outcome.fault != "hang" && n_faults[outcome.fault] > 2))
      return;
    std::cout << "run " << number << ", " << input.origin << ": " << outcome.fault << std::endl;
    if (outcome.fault != "hang")
      minimize(input, subjects, outcome.fault);
    if (folder.empty()) {
      std::cout << input.text.substr(0, 3000) << outcome.output.substr(0, 1000) << std::endl;
      return;
    }
    const std::string name = folder + "/run_" + std::to_string(number) + input.ending();
    std::ofstream(name, std::ios::binary) << input.text;
    std::ofstream(name + ".txt") << input.origin << '\n'
                                 << input.words() << '\n'
                                 << outcome.fault << '\n'
                                 << outcome.output;
  }

  int report() const {
    for (const auto &[fault, n] : n_faults)
      std::cout << n << " times: " << fault << '\n';
    return n_faults.empty() ? 0 : 1;
  }

private:
  const std::string folder;
  std::map<std::string, unsigned int> n_faults;
};

int replay(const std::string &folder, Subjects &subjects) {
  unsigned int n = 0, n_bad = 0;
  for (const auto &entry : fs::directory_iterator(folder)) {
    const std::string ending = entry.path().extension().string();
    if (ending != ".prm" && ending != ".hdf5")
      continue;
    Input input;
    if (ending == ".hdf5")
      input.kind = Input::Kind::contact;
    input.origin = entry.path().string();
    input.folder = subjects.folder_of(folder);
    input.text = read_file(input.origin);
    const Outcome outcome = subjects.run(input);
    ++n;
    n_bad += !outcome.fault.empty();
    if (!outcome.fault.empty())
      std::cout << input.origin << ": " << outcome.fault << '\n' << outcome.output << '\n';
  }
  std::cout << n << " files, " << n_bad << " with a fault\n";
  return n > 0 && n_bad == 0 ? 0 : 1;
}

} // namespace

int main(int argc, char **argv) {
  if (argc < 2)
    return 2;
  if (argc == 3 && std::string(argv[2]) == "--costs") {
    Subjects(argv[1], "", 2).print_costs();
    return 0;
  }
  const Options options = read_options(argc, argv);
  const auto start = std::chrono::steady_clock::now();
  const auto passed = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  frictionbeam::LawLibrary laws;
  laws.load_builtin(); // which those to come find loaded
  Subjects subjects(options.project, options.law, options.time);
  if (!options.replay.empty())
    return replay(options.replay, subjects);
  subjects.prepare();
  Record record(options.keep);
  std::map<int, std::uint64_t> n_status;
  std::uint64_t n = 0, n_slow = 0;
  for (; n < options.runs && passed() < options.seconds; ++n) {
    const std::uint64_t number = options.first + n;
    const Input input = subjects.draw(options.seed, number);
    const Outcome outcome = subjects.run(input);
    ++n_status[outcome.status];
    n_slow += outcome.slow;
    if (outcome.slow && outcome.fault.empty())
      std::cout << "run " << number << ", " << input.origin << ": takes long" << std::endl;
    if (!outcome.fault.empty())
      record.add(number, input, outcome, subjects);
    if (n % 1000 == 999)
      std::cout << n + 1 << " runs in " << passed() << " s" << std::endl;
  }
  std::cout << n << " runs from number " << options.first << " of seed " << options.seed << " in "
            << passed() << " s; " << n_slow << " took long and ended when asked\n";
  for (const auto &[status, times] : n_status)
    std::cout << "exit status " << status << ": " << times << '\n';
  return record.report();
}
