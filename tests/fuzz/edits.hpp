// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Edits of a true certificate by a fuzzer's bytes.
#include <algorithm>

#include "certify/container/container.hpp"

namespace crest::tests {

/// Edits of four bytes each: where (2), how, a value.
inline void edit(certify::Bytes& bytes, std::span<const std::uint8_t> edits) {
  using namespace certify;
  for (; edits.size() >= 4; edits = edits.subspan(4)) {
    const std::size_t room = bytes.size() - kHeaderSize - kSealSize;
    if (room < 8) return;
    const std::size_t at = kHeaderSize + (edits[0] + 256U * edits[1]) % (room - 7);
    const std::uint8_t how = edits[2] % 4, value = edits[3];
    if (how == 0) bytes[at] = value;
    if (how == 1) bytes[at] = static_cast<std::uint8_t>(bytes[at] + value);
    if (how == 2) std::swap_ranges(&bytes[at], &bytes[at] + 4, &bytes[at] + 4);
    if (how == 3) bytes[kLengthsOffset + value % 16] ^= edits[0];
  }
}

/// With digest and seal made anew, if its lengths let it.
inline void bind(certify::Bytes& bytes) {
  try {
    certify::rebind(bytes);
  } catch (const std::invalid_argument&) {
  }
}

}  // namespace crest::tests
