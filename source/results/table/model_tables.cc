// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/table/model_tables.h"

#include "results/file/csv_writer.h"
#include "results/file/output_file.h"
#include "results/support_force.h"
#include "results/text.h"

namespace frictionbeam {

namespace {

/// Columns of a table, with units behind their names.
class UnitColumns {
public:
  explicit UnitColumns(const UnitSystem &units) : units(units) {}

  /// A column of numbers in SI units; unit empty: words, or numbers without a unit.
  UnitColumns &column(const std::string &name, const std::string &unit = "") {
    names += (factors.empty() ? "" : ",") + name +
             (unit.empty() ? "" : " [" + (unit == "-" ? unit : units.name(unit)) + "]");
    factors.push_back(unit.empty() || unit == "-" ? 1. : units.factor(unit));
    return *this;
  }
  UnitColumns &columns(const std::vector<std::string> &of_columns, const std::string &unit) {
    for (const std::string &name : of_columns)
      column(name, unit);
    return *this;
  }

  std::string names;
  std::vector<double> factors;

private:
  const UnitSystem &units;
};

/// A row of a table being made, field by field.
class UnitRow {
public:
  UnitRow(const std::vector<double> &factors, std::string &text) : factors(factors), text(text) {}

  UnitRow &word(const std::string &value) {
    begin_field();
    text += csv_field(value);
    return *this;
  }
  UnitRow &number(const double value) {
    begin_field();
    append_exact_number(value / factors[next - 1], text);
    return *this;
  }
  UnitRow &point(const Point3 &value) { return number(value[0]).number(value[1]).number(value[2]); }
  UnitRow &vector(const Vector3 &value) {
    return number(value[0]).number(value[1]).number(value[2]);
  }
  UnitRow &nothing(const unsigned int n) {
    for (unsigned int i = 0; i < n; ++i)
      word("");
    return *this;
  }

private:
  void begin_field() {
    AssertIndexRange(next, factors.size());
    if (next++ > 0)
      text += ',';
  }

  const std::vector<double> &factors;
  std::size_t next = 0;
  std::string &text;
};

/// The file of such a table.
class UnitTable {
public:
  UnitTable(const std::string &path, const UnitColumns &columns)
      : file(path), factors(columns.factors) {
    file.stream() << columns.names << '\n';
    file.flush();
  }

  /// @param add of a row's number and a UnitRow, by any thread
  template <typename Add>
  void add_rows(const std::size_t n_rows, const Add &add) {
    const auto add_row = [&](const std::size_t row, std::string &text) {
      UnitRow fields(factors, text);
      add(row, fields);
      text += '\n';
    };
    write_rows(n_rows, add_row, file);
  }

private:
  OutputFile file;
  const std::vector<double> factors;
};

std::string number_of_node(const unsigned int vertex) { return std::to_string(vertex + 1); }

void write_nodes(const Model &model, const UnitSystem &units, const std::string &folder) {
  std::vector<std::string> names(model.mesh.vertices.size());
  for (const auto &[name, vertex] : model.mesh.points)
    names[vertex] += (names[vertex].empty() ? "" : "; ") + name;
  UnitColumns columns(units);
  columns.column("node").column("names").columns({"x", "y", "z"}, "m");
  UnitTable(folder + "/nodes.csv", columns)
      .add_rows(names.size(), [&](const unsigned int v, UnitRow &row) {
        row.word(number_of_node(v)).word(names[v]).point(model.mesh.vertices[v]);
      });
}

void write_elements(const Model &model, const UnitSystem &units, const std::string &folder) {
  const Scene &scene = model.scene;
  // In the order of pipes, which the numbers of element_forces.csv are in.
  std::vector<unsigned int> first_of(scene.pipes.size(), 0);
  for (unsigned int p = 0, n = 0; p < scene.pipes.size(); ++p) {
    first_of[p] = n;
    n += model.mesh.pipes[p].bend_radius.size();
  }
  const std::vector<PipeCell> &cells = model.discretization.pipe_cells();
  std::vector<unsigned int> cell_of(cells.size());
  for (unsigned int i = 0; i < cells.size(); ++i)
    cell_of[first_of[cells[i].pipe] + cells[i].position] = i;
  UnitColumns columns(units);
  columns.column("element")
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
  const auto add = [&](const unsigned int number, UnitRow &row) {
    const PipeCell &cell = cells[cell_of[number]];
    const Pipe &pipe = scene.pipes[cell.pipe];
    const MeshedPipe &meshed = model.mesh.pipes[cell.pipe];
    const unsigned int i = cell.position;
    const Profile &profile =
        model.discretization
            .profiles()[model.discretization.pipe_cell(cell_of[number])->material_id()];
    const double part = 0.5 * (meshed.s[i] + meshed.s[i + 1]) / meshed.s.back();
    const Section section = pipe.end_section ? between(scene.sections[pipe.section],
                                                       scene.sections[*pipe.end_section], part)
                                             : scene.sections[pipe.section];
    row.word(std::to_string(number + 1))
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
  };
  UnitTable(folder + "/elements.csv", columns).add_rows(cells.size(), add);
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
  UnitColumns columns(units);
  columns.column("name").column("kind").column("node").column("holds").columns({"x", "y", "z"},
                                                                               "m");
  for (const std::string of : {"normal", "t1", "t2"})
    columns.columns({of + "_x", of + "_y", of + "_z"}, "-");
  columns.columns({"kx", "ky", "kz"}, "N/m").columns({"krx", "kry", "krz"}, "N m/rad");
  columns.column("capacity", "N");
  UnitTable table(folder + "/restraints.csv", columns);
  const auto add_place = [&](const auto &info, const unsigned int vertex, const std::string &holds,
                             UnitRow &row) {
    row.word(info.name).word(info.kind).word(number_of_node(vertex)).word(holds);
    row.point(info.position);
  };
  const auto add_capacity = [&](const double capacity, UnitRow &row) {
    capacity > 0. ? row.number(capacity) : row.word("");
  };
  table.add_rows(results.supports.size(), [&](const unsigned int i, UnitRow &row) {
    const SupportInfo &support = results.supports[i];
    add_place(support, model.contacts[model.contacts.places()[i].front()].at, "normal", row);
    row.vector(support.normal).vector(support.t1).vector(support.t2).nothing(6);
    add_capacity(support.capacity, row);
  });
  std::vector<std::pair<const Restraint *, const Site *>> sites; // beside results.restraints
  for (unsigned int i = 0; i < scene.restraints.size(); ++i)
    for (const Site &site : model.mesh.restraints[i])
      sites.emplace_back(&scene.restraints[i], &site);
  table.add_rows(sites.size(), [&](const unsigned int i, UnitRow &row) {
    const auto &[restraint, site] = sites[i];
    add_place(results.restraints[i], site->vertex, held_by(*restraint), row);
    row.nothing(15);
    add_capacity(results.restraints[i].capacity, row);
  });
  table.add_rows(scene.springs.size(), [&](const unsigned int i, UnitRow &row) {
    const Spring &spring = scene.springs[i];
    add_place(results.restraints[sites.size() + i], model.mesh.points.at(spring.point),
              spring.other.empty() ? "spring" : "spring to " + spring.other, row);
    row.nothing(9);
    for (const double stiffness : spring.stiffness)
      row.number(stiffness);
    row.nothing(1);
  });
}

/// Section forces of one step at both ends of the elements, which stand one after the other in its
/// line: a node has two stations where forces jump.
void add_element_forces(const Frame &frame, UnitTable &table) {
  std::vector<std::pair<const Station *, const Station *>> elements;
  const Station *first = nullptr;
  for (const Station &station : frame.line) {
    if (!station.is_node())
      continue;
    if (first != nullptr && first->pipe == station.pipe && first->s < station.s)
      elements.emplace_back(first, &station);
    first = &station;
  }
  table.add_rows(elements.size(), [&](const unsigned int i, UnitRow &row) {
    const auto &[begin, end] = elements[i];
    row.word(frame.name)
        .word(std::to_string(i + 1))
        .word(number_of_node(begin->vertex))
        .word(number_of_node(end->vertex));
    for (const Station *const station : {begin, end})
      for (const double force : station->force)
        row.number(force);
  });
}

void add_restraint_forces(const Results &results, const Frame &frame, UnitTable &table) {
  table.add_rows(frame.supports.size(), [&](const unsigned int i, UnitRow &row) {
    const SupportInfo &info = results.supports[i];
    const SupportState &state = frame.supports[i];
    row.word(frame.name).number(frame.time).word(info.name).word(info.kind);
    if (frame.is_amplitude)
      row.nothing(6);
    else
      row.vector(force_in_space(state)).vector(state.mt * info.normal);
  });
  table.add_rows(frame.reactions.size(), [&](const unsigned int i, UnitRow &row) {
    const RestraintInfo &info = results.restraints[i];
    row.word(frame.name).number(frame.time).word(info.name).word(info.kind);
    for (const double force : frame.reactions[i])
      row.number(force);
  });
}

} // namespace

void write_model_tables(const Model &model, const Results &results, const std::string &folder) {
  const UnitSystem &units = model.scene.units;
  write_nodes(model, units, folder);
  write_elements(model, units, folder);
  write_restraints(model, results, units, folder);
}

void write_force_tables(const Scene &scene, const Results &results, const std::string &folder) {
  UnitColumns of_elements(scene.units), of_restraints(scene.units);
  of_elements.column("step").column("element").column("node_1").column("node_2");
  for (const std::string end : {"_1", "_2"})
    of_elements.columns({"N" + end, "Vy" + end, "Vz" + end}, "N")
        .columns({"Mx" + end, "My" + end, "Mz" + end}, "N m");
  of_restraints.column("step").column("time", "s").column("name").column("kind");
  of_restraints.columns({"fx", "fy", "fz"}, "N").columns({"mx", "my", "mz"}, "N m");
  UnitTable elements(folder + "/element_forces.csv", of_elements);
  UnitTable restraints(folder + "/restraint_forces.csv", of_restraints);
  for (const Frame &frame : results.frames)
    if (frame.end_of_step) {
      add_element_forces(frame, elements);
      add_restraint_forces(results, frame, restraints);
    }
}

} // namespace frictionbeam
