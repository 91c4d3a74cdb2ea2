// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/law_conformance.h>
#include <frictionbeam/law_library.h>

#include <iostream>
#include <stdexcept>

/// frictionbeam-check-law LIBRARY...: load laws and put each to the conformance test.
int main(int argc, char **argv) {
  if (argc < 2) {
    std::cerr << "usage: frictionbeam-check-law LAW.so...\n";
    return 1;
  }
  try {
    frictionbeam::LawLibrary library;
    bool conforms = true;
    for (int i = 1; i < argc; ++i) {
      const auto &law = library.load(argv[i]);
      const auto violations = check_law(law, default_parameters(law));
      for (const auto &violation : violations)
        std::cerr << law.name << ": " << violation << '\n';
      std::cout << law.name << (violations.empty() ? " conforms\n" : " does not conform\n");
      conforms = conforms && violations.empty();
    }
    return conforms ? 0 : 1;
  } catch (const std::runtime_error &error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
