// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/file/checkpoint.h"

#include "base/user_error.h"
#include "results/file/output_file.h"
#include "results/file/summary.h"

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace frictionbeam {

namespace {

/// A file begins with this, the number of its layout, and the end of the line.
constexpr const char *first_words = "FrictionBeam checkpoint ";
constexpr const char *advice =
    "\n  try:     the run without --resume, from its beginning, or another --output-directory";

std::string file_in(const std::string &folder) { return folder + "/checkpoint.bin"; }

/// Fowler, Noll and Vo's hash FNV-1a of 64 bits, by eight bytes at a time: bytes one by one take
/// eight times as long, of which a long line has some hundred million. A product carries bits
/// upwards only; so its upper half is mixed into the lower one.
class Hash {
public:
  void add(const void *const bytes, const std::size_t size) {
    const auto *const begin = static_cast<const char *>(bytes);
    const std::size_t n_in_words = size / sizeof(value) * sizeof(value);
    for (std::size_t i = 0; i < n_in_words; i += sizeof(value))
      take(begin + i, sizeof(value));
    if (n_in_words < size)
      take(begin + n_in_words, size - n_in_words);
  }
  template <typename Numbers>
  void add_numbers(const Numbers &numbers) {
    add(numbers.data(), numbers.size() * sizeof(*numbers.data()));
  }
  void add(const SparseMatrix &matrix) {
    add(matrix.valuePtr(), matrix.nonZeros() * sizeof(double));
  }
  void add(const TimeFunction &function) {
    add_numbers(function.breaks);
    for (const double t : function.breaks)
      add_number(function(t));
  }
  void add_number(const double number) { add(&number, sizeof(number)); }
  template <int dim>
  void add(const dealii::Point<dim> &point) {
    for (unsigned int d = 0; d < dim; ++d)
      add_number(point[d]);
  }

  std::string text() const {
    std::ostringstream out;
    out << std::hex << value;
    return out.str();
  }

private:
  void take(const char *const bytes, const std::size_t size) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes, size);
    value = (value ^ word) * 1099511628211u;
    value ^= value >> 32;
  }

  std::uint64_t value = 14695981039346656037u;
};

/// Of the numbers that files beside the parameter file have a part in: mesh, tables, laws.
std::string hash_of_model(const Model &model) {
  Hash hash;
  hash.add(model.linear.stiffness());
  hash.add(model.linear.mass());
  hash.add(model.linear.damping());
  for (unsigned int l = 0; l < model.scene.loads.size(); ++l) {
    hash.add_numbers(model.linear.forces(l));
    hash.add(model.scene.loads[l].history);
  }
  for (const FrictionSupport &support : model.scene.supports)
    for (const TimeFunction &motion : support.ground_motion)
      hash.add(motion);
  for (unsigned int i = 0; i < model.contacts.size(); ++i) {
    const Contact &contact = model.contacts[i];
    hash.add_numbers(contact.law.name());
    hash.add_numbers(contact.law.parameters());
    hash.add_numbers(contact.B.reshaped().eval());
    hash.add_number(contact.weight);
  }
  return hash.text();
}

template <int dim>
std::string hash_of_mesh(const ContinuumMesh<dim> &mesh) {
  Hash hash;
  for (const dealii::Point<dim> &vertex : mesh.vertices)
    hash.add(vertex);
  for (const dealii::CellData<dim> &cell : mesh.cells)
    hash.add_numbers(cell.vertices);
  for (const typename ContinuumMesh<dim>::Face &face : mesh.faces) {
    hash.add_numbers(face.vertices);
    hash.add_number(face.part);
  }
  for (const auto &[name, point] : mesh.points) {
    hash.add_numbers(name);
    hash.add(point);
  }
  return hash.text();
}

std::string flavour() {
#ifdef DEBUG
  return "debug";
#else
  return "release";
#endif
}

} // namespace

void transfer(Archive &archive, Point3 &point) { archive(point[0], point[1], point[2]); }
void transfer(Archive &archive, Vector3 &vector) { archive(vector[0], vector[1], vector[2]); }

void transfer(Archive &archive, Station &station) {
  archive(station.pipe, station.vertex, station.s, station.position, station.displacement,
          station.force, station.y, station.z, station.y_now, station.z_now, station.pressure,
          station.part, station.bend_radius, station.bend_axis);
}

void transfer(Archive &archive, Frame &frame) {
  archive(frame.name, frame.step, frame.step_before, frame.increment, frame.time, frame.end_of_step,
          frame.line, frame.supports, frame.reactions, frame.together, frame.sections);
}

void transfer(Archive &archive, History &history) {
  archive(history.point, history.time, history.displacement);
}

void transfer(Archive &archive, StressEnvelope &envelope) {
  archive(envelope.from, envelope.stress, envelope.time, envelope.force);
}

void transfer(Archive &archive, StepEnvelope &envelope) {
  archive(envelope.step, envelope.start, envelope.end, envelope.n_instants,
          envelope.n_line_instants, envelope.is_of_whole_motion, envelope.supports,
          envelope.restraints, envelope.points, envelope.sum_normal, envelope.sum_friction,
          envelope.displacement, envelope.displaced_most, envelope.least, envelope.largest,
          envelope.least_at, envelope.largest_at, envelope.stresses, envelope.nozzles,
          envelope.least_frame, envelope.largest_frame);
}

Checkpoint::Checkpoint(const Scene &scene, const std::string &hash)
    : interval(scene.output.checkpoint_interval), path(file_in(scene.output.directory)),
      last(std::chrono::steady_clock::now()) {
  std::string options;
  for (const std::string &option : scene.overrides)
    if (option.find("Checkpoint interval") == std::string::npos)
      options += option + '\n';
  identity = {{"program", program_version() + ", " + flavour() + ", deal.II " + deal_ii_version()},
              {"parameter file", scene.input},
              {"options --set", options},
              {"model (its mesh, tables and laws)", hash}};
}

Checkpoint::Checkpoint(const Model &model) : Checkpoint(model.scene, hash_of_model(model)) {}

template <int dim>
Checkpoint::Checkpoint(const ContinuumBody<dim> &body)
    : Checkpoint(body.scene, hash_of_mesh(body.mesh)) {
  identity.emplace_back("number of processes", std::to_string(n_processes(body.communicator)));
}

template Checkpoint::Checkpoint(const ContinuumBody<2> &);
template Checkpoint::Checkpoint(const ContinuumBody<3> &);

bool Checkpoint::is_due() const {
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - last;
  return interval > 0. && passed.count() >= interval;
}

void Checkpoint::write(const Archive &archive) {
  Hash hash;
  hash.add_numbers(archive.bytes());
  // As an archive of the identity, the content and the sum is, but without a copy of the content,
  // which of long lines is most of what the program holds.
  const std::string &content = archive.bytes();
  std::string sum = hash.text();
  std::size_t size = content.size();
  Archive before, behind;
  before(identity, size);
  behind(sum);
  const std::string layout = std::to_string(checkpoint_layout) + '\n';
  replace_file(path, {first_words, layout, before.bytes(), content, behind.bytes()});
  last = std::chrono::steady_clock::now();
}

void Checkpoint::check(const Identity &found) const {
  for (unsigned int i = 0; i < identity.size(); ++i)
    if (i >= found.size() || found[i] != identity[i]) {
      const std::string there = i < found.size() ? found[i].second : "nothing";
      const bool is_short = there.size() + identity[i].second.size() < 200;
      throw UserError(
          "The checkpoint " + path + " is of another case: its " + identity[i].first +
          " is not that of this run.\n  read:    " +
          (is_short ? there + "; this run: " + identity[i].second : "another text") +
          "\n  allowed: --resume with the program, parameter file and options that wrote it" +
          advice);
    }
}

std::optional<Archive> Checkpoint::read() const {
  if (!std::filesystem::exists(path))
    return std::nullopt;
  const auto damaged = [&]() {
    return UserError("The checkpoint " + path +
                     " cannot be used.\n  read:    a file that is not "
                     "whole or not a checkpoint of this format\n  allowed: the file as a run wrote "
                     "it" +
                     advice);
  };
  std::ifstream in(path, std::ios::binary);
  std::string start(std::strlen(first_words), ' '), layout;
  in.read(start.data(), start.size());
  if (start != first_words || !std::getline(in, layout) || layout.size() > 9)
    throw damaged();
  if (layout != std::to_string(checkpoint_layout))
    throw UserError("The checkpoint " + path +
                    " was written by another build of the program, with another layout.\n  read:  "
                    "  layout " +
                    layout + "\n  allowed: layout " + std::to_string(checkpoint_layout) +
                    ", which this build reads and writes" + advice +
                    ", or --resume with the build that wrote it");
  const std::streamoff begin = in.tellg();
  in.seekg(0, std::ios::end);
  std::string text(in.tellg() - begin, ' ');
  in.seekg(begin);
  if (!in.read(text.data(), text.size()))
    throw damaged();
  Identity found;
  std::string content, sum;
  try {
    Archive file(std::move(text));
    file(found, content, sum);
  } catch (const dealii::ExceptionBase &) {
    throw damaged();
  }
  Hash hash;
  hash.add_numbers(content);
  if (hash.text() != sum)
    throw damaged();
  check(found);
  return Archive(std::move(content));
}

bool Checkpoint::is_in(const std::string &folder) {
  return std::filesystem::exists(file_in(folder));
}

void Checkpoint::remove(const std::string &folder) {
  std::error_code ignored;
  std::filesystem::remove(file_in(folder), ignored);
  std::filesystem::remove(file_beside(file_in(folder)), ignored); // of a run killed as it wrote it
}

} // namespace frictionbeam
