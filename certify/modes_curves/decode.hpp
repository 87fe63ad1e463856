// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Claim 7 from bytes that nobody has checked.
#include <span>

#include "certify/modes_curves/records.hpp"

namespace crest::certify {

/// Both sections. Throws Malformed.
ModesCurvesCertificate decode_modes_curves(std::span<const std::uint8_t> data,
                                           std::span<const std::uint8_t> claims);

}  // namespace crest::certify
