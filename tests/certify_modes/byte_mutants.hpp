// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Mutants of a certificate's bytes, bound again.
#include <catch2/catch.hpp>

#include "certify/container/container.hpp"
#include "certify/verify.hpp"
#include "tests/support/random.hpp"

namespace crest::tests {

/// Of `count` mutants - cut off, a byte replaced, a bit turned - judge(mutant) gets those that can
/// be decoded; the others must be rejected.
template <class Decode, class Judge>
void try_bytes(const certify::Bytes& bytes, std::uint64_t count, Random& random,
               const Decode& decode, const Judge& judge) {
  using namespace certify;
  for (std::uint64_t i = 0; i < count; ++i) {
    Bytes mutant = bytes;
    const auto at = kHeaderSize + random() % (mutant.size() - kHeaderSize);
    const auto kind = i % 16;  // all three in every certificate
    if (kind == 0)
      mutant.resize(at);
    else if (kind < 5)
      mutant[at] = static_cast<std::uint8_t>(random());
    else
      mutant[at] ^= static_cast<std::uint8_t>(1U << random() % 8);
    if (mutant == bytes) continue;
    CHECK_FALSE(verify(mutant).accepted);
    try {
      rebind(mutant);
    } catch (const std::invalid_argument&) {
      continue;
    }
    try {
      const Container container = open_container(mutant);
      judge(decode(container.data, container.claims));
    } catch (const Malformed&) {
      CHECK_FALSE(verify(mutant).accepted);
    }
  }
}

}  // namespace crest::tests
