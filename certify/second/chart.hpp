// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// SPEC.md, "Chart conditions" and "Division of a triangle", "of a segment": faces and their pieces.
#include <functional>

#include "certify/second/complex.hpp"
#include "certify/second/surface.hpp"

namespace crest::recheck {

using Barycentric = std::array<double, 3>;

/// A triangle in a face; a segment (A, B) is the triangle (A, B, A), a point has three equal
/// corners.
struct Piece {
  std::array<Barycentric, 3> corner;
  static Piece face() { return {{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}}; }
  static Piece segment(const Barycentric& a, const Barycentric& b) { return {{a, b, a}}; }
  static Piece point(const Barycentric& a) { return {{a, a, a}}; }
  bool is_segment() const { return corner[0] == corner[2]; }
  bool is_point() const { return is_segment() && corner[0] == corner[1]; }
  /// Four, in the order of SPEC.md; two of a segment; none of a point.
  std::vector<Piece> children() const;
};
Barycentric unit_corner(Index k);

/// Shows a statement on a piece, or where its enclosure is too weak, on its children.
/// Throws: Open, Undefined from the deepest.
template <class Set>
void shown(const Set& piece, int depth, const std::function<void(const Set&)>& statement) {
  try {
    return statement(piece);
  } catch (const Open&) {
    if (depth == 0) throw;
  } catch (const Undefined&) {
    if (depth == 0) throw;
  }
  const std::vector<Set> children = piece.children();
  if (children.empty()) throw Open{"a statement at a point"};
  for (const Set& child : children) shown(child, depth - 1, statement);
}

/// The order in a node's byte of a division; rejects bits that are not allowed.
int order_of(Reader& in, unsigned byte, unsigned allowed);

/// Reads a division at most `depth` deep, and calls leaf(piece, byte) in the order of each node
/// without children, whose byte has no bits but the order's and these.
template <class Leaf>
void read_division(Reader& in, const Piece& piece, int depth, unsigned allowed, const Leaf& leaf) {
  const unsigned byte = in.u8();
  const bool divided = (byte & 4) != 0;
  const Scope scope;
  context.order = order_of(in, byte, divided ? 4 : allowed);
  if (!divided) return leaf(piece, byte);
  if (depth == 0) in.fail("a division is too deep");
  for (const Piece& child : piece.children()) read_division(in, child, depth - 1, allowed, leaf);
}

/// What all parts of the check share.
struct Problem {
  const Certificate& certificate;
  const Surface& surface;
  const Complex& complex;

  Ball h(int c) const;
  /// Kind 0: the fibres over a piece (of Ball: a point).
  template <class T>
  Fibre<T> fibre(Index face, const Piece& piece, int c) const;
  /// Kind 0: x_j - x_i + s (N_j - N_i).
  Vector<Model> chord(Index face, Index i, Index j, const Model& s) const;
  /// Kind 1: a corner's lifted coordinate (exact), and both over a piece.
  Ball lifted(Index face, Index corner, std::size_t direction) const;
  template <class T>
  std::array<T, 2> unit(Index face, const Piece& piece) const;
};

/// Kind 1: the chart conditions, all exact.
void check_parametric_chart(const Problem& problem);

/// Numbers 0..n-1, each once, on all cores; rethrows what the least number that throws has thrown.
void in_parallel(Index n, const std::function<void(Index)>& work);

}  // namespace crest::recheck
