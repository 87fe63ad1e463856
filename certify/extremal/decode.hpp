// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Claim 8 from bytes that nobody has checked.
#include <span>

#include "certify/extremal/records.hpp"

namespace crest::certify {

/// Both sections. Guarantees: what SPEC.md says of the data section's numbers; lists as long as
/// they say. Throws Malformed.
ExtremalCertificate decode_extremal(std::span<const std::uint8_t> data,
                                    std::span<const std::uint8_t> claims);

}  // namespace crest::certify
