// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Claim 2, features-mesh: thinning keeps the topology (certify/SPEC.md).
#include <span>

#include "certify/verify.hpp"

namespace crest::certify {

/// Appends a line to the verdict for each claim proved. Throws Reject, Malformed, TieUnavailable,
/// InputUnreadable. No number decides anything: the arithmetic option has no effect.
/// Cost: linear.
void verify_features_mesh(std::span<const std::uint8_t> data, std::span<const std::uint8_t> claims,
                          const VerifyOptions& options, Verdict& verdict);

}  // namespace crest::certify
