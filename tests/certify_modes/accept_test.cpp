// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 6: true certificates are accepted, with the counts that were found in other ways.
#include <catch2/catch.hpp>

#include "certify/modes/encode.hpp"
#include "certify/verify.hpp"
#include "tests/certify_modes/modes_samples.hpp"
#include "tests/support/verdicts.hpp"

using namespace crest::certify;
using namespace crest::tests;

namespace {

struct Sums {
  std::int32_t characteristic = 0;
  std::uint32_t components = 0, loops = 0;
  friend bool operator==(const Sums&, const Sums&) = default;
};
Sums sums(const SurfaceCounts& counts) {
  Sums s;
  for (const auto& c : counts.components) {
    s.characteristic += c.euler_characteristic;
    s.loops += c.boundary_loops;
    ++s.components;
  }
  return s;
}
std::string in_words(const Sums& s) {
  return std::to_string(s.characteristic) + "," + std::to_string(s.components) + "," +
         std::to_string(s.loops);
}

/// Neutral; + and - of 0.3, 0.6, 0.9: Euler characteristic, components, boundary loops in [-2,
/// 2]^3.
constexpr std::array<std::array<Sums, 7>, 6> kTable = {{
    {{{2, 2, 2}, {1, 2, 3}, {2, 2, 2}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}}},
    {{{1, 1, 1}, {2, 2, 2}, {1, 2, 3}, {2, 2, 2}, {1, 2, 3}, {0, 2, 4}, {0, 1, 2}}},
    {{{-1, 1, 1}, {-1, 1, 1}, {0, 1, 2}, {0, 1, 2}, {0, 1, 2}, {0, 1, 2}, {0, 1, 2}}},
    {{{-1, 1, 3}, {-1, 1, 3}, {-1, 1, 3}, {0, 1, 2}, {-1, 1, 3}, {1, 2, 3}, {-1, 1, 3}}},
    {{{0, 1, 2}, {0, 1, 2}, {-1, 1, 3}, {0, 1, 2}, {-1, 1, 3}, {0, 1, 2}, {0, 1, 2}}},
    {{{1, 1, 1}, {2, 2, 2}, {1, 1, 1}, {2, 2, 2}, {1, 1, 1}, {1, 2, 3}, {-1, 1, 3}}},
}};

}  // namespace

TEST_CASE("modes: the surfaces of linear fields are those of the table") {
  for (std::size_t f = 0; f < 6; ++f) {
    const auto c =
        reference_modes(grid(1, -2, 2, kReferenceFields[f]), {{0, 1}, {3, 10}, {3, 5}, {9, 10}});
    require_accepted(c);
    std::vector<Sums> found = {sums(c.levels[0].positive)};
    for (std::size_t l = 1; l < 4; ++l) {
      found.push_back(sums(c.levels[l].positive));
      found.push_back(sums(c.levels[l].negative));
      CHECK(c.levels[l].open_tets == 0);
    }
    for (std::size_t i = 0; i < 7; ++i) {
      CAPTURE(f + 1, i, in_words(found[i]), in_words(kTable[f][i]));
      CHECK(found[i] == kTable[f][i]);
    }
  }
}
