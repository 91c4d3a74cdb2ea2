// SPDX-License-Identifier: LGPL-2.1-or-later
// Whatever bytes a reader is given, it shall return what it read or throw what the program tells
// the user; anything else that it throws, and every wrong address, ends the process. Run by
// libFuzzer, see readers.sh:
//   fuzz_readers parameters|history|mesh|geometry|checkpoint|contacts|law CORPUS...
#include "base/user_error.h"
#include "mesh/line_mesh.h"
#include "results/file/fclib_file.h"
#include "results/file/output_file.h"
#include "results/results.h"
#include "scene/read_scene.h"
#include <frictionbeam/law_library.h>

#include <dlfcn.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>

using namespace frictionbeam;

namespace {

const std::string folder = "/dev/shm/fuzz_readers_" + std::to_string(getpid());

const char *const scene_of_one_pipe = R"(
subsection Material steel
end
subsection Section round
  set Outer diameter = 0.1
  set Wall = 0.005
end
subsection Pipe main
  ROUTE
end
subsection Support anchor
  set Kind = anchor
  set At = A
end
subsection Load push
  set Kind = force
  set Forces = A 1 0 0
  HISTORY
end
subsection Step push
  set Loads = push
end
subsection Mesh
  MESH
  set Most cells = 1000
end
)";

std::string write(const std::string &name, const std::string &bytes) {
  const std::string path = folder + "/" + name;
  std::ofstream(path, std::ios::binary) << bytes;
  return path;
}

LawLibrary &laws() {
  static LawLibrary library;
  return library;
}

/// Read a scene in which the file @p name stands for @p place.
Scene scene_with(const std::string &place, const std::string &line) {
  std::string text = scene_of_one_pipe;
  const std::map<std::string, std::string> lines = {
      {"ROUTE", place == "MESH" ? "" : "set Route = A 0 0 0; B 4 0 0"},
      {"HISTORY", place == "HISTORY" ? line : ""},
      {"MESH", place == "MESH" ? line : ""}};
  for (const auto &[word, put] : lines)
    text.replace(text.find(word), word.size(), put);
  return read_scene(write("scene.prm", text), {}, laws());
}

void read_mesh(const std::string &name, const std::string &bytes) {
  write(name, bytes);
  build_line_mesh(scene_with("MESH", "set File = " + name));
}

/// As Checkpoint::read(), and then what its content would be read into.
void read_checkpoint(const std::string &bytes) {
  try {
    std::vector<std::pair<std::string, std::string>> identity;
    std::string content, check;
    Archive file(bytes);
    file(identity, content, check);
    std::vector<Frame> frames;
    std::vector<History> histories;
    std::vector<StepEnvelope> envelopes;
    Archive inner(content);
    inner(frames, histories, envelopes);
  } catch (const dealii::ExceptionBase &) { // which Checkpoint takes for damage
  }
}

/// The law in law_of_bytes.cc says of itself what the bytes say.
void read_law(const std::string &bytes) {
  static const std::string path =
      std::filesystem::path(LawLibrary::builtin_directory()).replace_filename("law_of_bytes.so");
  static void *const handle = dlopen(path.c_str(), RTLD_NOW);
  if (handle == nullptr)
    throw UserError(dlerror());
  const auto describe =
      reinterpret_cast<void (*)(const char *, unsigned long)>(dlsym(handle, "describe"));
  describe(bytes.data(), bytes.size());
  LawLibrary library;
  try {
    const LawDescription &law = library.load(path);
    default_parameters(law);
  } catch (const std::runtime_error &) { // which the scene makes a UserError of
  }
}

void read_contacts(const std::string &bytes) {
  const std::string path = write("problem.hdf5", bytes);
  read_contact_reactions(path, n_components(read_contact_problem(path)));
}

const std::map<std::string, std::function<void(const std::string &)>> readers = {
    {"parameters",
     [](const std::string &bytes) { read_scene(write("scene.prm", bytes), {}, laws()); }},
    {"history",
     [](const std::string &bytes) {
       write("table.csv", bytes);
       const Scene scene = scene_with("HISTORY", "set History = file table.csv");
       for (const double t : {-1., 0., 0.5, 1e9})
         scene.loads[0].history(t);
     }},
    {"mesh", [](const std::string &bytes) { read_mesh("mesh.msh", bytes); }},
    {"geometry", [](const std::string &bytes) { read_mesh("mesh.geo", bytes); }},
    {"checkpoint", read_checkpoint},
    {"contacts", read_contacts},
    {"law", read_law}};

std::string chosen;

} // namespace

extern "C" int LLVMFuzzerInitialize(int *argc, char ***argv) {
  if (*argc < 2 || readers.count((*argv)[1]) == 0) {
    std::cerr << "Which reader?\n";
    _exit(2);
  }
  chosen = (*argv)[1];
  (*argv)[1] = (*argv)[0];
  ++*argv;
  --*argc;
  if (std::system(("mkdir -p " + folder).c_str()) != 0)
    _exit(2);
  laws().load_builtin();
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, unsigned long size) {
  try {
    readers.at(chosen)(std::string(reinterpret_cast<const char *>(data), size));
  } catch (const UserError &) {
  } catch (const OutputError &) {
  }
  return 0;
}
