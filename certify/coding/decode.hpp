// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Claim 14 from bytes that nobody has checked.
#include <span>

#include "certify/coding/records.hpp"

namespace crest::certify {

/// Both sections. Throws Malformed.
CodingCertificate decode_coding(std::span<const std::uint8_t> data,
                                std::span<const std::uint8_t> claims);

}  // namespace crest::certify
