// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace crest::cli {

/// All of the program `crest`: one sub-command a system, the same words everywhere. Returns the
/// exit code; nothing is thrown.
int run_program(int argc, char** argv);

}  // namespace crest::cli
