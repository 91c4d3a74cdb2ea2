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
subsection Step rest
end
subsection Step swing
  set Loads = push
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
/// bending moment alone those of its envelope, to which the stress is in proportion.
void check_transient_compliance() {
  const program::TemporaryFolder place;
  const fs::path folder = place.path / "results";
  const std::string file = (place.path / "swings.prm").string();
  std::ofstream(file) << swings;
  const program::Run run = program::run(program_path, file, {}, folder);
  expect("it swings\n" + run.output, run.exit_status == 0);
  std::map<std::string, std::pair<double, double>> moments; // by place: largest, when
  for (const auto &row : rows_of(folder / "envelope.csv"))
    if (row.at("part") == "pipe" && row.at("what") == "My") {
      const double least = std::stod(row.at("least")), largest = std::stod(row.at("largest"));
      moments[row.at("s")] = -least > largest
                                 ? std::make_pair(-least, std::stod(row.at("time_of_least")))
                                 : std::make_pair(largest, std::stod(row.at("time_of_largest")));
    }
  unsigned int n = 0;
  std::map<std::string, double> modulus; // of each case, at the clamp
  for (const auto &row : rows_of(folder / "compliance.csv")) {
    const auto &[largest, time] = moments.at(row.at("s"));
    const double moment = std::hypot(std::stod(row.at("m_in")), std::stod(row.at("m_out")));
    if (largest < 1.)
      continue; // the tip, where there is none
    ++n;
    CHECK_NEAR(moment, largest, 1e-9);
    CHECK_NEAR(std::stod(row.at("time")), time, 1e-12);
    CHECK(std::abs(std::stod(row.at("axial"))) < 1e-6 * largest);
    CHECK(std::abs(std::stod(row.at("torsion"))) < 1e-6 * largest);
    const double stress = std::stod(row.at("stress"));
    const auto [known, is_new] = modulus.emplace(row.at("case"), moment / stress);
    CHECK_NEAR(moment / stress, known->second, 1e-9);
    (void)is_new;
  }
  CHECK(n == 2 * 6); // five nodes, and the clamp, of two cases
}
