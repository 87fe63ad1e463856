// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/program.hpp"

int main(int argc, char** argv) {
  return crest::cli::run_program(argc, argv);
}
