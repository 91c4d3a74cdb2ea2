// SPDX-License-Identifier: LGPL-2.1-or-later
#include "subjects.h"

#include "../small_bar.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <set>
#include <stdexcept>

namespace fs = std::filesystem;

namespace fuzz {

namespace {

const char *const file_name = "fuzzed.prm";

void write(const fs::path &path, const std::string &text) {
  fs::remove(path); // it may be a link
  std::ofstream(path, std::ios::binary) << text;
}

/// Change lengths and numbers of an HDF5 file as bytes: its own checks find less than all.
std::string changed_bytes(const std::string &bytes, Random &random) {
  std::string result = bytes;
  const std::size_t n = 1 + below(random, 4);
  for (std::size_t i = 0; i < n && result.size() > 8; ++i) {
    const std::size_t at = below(random, result.size() - 8);
    const std::uint64_t values[] = {0, 1, ~std::uint64_t(0), random(), 0x7ff8000000000000, 2};
    switch (below(random, 4)) {
    case 0:
      result[at] = static_cast<char>(random());
      break;
    case 1:
      result.replace(at, 8, reinterpret_cast<const char *>(&values[below(random, 6)]), 8);
      break;
    case 2:
      result.replace(at, 4, reinterpret_cast<const char *>(&values[below(random, 6)]), 4);
      break;
    default:
      if (below(random, 8) == 0)
        result.resize(at);
    }
  }
  return result;
}

/// What is refused at once takes little, and has less to tell [ms].
constexpr std::uint64_t least_cost = 20, cost_of_broken = 200;

const std::string law_scene =
    "\nset Law libraries = LIBRARY" + small_bar + R"(subsection Support pad
  set Kind = rest
  set At = B
  set Law = fuzz
end
subsection Load weight
  set Kind = weight
end
subsection Step weigh
  set Loads = weight
end
)";

} // namespace

std::string Input::ending() const {
  return kind == Kind::parameters || kind == Kind::law ? ".prm"
         : kind == Kind::contact                       ? ".hdf5"
         : kind == Kind::checkpoint                    ? ".bin"
                                                       : "_" + beside;
}

Subjects::Subjects(const std::string &project, const std::string &law, const unsigned int seconds)
    : project(project), law(law), seconds(seconds) {
  std::string name = fs::exists("/dev/shm") ? "/dev/shm/fuzz-XXXXXX" : "/tmp/fuzz-XXXXXX";
  if (mkdtemp(name.data()) == nullptr)
    throw std::runtime_error("No temporary folder can be made.");
  place = name;
  read_costs();
  std::set<std::string> found;
  for (const char *const part : {"prm", "tests"})
    for (const auto &entry : fs::recursive_directory_iterator(fs::path(project) / part))
      if (entry.path().extension() == ".prm")
        found.insert(entry.path().parent_path().string());
  for (const std::string &folder : found)
    add_folder(folder);
}

Subjects::~Subjects() {
  std::error_code ignored;
  fs::remove_all(place, ignored);
}

void Subjects::read_costs() {
  std::ifstream file(project + "/tests/fuzz/costs.txt");
  std::uint64_t cost = 0; // [ms]
  for (std::string path; file >> cost >> path;)
    weights[path] =
        1000000 /
        std::max(path.find("broken") == std::string::npos ? least_cost : cost_of_broken, cost);
}

void Subjects::add_folder(const std::string &path) {
  const std::size_t number = folders.size();
  folders.push_back(place + "/" + std::to_string(number));
  fs::create_directory(folders.back());
  std::set<std::string> names;
  for (const auto &entry : fs::directory_iterator(path)) {
    fs::create_symlink(entry.path(), folders.back() / entry.path().filename());
    if (entry.is_regular_file())
      names.insert(entry.path().filename().string());
  }
  for (const std::string &name : names) {
    if (fs::path(name).extension() != ".prm")
      continue;
    const auto weight = weights.find(fs::relative(path + "/" + name, project).string());
    File file = {path + "/" + name,
                 read_file(path + "/" + name),
                 number,
                 {},
                 weight == weights.end() ? 0 : weight->second};
    for (const std::string &other : names)
      if (other != name && file.text.find(other) != std::string::npos)
        file.beside.push_back(other);
    if (file.weight > 0)
      dictionary.add(ParameterText(file.text));
    sum_of_weights += file.weight;
    files.push_back(file);
  }
}

void Subjects::make_contact_problems() {
  const std::string folder = place + "/contact";
  fs::create_directory(folder);
  for (const File &file : files)
    if (fs::path(file.path).filename() == "lift_off.prm" ||
        fs::path(file.path).filename() == "wedge.prm") {
      write(folder + "/" + file_name, file.text);
      Trial trial{{"run", file_name, "--set", "Output/Write contact problems = true"}, folder};
      trial.keep_after = true;
      fuzz::run(trial);
      std::error_code none;
      std::set<std::string> problems;
      for (const auto &entry : fs::directory_iterator(folder + "/results/contact_problems", none))
        if (entry.file_size() < 300000)
          problems.insert(entry.path().string());
      for (const std::string &problem : problems)
        contact_problems.push_back(read_file(problem));
    }
  folders.push_back(folder);
}

void Subjects::make_checkpoint() {
  const std::string folder = place + "/checkpoint";
  fs::create_directory(folder);
  folders.push_back(folder);
  for (const File &file : files)
    if (fs::path(file.path).filename() == "resume.prm") {
      checkpoint_parameters = file.text;
      write(folder + "/" + file_name, file.text);
      Trial trial{{"run", file_name, "--set", "Output/VTU = false"}, folder};
      trial.keep_after = trial.interrupted = true;
      for (int i = 0; i < 8; ++i) { // increments and time steps
        fuzz::run(trial);
        if (!trial.keep_before)
          trial.words.emplace_back("--resume");
        trial.keep_before = true;
      }
      checkpoint_folder = folder + "/saved";
      std::error_code error;
      fs::rename(folder + "/results", checkpoint_folder, error);
      if (!fs::exists(checkpoint_folder + "/unfinished/checkpoint.bin"))
        checkpoint_folder = "";
    }
}

void Subjects::prepare() {
  for (const File &file : files)
    if (fs::path(file.path).filename() == "plant.prm") {
      write(folders[file.folder] + "/" + file_name, file.text);
      warm_up({{"run", file_name}, folders[file.folder]});
    }
  make_contact_problems();
  make_checkpoint();
  std::cout << weights.size() << " parameter files, " << contact_problems.size()
            << " contact problems, " << (checkpoint_folder.empty() ? "no" : "a") << " checkpoint"
            << std::endl;
}

void Subjects::print_costs() {
  for (const File &file : files) {
    write(folders[file.folder] + "/" + file_name, file.text);
    const double passed = fuzz::run({{"run", file_name}, folders[file.folder]}).seconds;
    std::cout << std::lround(1e3 * passed) << ' ' << fs::relative(file.path, project).string()
              << std::endl;
  }
}

const Subjects::File &Subjects::draw_file(Random &random) const {
  std::uint64_t left = below(random, sum_of_weights);
  for (const File &file : files) {
    if (left < file.weight)
      return file;
    left -= file.weight;
  }
  throw std::runtime_error("tests/fuzz/costs.txt names no file of the project.");
}

Input Subjects::draw(const std::uint64_t seed, const std::uint64_t number) const {
  Random random(seed * 1000003 + number);
  const std::size_t what = below(random, 100);
  const File &file = draw_file(random);
  Input input;
  input.origin = file.path;
  input.folder = file.folder;
  input.command = below(random, 8) == 0 ? "check" : "run";
  input.bare = below(random, 10) != 0;
  if (what < 2 && !contact_problems.empty()) {
    input.kind = Input::Kind::contact;
    input.folder = folders.size() - 2;
    input.origin = "a contact problem";
    input.text = changed_bytes(contact_problems[below(random, contact_problems.size())], random);
  } else if (what < 3 && !checkpoint_folder.empty()) {
    input.kind = Input::Kind::checkpoint;
    input.folder = folders.size() - 1;
    input.origin = "a checkpoint";
    input.text = changed_bytes(read_file(checkpoint_folder + "/unfinished/checkpoint.bin"), random);
  } else if (what < 5 && !law.empty()) {
    input.kind = Input::Kind::law;
    input.origin = "a law";
    input.law = 1 + number;
    input.text = law_scene;
    input.text.replace(input.text.find("LIBRARY"), 7, law);
    input.command = "run";
  } else if (what < 25 && !file.beside.empty()) {
    input.kind = Input::Kind::beside;
    input.beside = file.beside[below(random, file.beside.size())];
    input.parameters = file.text;
    input.text = changed_text(read_file(folders[file.folder] + "/" + input.beside), random);
  } else if (what < 30)
    input.text = changed_text(file.text, random);
  else {
    ParameterText text(file.text);
    dictionary.change(text, random);
    input.text = text.text();
  }
  return input;
}

std::size_t Subjects::folder_of(const std::string &folder) const {
  for (const File &file : files)
    if (fs::equivalent(fs::path(file.path).parent_path(), folder))
      return file.folder;
  return 0;
}

Outcome Subjects::run(const Input &input) {
  const std::string &folder = folders[input.folder];
  Trial trial{{input.command, file_name}, folder, seconds};
  if (input.kind == Input::Kind::contact) {
    write(folder + "/problem.hdf5", input.text);
    trial.words = {"contact", "problem.hdf5"};
    return fuzz::run(trial);
  }
  if (input.kind == Input::Kind::checkpoint) {
    fs::remove_all(folder + "/results");
    fs::copy(checkpoint_folder, folder + "/results", fs::copy_options::recursive);
    write(folder + "/results/unfinished/checkpoint.bin", input.text);
    write(folder + "/" + file_name, checkpoint_parameters);
    trial.words = {"run", file_name, "--set", "Output/VTU = false", "--resume"};
    trial.keep_before = true;
    return fuzz::run(trial);
  }
  if (input.bare)
    for (const char *const output : {"VTU", "Report"})
      trial.words.insert(trial.words.end(),
                         {"--set", std::string("Output/") + output + " = false"});
  setenv("FUZZ_LAW", std::to_string(input.law).c_str(), 1);
  if (input.kind != Input::Kind::beside) {
    write(folder + "/" + file_name, input.text);
    return fuzz::run(trial);
  }
  const fs::path beside = folder + "/" + input.beside, original = fs::read_symlink(beside);
  write(folder + "/" + file_name, input.parameters);
  write(beside, input.text);
  const Outcome outcome = fuzz::run(trial);
  fs::remove(beside);
  fs::create_symlink(original, beside);
  return outcome;
}

} // namespace fuzz
