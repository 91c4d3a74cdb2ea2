// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/law_conformance.h>
#include <frictionbeam/law_library.h>

#include "number_text.h"

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <stdexcept>

#include <unistd.h>

namespace {

using namespace frictionbeam;

const char *const help =
    "frictionbeam-check-law LAW.so [NAME=VALUE]... [LAW.so [NAME=VALUE]...]...\n"
    "Loads laws and puts each to the conformance test: along random strain paths, and if it has a\n"
    "closed form, against that.\n"
    "  NAME=VALUE  a parameter of the law before it, in its own unit; else its default.\n"
    "              Quote names with blanks: 'Friction coefficient=0.2'\n"
    "  --help      this text\n"
    "Says what is violated, and which branches of the law were reached: what never was, was not\n"
    "checked. Try other parameters for it. Exit status 0 if all laws conform, else 1.\n";

/// A message in the form of the program's own.
[[noreturn]] void refuse(const std::string &read, const std::string &allowed,
                         const std::string &hint) {
  throw std::runtime_error("frictionbeam-check-law:\n  read:    " + read +
                           "\n  allowed: " + allowed + "\n  try:     " + hint);
}

std::string names_of(const LawDescription &law) {
  std::string names;
  for (int i = 0; i < law.n_parameters; ++i)
    names += std::string(i == 0 ? "" : ", ") + law.parameters[i].name;
  return names.empty() ? "none" : names;
}

/// Set the parameter that @p word, NAME=VALUE, says.
void set_parameter(const LawDescription &law, const std::string &word,
                   std::vector<double> &parameters) {
  const std::size_t sign = word.rfind('=');
  const std::string name = word.substr(0, sign), value = word.substr(sign + 1);
  for (int i = 0; i < law.n_parameters; ++i) {
    const LawParameter &p = law.parameters[i];
    if (name != p.name)
      continue;
    char *end = nullptr;
    const double number = std::strtod(value.c_str(), &end);
    const bool is_number = !value.empty() && *end == '\0';
    if (!is_number || !(p.minimum <= number && number <= p.maximum))
      refuse("'" + word + "'",
             "a number from " + text_of(p.minimum) + " to " + text_of(p.maximum) + " [" + p.unit +
                 "] for '" + name + "' of the law '" + law.name + "'",
             "'" + name + "=" + text_of(p.default_value) + "', its default");
    parameters[i] = number;
    return;
  }
  refuse("'" + word + "'",
         "parameters of the law '" + std::string(law.name) + "': " + names_of(law),
         law.n_parameters == 0 ? "leaving it out"
                               : "'" + std::string(law.parameters[0].name) + "=" +
                                     text_of(law.parameters[0].default_value) + "'");
}

bool is_parameter(const std::string &word) {
  return word.find('=') != std::string::npos && !std::filesystem::exists(word);
}

/// "stick 12, slip 300", and those that were never reached.
void print_reached(const LawDescription &law, const LawReach &reached) {
  std::string seen, never;
  const auto add = [&](const std::string &name, const int count, const bool is_expected) {
    if (count > 0)
      seen += (seen.empty() ? "" : ", ") + name + ' ' + std::to_string(count);
    else if (is_expected)
      never += (never.empty() ? "" : ", ") + name;
  };
  const bool is_support = law.kind == LawKind::support;
  add("open", reached.open, is_support);
  add("stick", reached.stick, is_support);
  add("slip", reached.slip, is_support);
  add("closed", reached.closed, false);
  add("elastic", reached.elastic, true);
  add("dissipating", reached.dissipating, true);
  add("failed", reached.failed, false);
  std::cout << "  reached in " << reached.increments << " increments: " << seen << '\n';
  if (!never.empty())
    std::cout << "  never reached, and not checked: " << never
              << (law.n_parameters > 0 ? "; other parameters may: " + names_of(law) : "") << '\n';
}

/// What is said of the law at hand if it ends the program, by an exception or a wrong address.
char last_words[512] = "";

void say_and_end(int) {
  // Nothing else may be called in a signal's handler.
  const auto written = write(STDERR_FILENO, last_words, std::strlen(last_words));
  _exit(written < 0 ? 2 : 1);
}

bool conforms(const LawDescription &law, const std::vector<double> &parameters) {
  std::snprintf(last_words, sizeof(last_words),
                "%s does not conform: it ends the program, by an exception that leaves integrate() "
                "or a wrong address\n",
                law.name);
  for (const int signal : {SIGABRT, SIGSEGV, SIGFPE, SIGBUS, SIGILL})
    std::signal(signal, say_and_end);
  LawReach reached;
  const auto violations = check_law(law, parameters, reached);
  for (const auto &violation : violations)
    std::cerr << law.name << ": " << violation << '\n';
  std::cout << law.name << (violations.empty() ? " conforms\n" : " does not conform\n");
  print_reached(law, reached);
  return violations.empty();
}

bool all_conform(const std::vector<std::string> &words) {
  LawLibrary library;
  bool result = true;
  for (std::size_t i = 0; i < words.size();) {
    if (is_parameter(words[i]))
      refuse("'" + words[i] + "' before any law", "parameters behind the law they belong to",
             "'LAW.so' before it");
    if (words[i].compare(0, 1, "-") == 0)
      refuse("'" + words[i] + "'", "--help, libraries of laws, and NAME=VALUE", "--help");
    if (words[i].empty())
      refuse("a word without a letter", "libraries of laws, and NAME=VALUE", "--help");
    const LawDescription &law = library.load(words[i++]);
    std::vector<double> parameters = default_parameters(law);
    for (; i < words.size() && is_parameter(words[i]); ++i)
      set_parameter(law, words[i], parameters);
    result = conforms(law, parameters) && result;
  }
  return result;
}

} // namespace

int main(int argc, char **argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  for (const std::string &word : words)
    if (word == "--help" || word == "-h") {
      std::cout << help;
      return 0;
    }
  if (words.empty()) {
    std::cerr << help;
    return 1;
  }
  try {
    return all_conform(words) ? 0 : 1;
  } catch (const std::runtime_error &error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
