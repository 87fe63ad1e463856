// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Claim 3, reeb: the Reeb graph of a function linear or quadratic on every face (certify/SPEC.md).
#include <span>

#include "certify/verify.hpp"

namespace crest::certify {

/// Appends a line to the verdict for each step proved. Throws Reject, Malformed, TieUnavailable
/// (with
/// `--input`: no mesh file that the checker reads holds the values).
/// Cost: near-linear in faces and crossed edges of the cuts; 0.3 microseconds a linear face, 1 when
/// half of the nodes are critical.
void verify_reeb(std::span<const std::uint8_t> data, std::span<const std::uint8_t> claims,
                 const VerifyOptions& options, Verdict& verdict);

}  // namespace crest::certify
