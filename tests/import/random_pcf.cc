// SPDX-License-Identifier: LGPL-2.1-or-later
// Piping component files with random changes are either taken over or refused with a message;
// nothing crashes, and what is taken over is a parameter file that is read and meshed.
//   random_pcf FOLDER RUNS [SEED]
#include "base/user_error.h"
#include "import/import_pcf.h"
#include "model/line_model.h"
#include "scene/read_scene.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <random>
#include <sstream>

namespace {

using frictionbeam::import::ImportOptions;

std::string text_of(const std::string &path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

class Changes {
public:
  explicit Changes(const unsigned int seed) : random(seed) {}

  std::size_t below(const std::size_t n) { return n == 0 ? 0 : random() % n; }

  /// One to four changes of lines, words, numbers or bytes.
  std::string change(const std::string &text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
      lines.push_back(line);
    const std::size_t n = 1 + below(4);
    for (std::size_t i = 0; i < n && !lines.empty(); ++i)
      change_lines(lines);
    std::string result;
    for (const std::string &line : lines)
      result += line + "\n";
    if (below(12) == 0)
      result.resize(below(result.size() + 1));
    if (below(10) == 0 && !result.empty())
      result[below(result.size())] = static_cast<char>(random());
    return result;
  }

private:
  void change_lines(std::vector<std::string> &lines) {
    const std::size_t at = below(lines.size());
    switch (below(6)) {
    case 0:
      lines.erase(lines.begin() + at);
      break;
    case 1:
      lines.insert(lines.begin() + below(lines.size()), std::string(lines[at]));
      break;
    case 2:
      std::swap(lines[at], lines[below(lines.size())]);
      break;
    default:
      change_word(lines[at]);
    }
  }

  void change_word(std::string &line) {
    static const char *const words[] = {"0",         "-1",      "1e30",          "nan",
                                        "inf",       "1e-300",  "0.0001",        "100",
                                        "END-POINT", "ELBOW",   "TEE",           "PIPE",
                                        "MATERIALS", "SKEY",    "SUPPORT",       "OLET",
                                        "CO-ORDS",   "VALVE",   "1e308",         "",
                                        "MM",        "INCH",    "GASKET",        "180",
                                        "CAP",       "UNKNOWN", "BRANCH1-POINT", "CENTRE-POINT"};
    const std::size_t begin = line.find_first_not_of(' ');
    if (begin == std::string::npos)
      return;
    std::vector<std::string> parts;
    std::istringstream in(line);
    for (std::string part; in >> part;)
      parts.push_back(part);
    std::string &part = parts[below(parts.size())];
    char *end = nullptr;
    const double number = std::strtod(part.c_str(), &end);
    if (*end == '\0' && below(2) == 0) { // a number near by
      std::ostringstream changed;
      const double by[] = {0.5, 1., 2., 10., 100., 1e4};
      changed << number + by[below(6)] * (below(2) == 0 ? 1. : -1.);
      part = changed.str();
    } else
      part = words[below(sizeof(words) / sizeof(words[0]))];
    line.resize(begin);
    for (const std::string &one : parts)
      line += one + " ";
  }

  std::mt19937 random;
};

} // namespace

int main(int argc, char **argv) {
  if (argc < 3)
    return 1;
  const std::string folder = argv[1];
  const unsigned int runs = std::atoi(argv[2]), seed = argc > 3 ? std::atoi(argv[3]) : 1;
  std::vector<std::string> texts;
  for (const auto &entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".pcf")
      texts.push_back(text_of(entry.path().string()));
  std::sort(texts.begin(), texts.end());
  const std::string file = "/tmp/random_pcf_" + std::to_string(getpid()) + ".pcf",
                    parameters = file + ".prm";
  frictionbeam::LawLibrary laws;
  laws.load_builtin();
  unsigned int accepted = 0, refused = 0, faults = 0;
  for (unsigned int run = 0; run < runs; ++run) {
    Changes changes(seed * 1000003u + run);
    const std::string text = changes.change(texts[changes.below(texts.size())]);
    std::ofstream(file, std::ios::binary) << text;
    ImportOptions options;
    options.file = file;
    options.support_map = folder + "/supports.txt";
    options.attributes = changes.below(3) == 0 ? "caepipe" : "caesar";
    options.sections.schedule = changes.below(4) == 0 ? "" : "STD";
    bool written = false;
    try {
      const std::string result = prm_text(import_pcf(options), options);
      written = true;
      std::ofstream(parameters) << result;
      if (run % 4 == 0) {
        const frictionbeam::Scene scene = frictionbeam::read_scene(parameters, {}, laws);
        const frictionbeam::LineModel model(scene, laws);
      }
      ++accepted;
    } catch (const frictionbeam::UserError &error) {
      const std::string message = error.what();
      ++refused;
      // What the import lets pass must be good, and a message says what is allowed and what to try.
      if (written || message.find("try:") == std::string::npos) {
        ++faults;
        std::cout << "run " << run << ": " << message << "\n";
        std::filesystem::copy_file(file, "fault_" + std::to_string(run) + ".pcf",
                                   std::filesystem::copy_options::overwrite_existing);
      }
    } catch (const std::exception &error) {
      ++faults;
      std::cout << "run " << run << ": not the user's error: " << error.what() << "\n";
    }
  }
  std::filesystem::remove(file);
  std::filesystem::remove(parameters);
  std::cout << accepted << " taken over, " << refused << " refused, " << faults << " faults\n";
  return faults == 0 && accepted > runs / 20 && refused > runs / 20 ? 0 : 1;
}
