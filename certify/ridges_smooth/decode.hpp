// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Claim 4 from bytes that nobody has checked.
#include <span>

#include "certify/ridges_smooth/records.hpp"

namespace crest::certify {

/// Both sections. Throws Malformed, also for codes that have no meaning.
RidgesSmoothCertificate decode_ridges_smooth(std::span<const std::uint8_t> data,
                                             std::span<const std::uint8_t> claims);

}  // namespace crest::certify
