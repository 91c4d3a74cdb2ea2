// SPDX-License-Identifier: LGPL-2.1-or-later
// check_case PROGRAM CASE.prm OPTIONS...: one test of a case, by a program that is started for it.
#include "../check.h"
#include "case_checks.h"

int main(int argc, char **argv) {
  try {
    if (argc < 3)
      throw std::runtime_error("check_case PROGRAM CASE.prm OPTIONS...");
    check_case(argv[1], argv[2], {argv + 3, argv + argc});
  } catch (const std::exception &error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return check::report();
}
