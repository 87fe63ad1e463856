// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Claim 4, ridges-smooth: ridges and umbilics of a surface that expressions define
// (certify/SPEC.md).
#include <span>

#include "certify/verify.hpp"

namespace crest::certify {

/// Appends a line to the verdict for each step proved. Throws Reject, Malformed, TieUnavailable
/// (`--input`: the surface stands in the certificate itself). On all cores.
void verify_ridges_smooth(std::span<const std::uint8_t> data, std::span<const std::uint8_t> claims,
                          const VerifyOptions& options, Verdict& verdict);

}  // namespace crest::certify
