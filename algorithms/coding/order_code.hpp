// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The order of the input's vertices and faces (docs/cmc-format.md, "Order").
#include "algorithms/coding/connectivity.hpp"
#include "algorithms/coding/range_coder.hpp"

namespace crest::coding {

/// Which of the input each decoded vertex and face is: permutations.
struct KeptOrder {
  std::vector<Index> vertices, faces;
};

Bytes encode_order(const KeptOrder& order);

/// Throws: StreamError unless both are permutations.
KeptOrder decode_order(std::span<const std::uint8_t> bytes, Index vertices, Index faces);

}  // namespace crest::coding
