// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Proven lines as the triangles that they cross; which of two is at the left: order by inheritance
// (SPEC.md, lemma 15).
#include "certify/skeleton/proof.hpp"

namespace crest::certify::compression {

using namespace skeleton;

enum class Entry : u8 {
  crossing,  ///< through the open side `name`
  side,      ///< starts inside the side `name`
  vertex,    ///< starts at, or passes, the vertex of the corner `name`
  inside     ///< starts at the zero inside the triangle of `name`
};

/// A part of a line in a triangle.
struct Cell {
  Entry entry;
  u32 name;
  u32 exit = kNone;  ///< open side; kNone: ends inside, at a vertex or follows a side
  friend bool operator==(const Cell&, const Cell&) = default;
};

/// A cell that is entered by crossing a side follows the one beyond that side.
struct Path {
  bool backward = false;
  std::vector<Cell> cells;
  /// Of the first cell, at a zero on its triangle's border: 0 or 1 as the exit is passed from its
  /// tail to its head; 2: not known.
  u8 root = 2;
  const Trace* trace = nullptr;
  std::size_t first_turn = 0;  ///< the cell of the first turn
  Pair direction{};            ///< of the cells that are straight
};

Path path_of(const Proof& proof, u32 separatrix);
/// One turn of the chain; its first cell is entered from the last.
Path chain_of(const Proof& proof, u32 orbit);

enum class Order { left, same, right };

/// Compares lines by how they have come: one ladder of signs a thread.
class Comparison {
 public:
  Comparison(const Proof& proof, SignLadder& sign) : proof_(proof), sign_(sign) {}

  /// Where the first line is, seen from the second, when both leave cells i, j through one side.
  /// Throws Reject if that cannot be told.
  Order compare(const Path& a, std::size_t i, const Path& b, std::size_t j);
  /// The same of two cells alone; empty: both cross one side into it.
  std::optional<Order> compare_cells(const Path& a, std::size_t i, const Path& b, std::size_t j);
  /// Place on the triangle's border, counter-clockwise from corner 0 on: three numbers a corner.
  int place(const Path& path, std::size_t i);
  /// Sign of det(x - z, v) along the line, z the zero inside the cell's triangle; v turned for a
  /// backward line.
  Sign swirl(const Path& path, std::size_t i);
  /// v enters the triangle of a side next to its tail.
  bool enters_at_tail(u32 side, bool backward);

 private:
  int rank(const Path& path, std::size_t i, u32 exit);
  Order of_one_point(const Path& a, std::size_t i, const Path& b, std::size_t j);

  const Proof& proof_;
  SignLadder& sign_;
};

}  // namespace crest::certify::compression
