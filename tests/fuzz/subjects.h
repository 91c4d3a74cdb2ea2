// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "parameter_text.h"
#include "trial.h"

#include <cstdint>

namespace fuzz {

/// One input of the program.
struct Input {
  enum class Kind { parameters, beside, contact, checkpoint, law } kind = Kind::parameters;
  std::string text;       ///< of the file that was changed
  std::string origin;     ///< the file before, and what else is to be known
  std::size_t folder = 0; ///< of Subjects
  std::string beside;     ///< name of the changed file, if it is not the parameter file
  std::string parameters; ///< then: the parameter file's text
  std::uint64_t law = 0;  ///< number of its description
  std::string command = "run";
  bool bare = false; ///< without files for ParaView and report.html

  std::string ending() const;
  std::string words() const {
    return command + (bare ? " bare" : "") + (law > 0 ? " law " + std::to_string(law) : "");
  }
};

/// The files of the project that the program reads, and a place to run them, changed.
class Subjects {
public:
  /// Files are those that tests/fuzz/costs.txt names, drawn the more rarely the longer they take
  /// there: what a run draws depends on neither the computer nor on files that are new.
  /// @param seconds of computing that a run may take
  Subjects(const std::string &project, const std::string &law, const unsigned int seconds);
  ~Subjects();

  /// Make contact problems and a checkpoint to be changed.
  void prepare();
  /// Run all parameter files of the project as they are, and print the text of costs.txt.
  void print_costs();
  /// The input of run @p number, which depends on nothing else but @p seed.
  Input draw(const std::uint64_t seed, const std::uint64_t number) const;
  Outcome run(const Input &input);
  /// Where the files of @p folder find those that they name; the first one if it is not of the
  /// project.
  std::size_t folder_of(const std::string &folder) const;

private:
  struct File {
    std::string path, text;
    std::size_t folder;
    std::vector<std::string> beside; ///< files of its folder that it names
    std::uint64_t weight;            ///< in drawing
  };
  void read_costs();
  void add_folder(const std::string &path);
  const File &draw_file(Random &random) const;
  void make_contact_problems();
  void make_checkpoint();

  const std::string project;
  std::map<std::string, std::uint64_t> weights; ///< of files, by their path in the project
  std::uint64_t sum_of_weights = 0;
  std::string place; ///< a folder in memory
  std::string law;   ///< library
  const unsigned int seconds;
  std::vector<std::string> folders;
  std::vector<File> files;
  std::vector<std::string> contact_problems; ///< bytes
  std::string checkpoint_parameters, checkpoint_folder;
  Dictionary dictionary;
};

} // namespace fuzz
