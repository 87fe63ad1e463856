// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Claim 10 from bytes that nobody has checked.
#include <span>

#include "certify/compression/records.hpp"

namespace crest::certify {

/// Both sections. Throws Malformed, also for codes that mean nothing and vertices that do not
/// ascend.
CompressionCertificate decode_compression(std::span<const std::uint8_t> data,
                                          std::span<const std::uint8_t> claims);

}  // namespace crest::certify
