// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Pieces worked on by the ranks of MPI, whatever the system. Rank 0 runs the command: it sends what
// all pieces have in common to all, each piece's own to the rank whose piece it is, and takes the
// answers in the order of the pieces, so that nothing depends on who was first.
#include <functional>
#include <map>
#include <vector>

namespace crest::distributed {

using Bytes = std::vector<char>;

enum class Task : int {
  none,
  volume_records,
  volume_values,
  curvatures,
  ridge_fits,
  ridge_decisions,
  tet_tests,
  face_tests
};

/// Work on a piece: its own message in, the answer out.
using PieceWork = std::function<void(std::size_t piece, Bytes own, Bytes& answer)>;

/// How a rank does a task. Both may throw: rank 0 then throws the same, after all ranks have
/// stopped.
struct Skill {
  std::function<void(const Bytes& common)> start;  ///< before the first piece
  PieceWork work;
};

/// What rank 0 wants to have done.
struct Order {
  Task task;
  Bytes common;
  std::size_t pieces;
  std::function<Bytes(std::size_t piece)> own;  ///< asked for in order
  PieceWork here;                               ///< on rank 0's own pieces
};

/// Calls take(piece, answer) for every piece. On rank 0, in the thread that started MPI.
void ask(const Order& order, const std::function<void(std::size_t, Bytes)>& take);
/// Does what rank 0 asks for until it says that it is done. On the others.
void serve(const std::map<Task, Skill>& skills);
/// Lets the others return from serve(). On rank 0.
void dismiss();

std::size_t rank_count();
/// All that ranks have sent one another. On rank 0, which is an end of every message.
std::size_t bytes_exchanged();

}  // namespace crest::distributed
