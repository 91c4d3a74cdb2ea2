// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/file/contact_problem_writer.h"

#include "results/file/fclib_file.h"
#include "results/file/output_file.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iomanip>
#include <sstream>

namespace frictionbeam {

namespace {

std::string file_name(const unsigned int step, const std::string &name,
                      const unsigned int increment) {
  std::string plain = name;
  for (char &c : plain)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-')
      c = '_';
  std::ostringstream out;
  out << std::setfill('0') << std::setw(2) << step << '_' << plain << '_' << std::setw(4)
      << increment;
  return out.str();
}

constexpr const char *common_description =
    "u: gap, then the two slips of the increment [m]; r: forces on the pipe along the normal into "
    "it, and against those slips [N]; contacts in the order of supports.csv.";

} // namespace

ContactProblemWriter::ContactProblemWriter(const Model &model, Results &results, const bool keep)
    : model(model), results(results), folder(model.scene.output.directory + "/contact_problems") {
  prepare_output_folder(folder);
  if (keep)
    return;
  std::vector<std::filesystem::path> old;
  for (const auto &entry : std::filesystem::directory_iterator(folder))
    if (entry.is_regular_file() && entry.path().extension() == ".hdf5")
      old.push_back(entry.path());
  for (const auto &path : old)
    std::filesystem::remove(path);
}

void ContactProblemWriter::observe(const Progress &progress, const LineState &state) {
  const bool is_start = progress.increment == 0; // of the run, or of a step that goes back
  if (!is_start && model.scene.steps[progress.step].transient)
    remark("Contact problems are written of static steps only.");
  else if (!is_start)
    write(progress, state);
  before = state;
}

void ContactProblemWriter::write(const Progress &progress, const LineState &after) {
  const GlobalContactProblem global = global_contact_problem(model, before, after);
  if (!global.obstacle.empty())
    return remark("Contact problems are not written: " + global.obstacle + '.');
  const std::string &step = model.scene.steps[progress.step].name;
  const std::string path = folder + '/' + file_name(progress.step + 1, step, progress.increment);
  const std::string title =
      model.scene.name + ", step " + step + ", increment " + std::to_string(progress.increment);
  write_global_contact_problem(path + "_global.hdf5", global, title,
                               std::string("M, f: stiffness of the line without contacts and its "
                                           "loads; v: its displacements and rotations. ") +
                                   common_description);
  if (const auto local = condense(global))
    write_local_contact_problem(path + ".hdf5", *local, global.reactions, title,
                                common_description);
  else
    remark("Without its contacts the line can move freely, or so nearly that W = H^T K^-1 H would "
           "have no right digit: contact problems are written in the global form only.");
}

void ContactProblemWriter::remark(const std::string &text) {
  if (std::count(results.remarks.begin(), results.remarks.end(), text) == 0)
    results.remarks.push_back(text);
}

} // namespace frictionbeam
