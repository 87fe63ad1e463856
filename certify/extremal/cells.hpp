// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Listed cells, and the proofs of their codes (SPEC.md, theorem 14).
#include "certify/extremal/fields.hpp"

namespace crest::certify::extremal {

/// The listed cells, one after the other, and what is known of every node's cell.
struct Cells {
  static constexpr std::uint8_t kUnlisted = 0xff;

  std::vector<u32> ids;
  std::vector<u32> directions;  ///< place in the certificate's, of cells that are not open
  std::vector<u32> gradients;   ///< place in the certificate's, of regular cells
  Buffer<std::uint8_t>
      boxed;  ///< of the cell of that lowest node: it is regular, the box test holds
  Buffer<std::uint8_t> code;  ///< of the cell of that lowest node, or kUnlisted
};

/// Throws Reject unless the runs are cells, ascending, maximal, as many as codes.
Cells list_cells(const ExtremalCertificate& c, const Grid& grid);
/// Throws Reject unless every code is proven and L < min_value on all cells that are not listed.
/// Sets `boxed`.
void check_cells(const ExtremalCertificate& c, const Fields& fields, Cells& cells);

}  // namespace crest::certify::extremal
