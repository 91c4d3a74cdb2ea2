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

  std::string ending() const;
  std::string words() const { return command + (law > 0 ? " law " + std::to_string(law) : ""); }
};

/// All files of the project that the program reads, and a place to run them, changed.
class Subjects {
public:
  Subjects(const std::string &project, const std::string &law);
  ~Subjects();

  /// Run all parameter files as they are; those that take long will only be looked at by 'check'.
  /// @return how many have a fault
  unsigned int measure();
  /// The input of run @p number, which depends on nothing else but @p seed.
  Input draw(const std::uint64_t seed, const std::uint64_t number) const;
  Outcome run(const Input &input);

private:
  struct File {
    std::string path, text;
    std::size_t folder;
    std::vector<std::string> beside; ///< files of its folder that it names
    bool slow = false;
  };
  void add_folder(const std::string &path);
  void make_contact_problems();
  void make_checkpoint();

  std::string place; ///< a folder in memory
  std::string law;   ///< library
  std::vector<std::string> folders;
  std::vector<File> files;
  std::vector<std::string> contact_problems; ///< bytes
  std::string checkpoint_parameters, checkpoint_folder;
  Dictionary dictionary;
};

} // namespace fuzz
