// SPDX-License-Identifier: LGPL-2.1-or-later
#include "command/import_command.h"

#include "base/user_error.h"
#include "model/line_model.h"
#include "results/file/output_file.h"
#include "scene/read_scene.h"

#include <filesystem>
#include <iostream>

namespace frictionbeam {

namespace {

void list_notes(const std::string &heading, const std::vector<import::Notes::Note> &notes) {
  if (notes.empty())
    return;
  std::cerr << heading << " (" << notes.size() << "):\n";
  for (const import::Notes::Note &note : notes)
    std::cerr << "  " << (note.line > 0 ? "line " + std::to_string(note.line) + ": " : "")
              << note.text << '\n';
}

std::string output_of(const import::ImportOptions &options) {
  const std::string output =
      !options.output.empty()
          ? options.output
          : std::filesystem::path(options.file).filename().replace_extension(".prm").string();
  std::error_code none;
  if (!options.overwrite && std::filesystem::exists(output, none))
    throw UserError("import\n  read:    " + output +
                    ", which is there already\n  allowed: a new file, so that what was changed by "
                    "hand is not lost\n  try:     -o with another name, or --overwrite");
  return output;
}

/// What a run would do before it solves.
void check_written(const std::string &file) {
  LawLibrary laws;
  laws.load_builtin();
  try {
    const Scene scene = read_scene(file, {}, laws);
    const LineModel model(scene, laws);
  } catch (const UserError &error) {
    throw UserError(std::string("The parameter file that import has written is not accepted: look "
                                "at its rows, and at the entries of --support-map.\n") +
                    error.what());
  }
}

} // namespace

int import_file(const import::ImportOptions &options) {
  const std::string output = output_of(options);
  const import::ImportedLine line = import::import_pcf(options);
  write_file(output, import::prm_text(line, options));
  list_notes("Not understood", line.notes.not_understood);
  list_notes("Assumed", line.notes.assumed);
  list_notes("Moved", line.notes.moved);
  check_written(output);
  std::size_t n_without_effect = 0;
  for (const auto &[word, count] : line.notes.without_effect)
    n_without_effect += count.n;
  std::size_t n_supports = 0;
  for (const import::PlannedSupport &support : line.plan.supports)
    n_supports += support.support ? 1 : 0;
  std::cout << output << ": " << line.plan.pipes.size() << " pipes of " << line.n_components
            << " components, " << n_supports << " supports, " << line.plan.tees.size()
            << " branches; " << line.notes.not_understood.size() << " not understood, "
            << line.notes.assumed.size() << " assumed, " << line.notes.moved.size() << " moved, "
            << n_without_effect << " words without effect. The file lists them.\n";
  return 0;
}

} // namespace frictionbeam
