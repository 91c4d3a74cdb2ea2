// SPDX-License-Identifier: LGPL-2.1-or-later
#include "command/program/program.h"

int main(int argc, char **argv) { return frictionbeam::run_program(argc, argv); }
