// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The checker: is the claim of a certificate true of the data it carries? (certify/SPEC.md) Both
// are defined by the table of claims a program is linked with: all (Crest::certify), or one.
#include "certify/container/checker.hpp"

namespace crest::certify {

/// By ascending name.
std::span<const ClaimChecker* const> known_claims();

/// Requires: require_sound_floating_point() has passed; round to nearest is in force.
/// Guarantees: accepted only if every claim of the claim's SPEC.md holds. Never throws for the
/// certificate's content, however hostile.
/// Throws: TieUnavailable, InputUnreadable, std::bad_alloc.
/// Cost: linear; about 1 microsecond a face with doubles, 100 with mpfr.
Verdict verify(std::span<const std::uint8_t> certificate, const VerifyOptions& options = {});

}  // namespace crest::certify
