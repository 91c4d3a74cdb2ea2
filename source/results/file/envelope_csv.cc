// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/file/csv_writer.h"
#include "results/file/envelope_tables.h"
#include "results/file/output_file.h"
#include "results/text.h"

namespace frictionbeam {

namespace {

using Of = QuantityKind::Of;

class Rows {
public:
  Rows(const UnitSystem &units, const std::string &step) : units(units), step(csv_field(step)) {}

  /// What the next rows are of. @param s along a pipe, as text
  void begin(const char *const part, const std::string &name, const std::string &s = "") {
    of = step + ',' + part + ',' + csv_field(name) + ',' + s + ',';
  }

  /// The first six quantities of a sort.
  template <typename Values>
  void add_six(const Of of, const Values &values) {
    for (unsigned int c = 0; c < 6; ++c) {
      const QuantityKind &kind = quantity_kind(of, c);
      add(kind.word, kind.unit, values(c));
    }
  }

  void add(const char *const what, const char *const unit, const Extremes &values) {
    if (!values.is_known())
      return;
    const double factor = units.factor(unit);
    text.append(of).append(what);
    for (const double number :
         {values.least / factor, values.least_at, values.largest / factor, values.largest_at})
      text.append(1, ',').append(exact_number(number));
    text.append(1, '\n');
  }

  std::string text;

private:
  const UnitSystem &units;
  const std::string step;
  std::string of;
};

} // namespace

void write_envelopes(const Scene &scene, const Results &results, const std::string &folder) {
  if (results.envelopes.empty())
    return;
  std::string text = "step,part,name,s,what,least,time_of_least,largest,time_of_largest\n";
  for (const StepEnvelope &envelope : results.envelopes) {
    Rows rows(results.units, scene.steps[envelope.step].name);
    for (std::size_t i = 0; i < envelope.supports.size(); ++i) {
      const SupportEnvelope &support = envelope.supports[i];
      rows.begin("support", results.supports[i].name);
      rows.add_six(Of::support, [&](const unsigned int c) { return support.values[c]; });
      rows.add("force", "N", support.force);
      rows.add("friction", "N", support.friction);
      rows.add("impact", "N s", support.impact);
    }
    for (std::size_t i = 0; i < envelope.restraints.size(); ++i) {
      rows.begin("restraint", results.restraints[i].name);
      rows.add_six(Of::holder,
                   [&](const unsigned int c) { return envelope.restraints[i].values[c]; });
      rows.add("force", "N", envelope.restraints[i].force);
    }
    for (std::size_t i = 0; i < envelope.points.size(); ++i) {
      rows.begin("point", results.points[i].name);
      rows.add_six(Of::motion, [&](const unsigned int c) { return envelope.points[i][c]; });
    }
    for (std::size_t i = 0; i < results.stations.size(); ++i) {
      const StationPlace &place = results.stations[i];
      rows.begin("pipe", scene.pipes[place.pipe].name,
                 exact_number(place.s / results.units.factor("m")));
      rows.add_six(Of::section, [&](const unsigned int c) -> Extremes {
        const std::size_t k = 6 * i + c;
        return {envelope.least[k], envelope.largest[k], envelope.least_at[k],
                envelope.largest_at[k]};
      });
    }
    text += rows.text;
  }
  write_file(folder + "/envelope.csv", text);
}

void add_envelope_remarks(const Scene &scene, Results &results) {
  for (const StepEnvelope &envelope : results.envelopes) {
    const std::string &step = scene.steps[envelope.step].name;
    if (envelope.n_line_instants < envelope.n_instants)
      results.remarks.push_back(
          "Step " + step + " ran on few unknowns: supports and reactions are looked at in all " +
          std::to_string(envelope.n_instants) + " instants, section forces and displacements in " +
          std::to_string(envelope.n_line_instants) +
          " of them, those of output. Their largest values may be missed; set Time/Output interval "
          "= 0 to look at all.");
    for (const auto &[from, to] : scene.stress.expansion)
      if (from == step && !scene.stress.code.empty())
        results.remarks.push_back("The stress range from " + from + " to " + to +
                                  " counts from the end of the transient step " + from +
                                  ", not from its other instants.");
  }
}

} // namespace frictionbeam
