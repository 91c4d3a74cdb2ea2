// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#define BOOST_BIND_GLOBAL_PLACEHOLDERS // Boost 1.74 asks for it
#include <boost/property_tree/json_parser.hpp>

#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

/// Runs the program as a user does and reads what it leaves behind.
namespace program {

struct Quantity {
  std::string name, unit, source;
  double value = 0.;
  std::optional<double> reference, error;
};

/// What a run left behind.
struct Run {
  int exit_status = -1; ///< -1: ended by a signal
  std::string output;   ///< standard output and errors
  bool summary = false; ///< whether there is one, in valid JSON
  std::string status;   ///< the rest is from summary.json
  double wall_seconds = 0.;
  std::vector<Quantity> quantities;
  std::map<std::string, double> certificate, energy, cost;

  const Quantity &quantity(const std::string &name) const {
    for (const Quantity &q : quantities)
      if (q.name == name)
        return q;
    throw std::runtime_error("There is no quantity '" + name + "'.\n" + output);
  }
  double operator[](const std::string &name) const { return quantity(name).value; }
};

/// A folder of its own, gone at the end.
class TemporaryFolder {
public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "frictionbeam-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
      throw std::runtime_error("No temporary folder can be made.");
    path = name;
  }
  ~TemporaryFolder() {
    std::error_code error;
    std::filesystem::remove_all(path, error);
  }
  TemporaryFolder(const TemporaryFolder &) = delete;
  TemporaryFolder &operator=(const TemporaryFolder &) = delete;

  std::filesystem::path path;
};

inline std::string text_of(const std::filesystem::path &file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// A number of summary.json; null is no number.
inline std::optional<double> number(const boost::property_tree::ptree &tree, const char *name) {
  const auto text = tree.get<std::string>(name);
  if (text == "null")
    return {};
  return std::stod(text);
}

/// Read summary.json of @p folder into @p run.
inline void read_summary(const std::filesystem::path &folder, Run &run) {
  if (!std::filesystem::exists(folder / "summary.json"))
    return;
  boost::property_tree::ptree tree;
  boost::property_tree::read_json((folder / "summary.json").string(), tree);
  run.summary = true;
  run.status = tree.get<std::string>("status");
  run.wall_seconds = tree.get<double>("cost.wall_seconds");
  for (const auto &[key, entry] : tree.get_child("cost"))
    if (const auto figure = entry.get_value_optional<double>())
      run.cost[key] = *figure;
  for (const auto &[key, entry] : tree.get_child("certificate"))
    run.certificate[key] =
        entry.data() == "null" ? std::numeric_limits<double>::quiet_NaN() : std::stod(entry.data());
  if (const auto account = tree.get_child_optional("energy"))
    for (const auto &[key, entry] : *account)
      run.energy[key] = std::stod(entry.data());
  for (const auto &[key, entry] : tree.get_child("quantities"))
    run.quantities.push_back(
        {entry.get<std::string>("name"), entry.get<std::string>("unit"),
         entry.get<std::string>("source"),
         number(entry, "value").value_or(std::numeric_limits<double>::quiet_NaN()),
         number(entry, "reference"), number(entry, "error")});
}

/// The program's main() where it is linked into the test; a command of this name is run by it.
inline int (*linked)(int, char **) = nullptr;
constexpr char linked_name[] = "frictionbeam";
inline std::streambuf *standard_output =
    nullptr; ///< of std::cout then, whatever a test does with it

/// Become a command.
[[noreturn]] inline void become(std::vector<std::string> &words) {
  std::vector<char *> arguments;
  for (std::string &word : words)
    arguments.push_back(word.data());
  arguments.push_back(nullptr);
  if (linked != nullptr && words[0] == linked_name) { // as it finds its streams at its beginning
    std::cout.rdbuf(standard_output);
    std::cout.copyfmt(std::ios(nullptr));
    std::cerr.copyfmt(std::ios(nullptr));
    std::cerr << std::unitbuf;
    std::cerr.tie(&std::cout);
    std::exit(linked(words.size(), arguments.data()));
  }
  execv(arguments[0], arguments.data());
  _exit(127);
}

/// Run a command, its output into the run.
inline Run execute(std::vector<std::string> words) {
  const TemporaryFolder log;
  const std::string log_file = (log.path / "log").string();
  std::cout.flush(); // not once more by the child
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    if (freopen(log_file.c_str(), "w", stdout) != nullptr && dup2(fileno(stdout), 2) == 2)
      become(words);
    _exit(127);
  }
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child)
    throw std::runtime_error("The program cannot be started.");
  Run result;
  result.exit_status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  result.output = text_of(log_file);
  return result;
}

/// Run `program file options... --output-directory folder`.
inline Run run(const std::string &program, const std::string &file,
               const std::vector<std::string> &options, const std::filesystem::path &folder) {
  std::vector<std::string> words{program, file};
  words.insert(words.end(), options.begin(), options.end());
  words.insert(words.end(), {"--output-directory", folder.string()});
  Run result = execute(words);
  read_summary(folder, result);
  return result;
}

/// The same, into a folder that is gone afterwards.
inline Run run(const std::string &program, const std::string &file,
               const std::vector<std::string> &options = {}) {
  const TemporaryFolder folder;
  return run(program, file, options, folder.path / "results");
}

} // namespace program
