// SPDX-License-Identifier: LGPL-2.1-or-later
// check_cases [--of CASE.prm [--test NAME OPTIONS...]...]...: many tests of cases, as check_case
// makes them. The program is linked in and runs in a process of its own each time: it is loaded
// once, which takes longer than most small cases do.
#include "../check.h"
#include "case_checks.h"
#include "command/program/program.h"
#include "run_program.h"

#include <chrono>
#include <sstream>

namespace {

struct Test {
  std::string file, name;
  std::vector<std::string> words;
};

std::vector<Test> read_tests(const std::vector<std::string> &words) {
  std::vector<Test> tests;
  std::string file;
  for (std::size_t i = 0; i < words.size(); ++i)
    if ((words[i] == "--of" || words[i] == "--test") && i + 1 < words.size()) {
      if (words[i] == "--of")
        file = words[++i];
      else
        tests.push_back({file, words[++i], {}});
    } else if (tests.empty() || file.empty())
      throw std::runtime_error("check_cases [--of CASE.prm [--test NAME OPTIONS...]...]...");
    else
      tests.back().words.push_back(words[i]);
  return tests;
}

/// What the runs print is shown where a test fails.
void make(const Test &test) {
  const int n_failures = check::n_failures;
  const auto begin = std::chrono::steady_clock::now();
  std::ostringstream printed;
  std::streambuf *const shown = std::cout.rdbuf(printed.rdbuf());
  try {
    check_case(program::linked_name, test.file, test.words);
  } catch (const std::exception &error) {
    std::cerr << error.what() << '\n';
    ++check::n_checks;
    ++check::n_failures;
  }
  std::cout.rdbuf(shown);
  const bool passed = check::n_failures == n_failures;
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  std::cout << test.name << ": " << (passed ? "passed" : "FAILED") << ", " << std::setprecision(3)
            << seconds.count() << " s" << std::endl;
  if (passed)
    return;
  std::cout << printed.str() << "Alone: check_case build/bin/frictionbeam " << test.file;
  for (const std::string &word : test.words)
    std::cout << (word.find(' ') == std::string::npos ? " " + word : " '" + word + "'");
  std::cout << std::endl;
}

} // namespace

int main(int argc, char **argv) {
  program::linked = &frictionbeam::run_program;
  program::standard_output = std::cout.rdbuf();
  try {
    for (const Test &test : read_tests({argv + 1, argv + argc}))
      make(test);
  } catch (const std::exception &error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return check::report();
}
