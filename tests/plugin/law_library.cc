// LawLibrary shall load laws by file and find them by name, and refuse each of the broken ones of
// broken_law.cc, saying what was found, what was expected and what to try.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/law_closed_form.h>
#include <frictionbeam/law_library.h>

#include "../check.h"

#include <filesystem>
#include <fstream>
#include <functional>
#include <stdexcept>

using namespace frictionbeam;

namespace {

std::string folder; ///< of the broken laws

void refused(const std::function<void()> &action, const std::vector<std::string> &words) {
  std::string message;
  try {
    action();
  } catch (const std::runtime_error &error) {
    message = error.what();
  }
  for (const std::string &word : words)
    if (message.find(word) == std::string::npos) {
      std::cerr << "no '" << word << "' in '" << message << "'\n";
      CHECK(false);
    } else
      CHECK(true);
}

void broken(const std::string &fault, std::vector<std::string> words) {
  LawLibrary library;
  library.load_builtin();
  const std::string file = folder + "/broken_" + fault + ".so";
  words.push_back("The law library '" + file + "' cannot be used");
  refused([&] { library.load(file); }, words);
  CHECK(library.names(LawKind::support).size() == 4);
}

void broken_laws() {
  const std::string version = std::to_string(law_interface_version),
                    other_version = std::to_string(law_interface_version + 1);
  broken("SYMBOL_MISSING", {"does not export the object 'frictionbeam_law'", "extern \"C\""});
  broken("VERSION_WRONG", {"version " + other_version, "this program has version " + version,
                           "from 1 on", "Compile it again"});
  broken("KIND_WRONG", {"kind is 5", "expected 0 (support) or 1 (section)"});
  broken("STRAINS_WRONG", {"3 strains", "has 4", "Set LawDescription::n_strains"});
  broken("STATES_WRONG", {"-2 internal variables", "expected 0 to 4000"});
  broken("LAW_MISSING", {"no law object", "constant object"});
  broken("LIST_MISSING", {"1 parameters without a list"});
  broken("LIST_TOO_LONG", {"announces 2000000000 parameters", "expected 0 to 1000"});
  broken("NAME_MISSING", {"no name", "Set LawDescription::name"});
  broken("NAME_TAKEN", {"'coulomb'", "already loaded from '" + LawLibrary::builtin_directory(),
                        "name of its own"});
  broken("PLACE_OUTSIDE", {"place slip_z outside of the state, which has 4 internal variables, "
                           "read 77",
                           "set n_internal_variables"});
  broken("SECTION_THRESHOLD", {"a closed form, and is a law of sections", "threshold to null"});
  broken("UNIT_MISSING", {"parameter 'Stiffness'", "a unit", "'-' if it has no unit"});
  broken("DEFAULT_OUT_OF_BOUNDS", {"default 3", "'Stiffness'", "bounds 0", "to 2"});
  broken("PARAMETER_TWICE", {"two parameters called 'Stiffness'", "name of its own"});
  broken("REFERENCE_MISSING", {"'taken'", "no reference", "Say where it is from"});
}

void files_that_are_no_libraries() {
  LawLibrary library;
  refused([&] { library.load("no/such/law.so"); },
          {"'no/such/law.so'", "does not open", "No such file", "frictionbeam_add_law()"});
  std::ofstream("not_a_library.so") << "plain text\n";
  refused([&] { library.load("not_a_library.so"); },
          {"'not_a_library.so'", "does not open", "Expected a shared library"});
  std::filesystem::remove("not_a_library.so");
}

/// A law that was compiled for version 1 of the interface goes on being what it is.
void older_law() {
  LawLibrary library;
  const LawDescription &law = library.load(folder + "/broken_VERSION_ONE.so");
  CHECK(law.interface_version == 1);
  const FrictionThreshold form = closed_form_at_rest(law, {0.7});
  CHECK(form.static_friction == 0.7 && form.dynamic_friction == 0.7);
  CHECK(form.was_slipping == 3 && !form.varies);
}

class Nothing final : public LawBase {
  LawStatus integrate(const LawInput &, LawOutput &) const noexcept override {
    return LawStatus::failed;
  }
};

/// A law that is linked in passes the same door.
void linked_in() {
  static const Nothing nothing;
  LawDescription law = {law_interface_version,
                        LawKind::support,
                        n_support_strains,
                        0,
                        true,
                        "linked",
                        "a test",
                        0,
                        nullptr,
                        &nothing,
                        nullptr};
  LawLibrary library;
  CHECK(&library.add(law) == &law);
  CHECK(&library.add(law) == &law); // again: the same
  CHECK(&library.find("linked") == &law);
  CHECK(library.names(LawKind::support) == std::vector<std::string>{"linked"});
  LawDescription other = law;
  refused([&] { library.add(other); }, {"The law 'linked' that is linked in cannot be used",
                                        "the one already linked in", "name of its own"});
  other.name = "coulomb";
  library.load_builtin();
  refused([&] { library.add(other); }, {"already loaded from '"});
  other.name = "other";
  other.reference = "";
  refused([&] { library.add(other); }, {"The law 'other' that is linked in", "no reference"});
  law.name = nullptr;
  refused([&] { LawLibrary().add(law); }, {"The law '' that is linked in", "no name"});
}

void loading_and_finding() {
  LawLibrary library;
  CHECK(library.names(LawKind::support).empty());
  library.load_builtin();
  CHECK(library.names(LawKind::support) ==
        (std::vector<std::string>{"coulomb", "skeleton", "snubber", "whip_restraint"}));
  CHECK(library.names(LawKind::section) ==
        (std::vector<std::string>{"elastic_section", "fibre_pipe", "fibre_rectangle",
                                  "global_plastic", "ovalising_pipe"}));
  const LawDescription *const coulomb = &library.find("coulomb");
  library.load_builtin(); // again: the same laws
  CHECK(coulomb == &library.find("coulomb"));
  refused([&] { library.find("colomb"); },
          {"no law called 'colomb'", "Loaded are: coulomb, elastic_section, fibre_pipe, "
                                     "fibre_rectangle, global_plastic, ovalising_pipe"});

  // By a name without a folder, from where the program runs.
  const auto start = std::filesystem::current_path();
  std::filesystem::current_path(folder);
  const LawDescription &law = library.load("broken_NOTHING.so");
  std::filesystem::current_path(start);
  CHECK(&law == &library.find("taken"));
  CHECK(default_parameters(law) == std::vector<double>{1.});
  CHECK(parameter_index(law, "Stiffness") == 0);
  CHECK(parameter_index(library.find("coulomb"), "Gap") == 5);
  refused([&] { parameter_index(law, "stiffness"); },
          {"'taken' has no parameter 'stiffness'", "It has: Stiffness"});
}

} // namespace

int main(int, char **argv) {
  folder = argv[1];
  broken_laws();
  files_that_are_no_libraries();
  older_law();
  linked_in();
  loading_and_finding();
  return check::report();
}
