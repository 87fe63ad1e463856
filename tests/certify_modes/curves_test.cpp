// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 7: what can be said without a producer.
#include <catch2/catch.hpp>
#include <numeric>

#include "certify/modes_curves/encode.hpp"
#include "certify/verify.hpp"
#include "tests/certify_modes/modes_samples.hpp"

using namespace crest::certify;
using namespace crest::tests;

namespace {

ModesCurvesCertificate without_curves(const ModesInput& input) {
  ModesCurvesCertificate c;
  c.points = input.points;
  c.tets = input.tets;
  c.tensors = input.tensors;
  return c;
}

}  // namespace

TEST_CASE("modes-curves: a field without degenerate tensors has no curves") {
  LinearField field{};
  field[0] = {1, 0, 0, 0, 0};
  field[1] = {0.1, 0, 0.1, 0, 0};
  field[2] = {0, 0.1, 0, 0.1, 0};
  field[3] = {0, 0, 0, 0.1, 0.1};
  const auto c = without_curves(grid(1, -1, 1, field));
  const Verdict verdict = verify(encode(c));
  INFO(verdict.reason);
  CHECK(verdict.accepted);
  auto wrong = c;
  wrong.linear.open = 1;
  CHECK_FALSE(verify(encode(wrong)).accepted);
}

TEST_CASE("modes-curves: curves may be left out where all is special only") {
  for (const auto& field : kReferenceFields) {
    auto c = without_curves(grid(1, -2, 2, field));
    const Verdict verdict = verify(encode(c));
    INFO(verdict.reason);
    CHECK_FALSE(verdict.accepted);
    CHECK(verdict.reason.find("degenerate point in no listed box") != std::string::npos);
    c.special_tets.resize(c.tets.size());
    std::iota(c.special_tets.begin(), c.special_tets.end(), 0);
    CHECK_FALSE(verify(encode(c)).accepted);
  }
}
