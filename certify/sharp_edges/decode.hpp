// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Claim 5 from bytes that nobody has checked.
#include <span>

#include "certify/sharp_edges/records.hpp"

namespace crest::certify {

/// Both sections. Throws Malformed.
SharpEdgesCertificate decode_sharp_edges(std::span<const std::uint8_t> data,
                                         std::span<const std::uint8_t> claims);

}  // namespace crest::certify
