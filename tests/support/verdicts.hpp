// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the checker says of a certificate.
#include <catch2/catch.hpp>
#include <string>

#include "certify/verify.hpp"

namespace crest::tests {

template <class Certificate>
void require_accepted(const Certificate& c) {
  const certify::Verdict verdict = certify::verify(encode(c));
  INFO(verdict.reason);
  REQUIRE(verdict.accepted);
}

/// Why it is rejected; empty if it is not.
template <class Certificate>
std::string reason(const Certificate& c) {
  const certify::Verdict verdict = certify::verify(encode(c));
  return verdict.accepted ? "" : verdict.reason;
}

}  // namespace crest::tests
