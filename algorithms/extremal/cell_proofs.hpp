// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What is proven of whole cells (an image: squares): T's net passes the cone test; g is not zero;
// grad g lies in a cone; s_nn > 0 (certify/extremal/SPEC.md).
#include "algorithms/extremal/cell_nets.hpp"
#include "algorithms/extremal/direction.hpp"

namespace crest::extremal {

/// The first five as in the certificate; unlisted: inactive.
enum class CellState : std::uint8_t { open, cone, empty, regular, regular_extremal, unlisted };

/// A state with its witnesses.
struct CellProof {
  CellState state = CellState::open;
  Short3 direction{};  ///< w
  Short3 gradient{};   ///< a, of a regular cell: of grad g, in units in which the cell is a cube
  bool boxed = false;  ///< a regular cell passes the box test
};

/// Proves of the cell at v, whose nets are given, what it can; `guess` is near n.
/// Guarantees: every inequality holds with 1e-6 of its terms to spare, so that what rounding does
/// to
///   the nets (1e-14) and to the bounds does not matter; the checker repeats it with errors.
CellProof prove_cell(const Fields& fields, const Node& v, const CellNets& nets, const Vec3& guess);

}  // namespace crest::extremal
