// SPDX-License-Identifier: LGPL-2.1-or-later
// A continuum factored by one process without MPI shall have the quantities, to 1e-7 and on the
// same meshes, that it has with multigrid, and by one and two processes with MPI, with direct and
// with iterative linear algebra. The factorization knows nothing of the others' parts.
//
// processes PROGRAM MPIRUN CASE.prm [options]
#include "../check.h"
#include "run_program.h"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace {

void compare(const program::Run &alone, const program::Run &together, const std::string &what) {
  ++check::n_checks;
  if (together.exit_status != 0 || alone.quantities.size() != together.quantities.size()) {
    ++check::n_failures;
    std::cerr << what << " failed:\n" << together.output;
    return;
  }
  for (const program::Quantity &q : alone.quantities) {
    const double error = std::abs(together[q.name] - q.value) / std::abs(q.value);
    ++check::n_checks;
    if (!(error <= 1e-7)) {
      ++check::n_failures;
      std::cerr << what << ": " << q.name << " differs by " << error << '\n';
    }
  }
}

} // namespace

int main(int argc, char **argv) {
  if (argc < 4)
    return 1;
  const std::string binary = argv[1], mpirun = argv[2], file = argv[3];
  std::vector<std::string> options = {"--set", "Continuum/Tolerance = 1e-2", "--set",
                                      "Output/Report = false"};
  options.insert(options.end(), argv + 4, argv + argc);
  const auto run_alone = [&](const std::string &solver) {
    std::vector<std::string> words = options;
    words.insert(words.end(), {"--set", "Continuum/Linear solver = " + solver});
    return program::run(binary, file, words);
  };
  const program::Run alone = run_alone("direct");
  ++check::n_checks;
  if (alone.exit_status != 0 || alone.quantities.empty()) {
    std::cerr << alone.output;
    return 1;
  }
  const bool in_3d = std::count(options.begin(), options.end(), "Continuum/Dimension = 3") > 0;
  if (in_3d)
    compare(alone, run_alone("multigrid"), "alone, multigrid");
  for (const std::string processes : {"1", "2"})
    for (const std::string solver : {"direct", "multigrid", "amg"}) {
      if (solver == "multigrid" && !in_3d)
        continue;
      const program::TemporaryFolder folder;
      const auto results = folder.path / "results";
      std::vector<std::string> words = {mpirun, "--oversubscribe", "-np", processes, binary, file};
      words.insert(words.end(), options.begin(), options.end());
      words.insert(words.end(), {"--set", "Continuum/Linear solver = " + solver,
                                 "--output-directory", results.string()});
      program::Run together = program::execute(words);
      program::read_summary(results, together);
      compare(alone, together, processes + " processes, " + solver);
    }
  return check::report();
}
