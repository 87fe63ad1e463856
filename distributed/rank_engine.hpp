// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Pieces worked on by the ranks of MPI. Rank 0 runs the command; it gives the job to the others and
// joins what they answer by the pieces' numbers, so that nothing depends on who was first. Each
// reads what its pieces need, halo and all, from the file itself.
#include "cli/piece_work.hpp"

namespace crest::distributed {

/// Lets piece_engine() ask all ranks. On rank 0.
void use_all_ranks();
/// Works on what rank 0 asks for until it says that it is done. On the others.
void serve();
/// Lets the others return from serve(). On rank 0.
void dismiss();

/// Bytes of jobs, places, records and values: all that ranks have sent one another. On rank 0,
/// which is an end of every message.
std::size_t bytes_exchanged();

}  // namespace crest::distributed
