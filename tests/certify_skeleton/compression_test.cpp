// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 10: two fields with one skeleton are accepted, and no other two.
#include <catch2/catch.hpp>
#include <iostream>

#include "certify/compression/encode.hpp"
#include "certify/verify.hpp"
#include "tests/certify_skeleton/reference_compression.hpp"
#include "tests/support/verdicts.hpp"

using namespace crest::certify;
using namespace crest::tests;

namespace {}  // namespace

TEST_CASE("compression: a field is equal to itself, in all notions") {
  for (const auto& field : {lattice_field(1, 4, 12, true), lattice_field(4, 9, 36, false)}) {
    const auto skeleton = reference_skeleton(field);
    for (const auto notion :
         {SkeletonNotion::strong, SkeletonNotion::original, SkeletonNotion::relaxed}) {
      const auto c = claim_of(field, skeleton, field.triangles, notion);
      const Verdict verdict = verify(encode(c));
      CHECK(verdict.reason == "");
      CHECK(verdict.accepted);
    }
  }
}

TEST_CASE("compression: collapses that keep the skeleton are accepted, others refused") {
  Random random(kSeed);
  const auto field = lattice_field(1, 4, 12, true);
  for (const auto notion : {SkeletonNotion::strong, SkeletonNotion::original}) {
    const auto c = reference_compression(field, notion, 200, random);
    CHECK(reason(c) == "");
    std::cout << "compression: " << c.input.triangles.size() << " triangles, "
              << c.output.triangles.size() << " left\n";
    CHECK(c.output.triangles.size() < c.input.triangles.size());
  }
}
