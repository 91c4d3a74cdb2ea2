// SPDX-License-Identifier: LGPL-2.1-or-later
// Forces beside the stresses of transient steps.
#include "tables.h"

void check_transient_compliance();

namespace {

/// A cantilever that is pushed at its tip and swings, without axial force and torsion.
const char *const swings = R"(
subsection Material steel
  set Allowable cold = 138e6
  set Allowable hot = 138e6
end
subsection Section pipe
  set Size = DN 100
end
subsection Pipe p
  set Route = A 0 0 0; B 3 0 0
end
subsection Support clamp
  set Kind = anchor
  set At = A
end
subsection Mesh
  set Cell length = 0.5
end
subsection Load push
  set Kind = force
  set Forces = B 0 0 1000
  set History = sin(60*t)
end
subsection Load sag
  set Kind = force
  set Forces = B 0 0 -500
end
subsection Load inside
  set Kind = pressure
  set Pressure = 2e6
end
subsection Step rest
  set Loads = sag, inside
end
subsection Step swing
  set Loads = push, sag, inside
  set Analysis = transient
  set Duration = 0.2
end
subsection Time
  set Integrator = newmark
  set Step = 1e-3
end
subsection Stress
  set Code = B31.3
  set Occasional = swing
  set Expansion = rest to swing
end
)";

} // namespace

/// Forces beside the largest stresses of a transient step are those of the same instant: of one
/// bending moment alone those of its envelope, to which the stress is in proportion; of a range
/// those from where it begins.
void check_transient_compliance() {
  const program::TemporaryFolder place;
  const fs::path folder = place.path / "results";
  const std::string file = (place.path / "swings.prm").string();
  std::ofstream(file) << swings;
  const program::Run run = program::run(program_path, file, {}, folder);
  expect("it swings\n" + run.output, run.exit_status == 0);
  std::map<std::string, double> at_rest; // by place
  for (const auto &row : rows_of(folder / "line.csv"))
    if (row.at("step") == "rest")
      at_rest[row.at("s")] = std::stod(row.at("My"));
  struct Moment {
    double size, when;
  };
  std::map<std::string, std::map<std::string, Moment>> moments; // by kind and place
  for (const auto &row : rows_of(folder / "envelope.csv"))
    if (row.at("part") == "pipe" && row.at("what") == "My")
      for (const auto &[kind, from] : {std::make_pair("occasional", 0.),
                                       std::make_pair("expansion", at_rest.at(row.at("s")))}) {
        const double least = std::stod(row.at("least")) - from,
                     largest = std::stod(row.at("largest")) - from;
        moments[kind][row.at("s")] = -least > largest
                                         ? Moment{-least, std::stod(row.at("time_of_least"))}
                                         : Moment{largest, std::stod(row.at("time_of_largest"))};
      }
  unsigned int n = 0;
  std::map<std::string, double> modulus; // of each case, at the clamp
  for (const auto &row : rows_of(folder / "compliance.csv")) {
    const std::string kind = row.at("kind");
    const Moment expected = moments.at(kind).at(row.at("s"));
    const double moment = std::hypot(std::stod(row.at("m_in")), std::stod(row.at("m_out")));
    CHECK_NEAR(std::stod(row.at("pressure")), kind == "occasional" ? 2e6 : 0., 1e-9);
    if (expected.size < 1.)
      continue; // the tip, where there is none
    ++n;
    CHECK_NEAR(moment, expected.size, 1e-9);
    CHECK_NEAR(std::stod(row.at("time")), expected.when, 1e-12);
    CHECK(std::abs(std::stod(row.at("axial"))) < 1e-6 * expected.size);
    CHECK(std::abs(std::stod(row.at("torsion"))) < 1e-6 * expected.size);
    if (kind != "expansion")
      continue; // pressure has a share of the other
    const double stress = std::stod(row.at("stress"));
    const auto [known, is_new] = modulus.emplace(row.at("case"), moment / stress);
    CHECK_NEAR(moment / stress, known->second, 1e-9);
    (void)is_new;
  }
  CHECK(n == 2 * 6); // five nodes, and the clamp, of two cases
}
