// SPDX-License-Identifier: LGPL-2.1-or-later
// A shared library that has nothing to do with this project.
extern "C" int answer() { return 42; }
