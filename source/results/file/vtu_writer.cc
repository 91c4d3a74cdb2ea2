// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/file/vtu_writer.h"
#include "results/file/output_file.h"
#include "results/support_force.h"
#include "results/text.h"

#include <deal.II/base/data_out_base.h>
#include <deal.II/numerics/data_component_interpretation.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <sstream>

namespace frictionbeam {

using namespace dealii;

namespace {

/// Patches made elsewhere, with a list of what their data mean.
template <int dim>
class PatchesOut : public DataOutInterface<dim, 3> {
public:
  using Patch = DataOutBase::Patch<dim, 3>;

  void add_vector(const std::string &name) {
    const auto first = static_cast<unsigned int>(names.size());
    ranges.emplace_back(first, first + 2, name,
                        DataComponentInterpretation::component_is_part_of_vector);
    names.insert(names.end(), 3, name);
  }

  void add_scalar(const std::string &name) { names.push_back(name); }

  unsigned int n_datasets() const { return names.size(); }

  std::vector<Patch> patches;

protected:
  const std::vector<Patch> &get_patches() const override { return patches; }
  std::vector<std::string> get_dataset_names() const override { return names; }
  std::vector<std::tuple<unsigned int, unsigned int, std::string,
                         DataComponentInterpretation::DataComponentInterpretation>>
  get_nonscalar_data_ranges() const override {
    return ranges;
  }

private:
  std::vector<std::string> names;
  std::vector<std::tuple<unsigned int, unsigned int, std::string,
                         DataComponentInterpretation::DataComponentInterpretation>>
      ranges;
};

template <int dim>
void write(PatchesOut<dim> &out, const double time, const std::string &path) {
  DataOutBase::VtkFlags flags;
  flags.time = time;
  flags.print_date_and_time = false;
#if DEAL_II_VERSION_GTE(9, 6, 0)
  flags.compression_level = DataOutBase::CompressionLevel::best_speed;
#else
  flags.compression_level = DataOutBase::VtkFlags::best_speed;
#endif
  out.set_flags(flags);
  std::ostringstream text; // deal.II has words of its own for a stream that fails
  out.write_vtu(text);
  write_file(path, text.str());
}

/// Data at one end of the cell between two stations.
void fill(const Station &station, const unsigned int column, Table<2, float> &data) {
  unsigned int row = 0;
  for (const double value : station.displacement)
    data(row++, column) = value;
  for (const double value : station.force)
    data(row++, column) = value;
  data(row++, column) = station.s;
  data(row++, column) = station.pipe;
}

void write_line(const Frame &frame, const std::string &path) {
  PatchesOut<1> out;
  out.add_vector("displacement");
  out.add_vector("rotation");
  for (const char *name : {"N", "Vy", "Vz", "Mx", "My", "Mz", "s", "pipe"})
    out.add_scalar(name);
  for (std::size_t i = 1; i < frame.line.size(); ++i) {
    const Station &begin = frame.line[i - 1], &end = frame.line[i];
    if (begin.pipe != end.pipe || begin.position.distance(end.position) == 0.)
      continue;
    PatchesOut<1>::Patch patch;
    patch.vertices[0] = begin.position;
    patch.vertices[1] = end.position;
    patch.patch_index = out.patches.size();
    patch.n_subdivisions = 1;
    patch.reference_cell = ReferenceCells::Line;
    patch.data.reinit(out.n_datasets(), 2);
    fill(begin, 0, patch.data);
    fill(end, 1, patch.data);
    out.patches.push_back(patch);
  }
  write(out, frame.time, path);
}

void write_supports(const std::vector<SupportInfo> &infos, const Frame &frame,
                    const std::string &path) {
  AssertDimension(frame.supports.size(), infos.size());
  PatchesOut<0> out;
  out.add_vector("force");
  out.add_vector("slip");
  for (const char *name : {"status", "fn", "friction", "gap", "work_friction"})
    out.add_scalar(name);
  for (unsigned int i = 0; i < infos.size(); ++i) {
    const SupportInfo &info = infos[i];
    const SupportState &state = frame.supports[i];
    Vector3 force = force_in_space(state), slip = state.slip1 * info.t1 + state.slip2 * info.t2;
    if (frame.is_amplitude) // sizes along axes cannot be turned
      for (unsigned int d = 0; d < 3; ++d)
        force[d] = slip[d] = std::numeric_limits<double>::quiet_NaN();
    PatchesOut<0>::Patch patch;
    patch.vertices[0] = info.position;
    patch.patch_index = i;
    patch.data.reinit(out.n_datasets(), 1);
    unsigned int row = 0;
    for (unsigned int d = 0; d < 3; ++d)
      patch.data(row++, 0) = force[d];
    for (unsigned int d = 0; d < 3; ++d)
      patch.data(row++, 0) = slip[d];
    for (const double value : {static_cast<double>(state.status), state.fn, friction_force(state),
                               state.gap, state.work_friction})
      patch.data(row++, 0) = value;
    out.patches.push_back(patch);
  }
  write(out, frame.time, path);
}

/// End of a file's name.
std::string numbered(const std::size_t number) {
  char text[16];
  std::snprintf(text, sizeof(text), "%04zu", number);
  return text + std::string(".vtu");
}

void write_pvd(const std::vector<std::pair<double, std::string>> &frames, const std::string &path) {
  std::ostringstream text;
  DataOutBase::write_pvd_record(text, frames);
  write_file(path, text.str());
}

} // namespace

void remove_frames(const std::string &folder) {
  namespace fs = std::filesystem;
  std::error_code error; // what cannot be removed will not be overwritten either, and is said then
  for (const char *const collection :
       {"results.pvd", "supports.pvd", "cases.pvd", "case_supports.pvd", "modes.pvd"})
    fs::remove(fs::path(folder) / collection, error);
  std::vector<fs::path> frames;
  for (const auto &entry : fs::directory_iterator(fs::path(folder) / "vtu", error)) {
    const std::string name = entry.path().filename().string();
    const bool is_ours = name.rfind("line_", 0) == 0 || name.rfind("supports_", 0) == 0 ||
                         name.rfind("case_", 0) == 0 || name.rfind("mode_", 0) == 0;
    if (is_ours && entry.path().extension() == ".vtu")
      frames.push_back(entry.path());
  }
  for (const fs::path &frame : frames)
    fs::remove(frame, error);
}

VtuWriter::VtuWriter(const Results &results, const std::string &folder, const unsigned int n_steps)
    : results(results), folder(folder), n_steps(n_steps) {
  prepare_output_folder(folder + "/vtu");
}

void VtuWriter::write_frame(const Frame &frame, const std::string &line,
                            const std::string &supports, const double time, Collection &of_line,
                            Collection &of_supports) const {
  if (frame.line.size() > 1) {
    of_line.emplace_back(time, "vtu/" + line);
    write_line(frame, folder + "/" + of_line.back().second);
  }
  if (!frame.supports.empty()) {
    of_supports.emplace_back(time, "vtu/" + supports);
    write_supports(results.supports, frame, folder + "/" + of_supports.back().second);
  }
}

void VtuWriter::append(const Frame &frame) {
  if (frame.step >= n_steps) {
    const unsigned int n = frame.step - n_steps + 1;
    const std::string number = numbered(n);
    write_frame(frame, "case_" + number, "case_supports_" + number, n, line_cases, support_cases);
  } else {
    const std::string number = numbered(n_frames++);
    write_frame(frame, "line_" + number, "supports_" + number, frame.time, line_frames,
                support_frames);
  }
  // The collections are written again and again, ever more rarely: their total cost stays linear.
  if (n_frames >= next_collection) {
    finish();
    next_collection = n_frames + n_frames / 10 + 1;
  }
}

void VtuWriter::append_modes() const {
  std::vector<std::pair<double, std::string>> modes;
  for (const ModeResult &mode : results.modes) {
    modes.emplace_back(mode.frequency, "vtu/mode_" + numbered(modes.size() + 1));
    Frame shape = mode.shape;
    shape.time = mode.frequency;
    write_line(shape, folder + "/" + modes.back().second);
  }
  if (!modes.empty())
    write_pvd(modes, folder + "/modes.pvd");
}

void VtuWriter::finish() const {
  if (!line_frames.empty())
    write_pvd(line_frames, folder + "/results.pvd");
  if (!support_frames.empty())
    write_pvd(support_frames, folder + "/supports.pvd");
  if (!line_cases.empty())
    write_pvd(line_cases, folder + "/cases.pvd");
  if (!support_cases.empty())
    write_pvd(support_cases, folder + "/case_supports.pvd");
}

} // namespace frictionbeam
