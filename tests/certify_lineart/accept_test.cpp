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
  for (std::uint64_t seed = 1; seed <= scaled(100); ++seed) {
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
  CHECK(tried > scaled(70));
  CHECK(events > tried);
  CHECK(pieces > 2 * events);
}

TEST_CASE("line art: hatches are judged as all pairs in rationals do") {
  std::size_t good = 0, bad = 0;
  for (std::uint64_t seed = 1; seed <= scaled(16); ++seed) {
    Random random(seed);
    LineArtCertificate soup = random_soup(random, seed % 2 == 0, 16);
    if (soup.parallel) soup.view.scale = {1.0 / 256, 1.0 / 4096};
    auto drawing = reference_drawing(soup);
    if (!drawing) continue;
    for (int k = 0; k < 24; ++k) {
      const auto reach = static_cast<double>(1 + random() % 40) / 16;
      auto hatch = hatch_on(*drawing, static_cast<std::uint32_t>(random() % drawing->faces.size()),
                            random() % 3, reach);
      if (k % 4 == 0) hatch.push_back({hatch[0][0], hatch[1][1] + 0.5});
      const auto truth = reference_hatch(*drawing, hatch);
      if (!truth) continue;
      // The right face, if there is one, for two of three.
      auto face = static_cast<std::uint32_t>(random() % drawing->faces.size());
      if (k % 3 != 0 && !truth->faces.empty()) face = truth->faces[0];
      const bool expected = !truth->crosses && truth->faces == std::vector<std::uint32_t>{face};
      LineArtCertificate c = *drawing;
      c.hatches = {hatch};
      c.hatch_faces = {face};
      const Verdict verdict = verify(encode(c));
      INFO("seed " << seed << ", hatch " << k << ": " << verdict.reason);
      CHECK(verdict.accepted == expected);
      ++(expected ? good : bad);
    }
  }
  CHECK(good > 20);
  CHECK(bad > 60);
}

}  // namespace
