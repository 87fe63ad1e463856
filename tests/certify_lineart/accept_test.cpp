// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 15: the checker against all pairs in rationals, and views without a generic point.
#include <catch2/catch.hpp>
#include <cmath>

#include "certify/lineart/encode.hpp"
#include "certify/verify.hpp"
#include "tests/certify_lineart/reference_drawing.hpp"
#include "tests/certify_lineart/scenes.hpp"

using namespace crest::certify;
using namespace crest::tests;

namespace {

TEST_CASE("line art: what all pairs in rationals give is accepted") {
  std::size_t tried = 0, pieces = 0, events = 0;
  for (std::uint64_t seed = 1; seed <= scaled(400); ++seed) {
    Random random(seed);
    const auto drawing = reference_drawing(random_soup(random, seed % 2 == 0, 1000));
    if (!drawing) continue;
    ++tried;
    const Verdict verdict = verify(encode(*drawing));
    INFO("seed " << seed << ": " << verdict.reason);
    REQUIRE(verdict.accepted);
    for (const LineEdge& edge : drawing->edges) {
      pieces += edge.pieces.size();
      events += edge.breaks.size();
    }
  }
  CHECK(tried > scaled(300));
  CHECK(events > tried);
  CHECK(pieces > 2 * events);
}

TEST_CASE("line art: hatches are judged as all pairs in rationals do") {
  std::size_t good = 0, bad = 0;
  for (std::uint64_t seed = 1; seed <= scaled(200); ++seed) {
    Random random(seed);
    LineArtCertificate soup = random_soup(random, seed % 2 == 0, 16);
    if (soup.parallel) soup.view.scale = {1.0 / 256, 1.0 / 4096};
    auto drawing = reference_drawing(soup);
    if (!drawing) continue;
    for (int k = 0; k < 20; ++k) {
      const auto number = [&](double width) {
        return width * (static_cast<double>(random() % 2000001) / 1000000 - 1);
      };
      std::array<double, 2> at = {number(20), number(20)};
      std::vector<std::array<double, 2>> hatch = {at};
      for (std::size_t n = 1 + random() % 3; n > 0; --n) {
        at = {at[0] + number(3), at[1] + number(3)};
        hatch.push_back(at);
      }
      const auto face = static_cast<std::uint32_t>(random() % drawing->faces.size());
      const auto expected = reference_hatch(*drawing, hatch, face);
      if (!expected) continue;
      LineArtCertificate c = *drawing;
      c.hatches = {hatch};
      c.hatch_faces = {face};
      const Verdict verdict = verify(encode(c));
      INFO("seed " << seed << ", hatch " << k << ": " << verdict.reason);
      CHECK(verdict.accepted == *expected);
      ++(*expected ? good : bad);
    }
  }
  CHECK(good > 20);
  CHECK(bad > 200);
}

}  // namespace
