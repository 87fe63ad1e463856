// SPDX-License-Identifier: GPL-3.0-or-later
// The static code's bound where its fixed probabilities are used the most often: a strip of nearly
// all triangles (CREST_TEST_MULTIPLIER=100: 10^7 vertices).
#include <algorithm>
#include <catch2/catch.hpp>

#include "algorithms/coding/surface.hpp"
#include "kernel/geometry/strip_tree.hpp"
#include "tests/coding/meshes.hpp"

namespace crest::tests {
namespace {

using kernel::Index;
using kernel::Triangle;

/// A sphere: a helix of `turn` vertices a turn, both ends closed by a vertex.
std::vector<Triangle> helix(Index vertices, Index turn) {
  std::vector<Triangle> faces;
  const Index along = vertices - 2, first = along, last = along + 1;
  for (Index i = 0; i + turn + 1 < along; ++i) {
    faces.push_back({i, i + 1, i + turn + 1});
    faces.push_back({i, i + turn + 1, i + turn});
  }
  for (Index i = 0; i < turn; ++i) {
    faces.push_back({i + 1, i, first});
    faces.push_back({along - turn - 1 + i, along - turn + i, last});
  }
  faces.push_back({0, turn, first});
  faces.push_back({along - 1, along - turn - 1, last});
  return faces;
}

TEST_CASE(
    "static code: a strip of nearly all triangles of a sphere keeps to 3.4713 bits a vertex") {
  for (const Index turn : {3u, 4u}) {
    const auto vertices = static_cast<Index>(100000 * multiplier());
    const std::vector<Triangle> faces = helix(vertices, turn);
    const coding::Surface surface(vertices, faces);
    CHECK(surface.counts() == coding::Counts{.vertices = vertices});
    const auto tree = kernel::grow_strips(surface.table(), faces, kernel::StripExits::zigzag);
    Index longest = 0;
    for (const auto& node : tree.nodes) longest = std::max(longest, node.length);
    CHECK(longest > vertices / 2);
    const coding::EncodeOptions options{.method = coding::Method::fixed,
                                        .places = coding::Places::none};
    const auto encoded = coding::encode(vertices, faces, {}, options);
    CHECK(encoded.info.sizes.connectivity <= (34713 * std::uint64_t{vertices} + 79999) / 80000 + 8);
    CHECK(coding::decode(encoded.stream).faces.size() == faces.size());
  }
}

}  // namespace
}  // namespace crest::tests
