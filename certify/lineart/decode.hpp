// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Claim 15 from bytes that nobody has checked.
#include <span>

#include "certify/lineart/records.hpp"

namespace crest::certify {

/// Both sections. Throws Malformed.
LineArtCertificate decode_line_art(std::span<const std::uint8_t> data,
                                   std::span<const std::uint8_t> claims);

}  // namespace crest::certify
