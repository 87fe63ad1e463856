// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Claim 9 from bytes that nobody has checked.
#include <span>

#include "certify/skeleton/records.hpp"

namespace crest::certify {

/// Both sections. Throws Malformed, also for codes that mean nothing.
SkeletonCertificate decode_skeleton(std::span<const std::uint8_t> data,
                                    std::span<const std::uint8_t> claims);

}  // namespace crest::certify
