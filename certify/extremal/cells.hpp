// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Listed cells, and the proofs of their codes (SPEC.md, theorem 14).
#include "certify/extremal/sparse.hpp"
#include "certify/extremal/splines.hpp"

namespace crest::certify::extremal {

/// The listed cells, one after the other, and what is known of the cell of every lowest node.
struct Cells {
  static constexpr std::uint8_t kUnlisted = 0xff;

  std::vector<u32> ids;
  std::vector<u32> directions;  ///< place in the certificate's, of cells that are not open
  std::vector<u32> gradients;   ///< place in the certificate's, of regular cells

  explicit Cells(const Grid& grid) : states_(grid.count, kUnlisted) {}

  std::uint8_t code(u32 cell) const {
    const std::uint8_t state = states_[cell];
    return state == kUnlisted ? state : state & ~kBoxed;
  }
  /// Is it regular, and does the box test hold?
  bool is_boxed(u32 cell) const {
    const std::uint8_t state = states_[cell];
    return state != kUnlisted && (state & kBoxed) != 0;
  }
  void list(u32 cell, std::uint8_t code) {
    ids.push_back(cell);
    states_.at(cell) = code;
  }
  /// Of a listed cell; callers of different cells may run at once.
  void set_boxed(u32 cell, bool boxed) {
    std::uint8_t& state = states_.at(cell);
    state = static_cast<std::uint8_t>((state & ~kBoxed) | (boxed ? kBoxed : 0));
  }

 private:
  static constexpr std::uint8_t kBoxed = 0x40;
  Sparse<std::uint8_t> states_;
};

/// Throws Reject unless the runs are cells, ascending, maximal, as many as codes.
Cells list_cells(const ExtremalCertificate& c, const Grid& grid);
/// Throws Reject unless every code is proven and L < min_value on all cells that are not listed.
/// Finds those that are boxed.
void check_cells(const ExtremalCertificate& c, const Splines& splines, Cells& cells);

}  // namespace crest::certify::extremal
