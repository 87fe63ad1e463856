// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Claim 13 from bytes that nobody has checked.
#include <span>

#include "certify/spline_isosurface/records.hpp"

namespace crest::certify {

/// Both sections. Guarantees: what SPEC.md says of single numbers; lists as long as they say.
/// Throws Malformed.
SplineIsosurfaceCertificate decode_spline_isosurface(std::span<const std::uint8_t> data,
                                                     std::span<const std::uint8_t> claims);

}  // namespace crest::certify
