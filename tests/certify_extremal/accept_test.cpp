// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 8: true certificates are accepted, with the counts that the sheets have.
#include <catch2/catch.hpp>

#include "certify/extremal/encode.hpp"
#include "certify/verify.hpp"
#include "tests/certify_extremal/extremal_samples.hpp"

using namespace crest::certify;
using namespace crest::tests;

namespace {

void require_accepted(const ExtremalCertificate& c) {
  const Verdict verdict = verify(encode(c));
  INFO(verdict.reason);
  for (const auto& line : verdict.lines) UNSCOPED_INFO(line);
  REQUIRE(verdict.accepted);
}
std::size_t largest(const ExtremalCertificate& c) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < c.components.size(); ++i)
    if (c.components[i].polygons > c.components[best].polygons) best = i;
  return best;
}

}  // namespace

TEST_CASE("extremal: a sphere is one closed component, isotopic to the field's") {
  const auto c = reference_extremal(with_level(sampled({20, 20, 20}, sphere), 0.4));
  require_accepted(c);
  REQUIRE(c.components.size() == 1);
  CHECK(c.components[0].euler_characteristic == 2);
  CHECK(c.components[0].loops == 0);
  CHECK(c.components[0].orientable);
  CHECK_FALSE(c.components[0].cut);
  CHECK(c.components[0].isotopic);
  CHECK(c.components[0].extremal);
  CHECK(c.odd_faces == 0);
}

TEST_CASE("extremal: a Moebius strip is not orientable and has one boundary loop") {
  const auto c = reference_extremal(with_level(sampled({26, 26, 20}, moebius), 0.4));
  require_accepted(c);
  REQUIRE_FALSE(c.components.empty());
  const auto& strip = c.components[largest(c)];
  CHECK(strip.euler_characteristic == 0);
  CHECK(strip.loops == 1);
  CHECK_FALSE(strip.orientable);
  CHECK_FALSE(strip.isotopic);
}
