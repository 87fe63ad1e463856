// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Claim 12 from bytes that nobody has checked.
#include <span>

#include "certify/spline_cubic/records.hpp"

namespace crest::certify {

/// Both sections. Guarantees: what SPEC.md says of single numbers; lists as long as they say.
/// Throws Malformed.
SplineCubicCertificate decode_spline_cubic(std::span<const std::uint8_t> data,
                                           std::span<const std::uint8_t> claims);

}  // namespace crest::certify
