// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Claim 6 from bytes that nobody has checked.
#include <span>

#include "certify/modes/records.hpp"

namespace crest::certify {

/// Both sections. Throws Malformed.
ModesCertificate decode_modes(std::span<const std::uint8_t> data,
                              std::span<const std::uint8_t> claims);

}  // namespace crest::certify
