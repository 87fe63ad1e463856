// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What a claim's room gives to the programs: `extern const ClaimChecker <room>_claim`, defined in
// its claim.cpp. The tables of them are made by CMake from the folders' names.
#include <span>

#include "certify/container/verdict.hpp"

namespace crest::certify {

struct ClaimChecker {
  std::uint32_t number, version;  ///< in the header of certificates
  const char* name;
  /// Appends a line to the verdict for each step proved. Throws Reject, Malformed, TieUnavailable,
  /// InputUnreadable.
  void (*check)(std::span<const std::uint8_t> data, std::span<const std::uint8_t> claims,
                const VerifyOptions& options, Verdict& verdict);
};

/// verify() of certify/verify.hpp for these claims alone.
Verdict verify_among(std::span<const ClaimChecker* const> known,
                     std::span<const std::uint8_t> certificate, const VerifyOptions& options);

}  // namespace crest::certify
