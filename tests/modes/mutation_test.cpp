// SPDX-License-Identifier: GPL-3.0-or-later
// The claim is accepted, and no changed one is that is not true of its own data.
#include <catch2/catch.hpp>

#include "algorithms/modes/certificate.hpp"
#include "certify/container/container.hpp"
#include "certify/modes/decode.hpp"
#include "certify/verify.hpp"
#include "tests/modes/samples.hpp"
#include "tests/support/failures.hpp"

using namespace crest::certify;
using namespace crest::tests;

namespace {

Bytes certificate() {
  const auto input = one_cell();
  return encode(crest::modes::make_certificate(input, crest::modes::take_census(input)));
}

/// Counted anew, by the producer. The data must be of the right form.
bool is_true(const Bytes& bytes) {
  const Container container = open_container(bytes);
  const auto c = decode_modes(container.data, container.claims);
  crest::modes::Input input;
  input.points = c.points;
  input.cells = c.cells;
  const auto census = crest::modes::take_census(input);
  return census.distinct == c.distinct && census.used == c.used;
}

}  // namespace

TEST_CASE("the certificate is accepted") {
  const Verdict verdict = verify(certificate());
  INFO(verdict.reason);
  CHECK(verdict.accepted);
  CHECK(verdict.lines.size() == 3);
}

TEST_CASE("every changed number of the claim is rejected") {
  const auto input = one_cell();
  const auto truth = crest::modes::make_certificate(input, crest::modes::take_census(input));
  for (const int change : {-1, 1}) {
    auto places = truth, used = truth;
    places.distinct += static_cast<std::uint32_t>(change);
    used.used += static_cast<std::uint32_t>(change);
    CHECK_FALSE(verify(encode(places)).accepted);
    CHECK_FALSE(verify(encode(used)).accepted);
  }
}

TEST_CASE("edited bytes, bound again, are rejected unless true") {
  const Bytes original = certificate();
  Random random(kSeed);
  std::uint64_t mutants = 0;
  for (std::uint64_t i = 0; i < scaled(2000); ++i) {
    Bytes mutant = original;
    const auto at = random() % mutant.size();
    if (random() % 4 == 0)
      mutant.resize(at);
    else
      mutant[at] ^= static_cast<std::uint8_t>(1U << random() % 8);
    const OnFailure shown([&] { return "byte, size " + in_braces(at, mutant.size()); });
    CHECK_FALSE(verify(mutant).accepted);
    try {
      rebind(mutant);
    } catch (const std::invalid_argument&) {
      continue;
    }
    ++mutants;
    if (verify(mutant).accepted) CHECK(is_true(mutant));
  }
  CHECK(mutants > scaled(2000) / 2);
}
