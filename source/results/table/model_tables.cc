// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/table/model_tables.h"

#include "results/file/csv_writer.h"
#include "results/support_force.h"
#include "results/text.h"

namespace frictionbeam {

namespace {

/// A table with units behind the names of its columns.
class UnitTable {
public:
  explicit UnitTable(const UnitSystem &units) : units(units) {}

  /// A column of numbers in SI units; unit empty: words, or numbers without a unit.
  UnitTable &column(const std::string &name, const std::string &unit = "") {
    text += (factors.empty() ? "" : ",") + name +
            (unit.empty() ? "" : " [" + (unit == "-" ? unit : units.name(unit)) + "]");
    factors.push_back(unit.empty() || unit == "-" ? 1. : units.factor(unit));
    return *this;
  }
  UnitTable &columns(const std::vector<std::string> &names, const std::string &unit) {
    for (const std::string &name : names)
      column(name, unit);
    return *this;
  }

  UnitTable &word(const std::string &value) {
    begin_field();
    text += csv_field(value);
    return *this;
  }
  UnitTable &number(const double value) {
    begin_field();
    append_exact_number(value / factors[next - 1], text);
    return *this;
  }
  UnitTable &point(const Point3 &value) {
    return number(value[0]).number(value[1]).number(value[2]);
  }
  UnitTable &vector(const Vector3 &value) {
    return number(value[0]).number(value[1]).number(value[2]);
  }

  void write(const std::string &path) const { write_file(path, text + "\n"); }

private:
  void begin_field() {
    next = next == factors.size() ? 0 : next;
    text += next++ == 0 ? '\n' : ',';
  }

  const UnitSystem &units;
  std::vector<double> factors;
  std::size_t next = 0;
  std::string text;
};

std::string number_of_node(const unsigned int vertex) { return std::to_string(vertex + 1); }

void write_nodes(const Model &model, const UnitSystem &units, const std::string &folder) {
  std::vector<std::string> names(model.mesh.vertices.size());
  for (const auto &[name, vertex] : model.mesh.points)
    names[vertex] += (names[vertex].empty() ? "" : "; ") + name;
  UnitTable table(units);
  table.column("node").column("names").columns({"x", "y", "z"}, "m");
  for (unsigned int v = 0; v < names.size(); ++v)
    table.word(number_of_node(v)).word(names[v]).point(model.mesh.vertices[v]);
  table.write(folder + "/nodes.csv");
}

void write_elements(const Model &model, const UnitSystem &units, const std::string &folder) {
  const Scene &scene = model.scene;
  // In the order of pipes, which the numbers of element_forces.csv are in.
  std::vector<std::vector<const Profile *>> profiles(scene.pipes.size());
  for (unsigned int p = 0; p < scene.pipes.size(); ++p)
    profiles[p].resize(model.mesh.pipes[p].bend_radius.size());
  for (unsigned int i = 0; i < model.discretization.pipe_cells().size(); ++i) {
    const PipeCell &cell = model.discretization.pipe_cells()[i];
    profiles[cell.pipe][cell.position] =
        &model.discretization.profiles()[model.discretization.pipe_cell(i)->material_id()];
  }
  UnitTable table(units);
  table.column("element")
      .column("pipe")
      .column("section")
      .column("material")
      .column("rigid")
      .column("node_1")
      .column("node_2")
      .columns({"s_1", "s_2", "bend_radius", "outer_diameter", "wall"}, "m")
      .columns({"EA", "GA"}, "N")
      .columns({"GJ", "EI"}, "N m2")
      .column("mass", "kg/m");
  unsigned int number = 0;
  for (unsigned int p = 0; p < scene.pipes.size(); ++p) {
    const Pipe &pipe = scene.pipes[p];
    const MeshedPipe &meshed = model.mesh.pipes[p];
    for (unsigned int i = 0; i < profiles[p].size(); ++i) {
      const Profile &profile = *profiles[p][i];
      const double part = 0.5 * (meshed.s[i] + meshed.s[i + 1]) / meshed.s.back();
      const Section section = pipe.end_section ? between(scene.sections[pipe.section],
                                                         scene.sections[*pipe.end_section], part)
                                               : scene.sections[pipe.section];
      table.word(std::to_string(++number))
          .word(pipe.name)
          .word(scene.sections[pipe.section].name +
                (pipe.end_section ? " to " + scene.sections[*pipe.end_section].name : ""))
          .word(scene.materials[pipe.material].name)
          .word(pipe.rigid ? "true" : "false")
          .word(number_of_node(meshed.vertices[i]))
          .word(number_of_node(meshed.vertices[i + 1]))
          .number(meshed.s[i])
          .number(meshed.s[i + 1])
          .number(meshed.bend_radius[i])
          .number(2. * section.outer_radius)
          .number(section.wall)
          .number(profile.EA)
          .number(profile.GA)
          .number(profile.GJ)
          .number(profile.EI)
          .number(profile.mass);
    }
  }
  table.write(folder + "/elements.csv");
}

/// What a restraint holds: global motions, and directions across or along the pipe.
std::string held_by(const Restraint &restraint) {
  const char *const words[] = {"ux", "uy", "uz", "rx", "ry", "rz"};
  std::string text;
  const auto add = [&text](const std::string &word) { text += (text.empty() ? "" : " ") + word; };
  for (unsigned int c = 0; c < 6; ++c)
    if (restraint.fixed[c])
      add(words[c]);
  for (const Direction &direction : restraint.translations)
    add(direction.kind == Direction::Kind::along    ? "along"
        : direction.kind == Direction::Kind::across ? "across"
                                                    : "direction");
  return text;
}

void write_restraints(const Model &model, const Results &results, const UnitSystem &units,
                      const std::string &folder) {
  const Scene &scene = model.scene;
  UnitTable table(units);
  table.column("name").column("kind").column("node").column("holds").columns({"x", "y", "z"}, "m");
  for (const std::string of : {"normal", "t1", "t2"})
    table.columns({of + "_x", of + "_y", of + "_z"}, "-");
  table.columns({"kx", "ky", "kz"}, "N/m").columns({"krx", "kry", "krz"}, "N m/rad");
  table.column("capacity", "N");
  const auto add_place = [&](const std::string &name, const std::string &kind,
                             const unsigned int vertex, const std::string &holds,
                             const Point3 &position) {
    table.word(name).word(kind).word(number_of_node(vertex)).word(holds).point(position);
  };
  const auto add_nothing = [&](const unsigned int n) {
    for (unsigned int i = 0; i < n; ++i)
      table.word("");
  };
  const auto add_capacity = [&](const double capacity) {
    capacity > 0. ? table.number(capacity) : table.word("");
  };
  for (unsigned int i = 0; i < results.supports.size(); ++i) {
    const SupportInfo &support = results.supports[i];
    add_place(support.name, support.kind, model.contacts[i].vertices[0], "normal",
              support.position);
    table.vector(support.normal).vector(support.t1).vector(support.t2);
    add_nothing(6);
    add_capacity(support.capacity);
  }
  unsigned int number = 0; // of results.restraints: restraints by place, then springs
  for (unsigned int i = 0; i < scene.restraints.size(); ++i)
    for (const Site &site : model.mesh.restraints[i]) {
      const RestraintInfo &info = results.restraints[number++];
      add_place(info.name, info.kind, site.vertex, held_by(scene.restraints[i]), info.position);
      add_nothing(15);
      add_capacity(info.capacity);
    }
  for (const Spring &spring : scene.springs) {
    const RestraintInfo &info = results.restraints[number++];
    add_place(info.name, info.kind, model.mesh.points.at(spring.point),
              spring.other.empty() ? "spring" : "spring to " + spring.other, info.position);
    add_nothing(9);
    for (const double stiffness : spring.stiffness)
      table.number(stiffness);
    add_nothing(1);
  }
  table.write(folder + "/restraints.csv");
}

/// Section forces of one step at both ends of the elements, which stand one after the other in its
/// line: a node has two stations where forces jump.
void add_element_forces(const Frame &frame, UnitTable &table) {
  unsigned int number = 0;
  const Station *first = nullptr;
  for (const Station &station : frame.line) {
    if (!station.is_node())
      continue;
    if (first != nullptr && first->pipe == station.pipe && first->s < station.s) {
      table.word(frame.name)
          .word(std::to_string(++number))
          .word(number_of_node(first->vertex))
          .word(number_of_node(station.vertex));
      for (const Station *const end : {first, &station})
        for (const double force : end->force)
          table.number(force);
    }
    first = &station;
  }
}

void add_restraint_forces(const Results &results, const Frame &frame, UnitTable &table) {
  const auto begin_row = [&](const std::string &name, const std::string &kind) {
    table.word(frame.name).number(frame.time).word(name).word(kind);
  };
  for (unsigned int i = 0; i < frame.supports.size(); ++i) {
    const SupportInfo &info = results.supports[i];
    const SupportState &state = frame.supports[i];
    begin_row(info.name, info.kind);
    if (frame.is_amplitude)
      for (unsigned int c = 0; c < 6; ++c)
        table.word("");
    else
      table.vector(force_in_space(info, state)).vector(state.mt * info.normal);
  }
  for (unsigned int i = 0; i < frame.reactions.size(); ++i) {
    begin_row(results.restraints[i].name, results.restraints[i].kind);
    for (const double force : frame.reactions[i])
      table.number(force);
  }
}

} // namespace

void write_model_tables(const Model &model, const Results &results, const std::string &folder) {
  const UnitSystem &units = model.scene.units;
  write_nodes(model, units, folder);
  write_elements(model, units, folder);
  write_restraints(model, results, units, folder);
}

void write_force_tables(const Scene &scene, const Results &results, const std::string &folder) {
  UnitTable elements(scene.units), restraints(scene.units);
  elements.column("step").column("element").column("node_1").column("node_2");
  for (const std::string end : {"_1", "_2"})
    elements.columns({"N" + end, "Vy" + end, "Vz" + end}, "N")
        .columns({"Mx" + end, "My" + end, "Mz" + end}, "N m");
  restraints.column("step").column("time", "s").column("name").column("kind");
  restraints.columns({"fx", "fy", "fz"}, "N").columns({"mx", "my", "mz"}, "N m");
  for (const Frame &frame : results.frames)
    if (frame.end_of_step) {
      add_element_forces(frame, elements);
      add_restraint_forces(results, frame, restraints);
    }
  elements.write(folder + "/element_forces.csv");
  restraints.write(folder + "/restraint_forces.csv");
}

} // namespace frictionbeam
