// SPDX-License-Identifier: GPL-3.0-or-later
// Half-edges of meshes without places: who faces whom, and what is refused.
#include "kernel/geometry/corner_table.hpp"

#include <catch2/catch.hpp>

#include "kernel/geometry/input_error.hpp"

namespace crest::kernel {
namespace {

std::string refusal(Index vertices, const std::vector<Triangle>& faces) {
  try {
    CornerTable(vertices, faces);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST_CASE("corner table: half-edges face each other in pairs") {
  const std::vector<Triangle> faces = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  const CornerTable sphere(4, faces);
  CHECK(sphere.face_count() == 4);
  const auto end = [&](Index h, Index k) { return faces[h / 3][(h + k) % 3]; };
  for (Index h = 0; h < 12; ++h) {
    const Index o = sphere.opposite(h);
    REQUIRE(o != kNone);
    CHECK(sphere.opposite(o) == h);
    CHECK(end(h, 0) == end(o, 1));
    CHECK(end(h, 1) == end(o, 0));
    CHECK(previous_half(next_half(h)) == h);
    CHECK(next_half(h) / 3 == h / 3);
  }
}

TEST_CASE("corner table: a boundary vertex begins with the boundary") {
  const std::vector<Triangle> fan = {{0, 2, 3}, {0, 1, 2}, {0, 3, 4}};
  const CornerTable disc(5, fan);
  CHECK(disc.half_of(0) == 3);  // 0 1 of face 1
  CHECK(disc.opposite(3) == kNone);
  CHECK(disc.opposite(previous_half(3)) == 0);
}

TEST_CASE("corner table: what is no oriented manifold is refused by name") {
  CHECK(refusal(3, {}).find("no faces") != std::string::npos);
  CHECK(refusal(2, {{0, 1, 2}}).find("out of range") != std::string::npos);
  CHECK(refusal(3, {{0, 1, 1}}).find("repeats a vertex") != std::string::npos);
  CHECK(refusal(4, {{0, 1, 2}}).find("vertex 3: it belongs to no face") != std::string::npos);
  CHECK(refusal(3, {{0, 1, 2}, {1, 2, 0}}).find("duplicates face 0") != std::string::npos);
  CHECK(refusal(3, {{0, 1, 2}, {0, 2, 1}}).find("duplicates face 0") != std::string::npos);
  CHECK(refusal(4, {{0, 1, 2}, {0, 1, 3}}).find("edge 0-1") != std::string::npos);
  CHECK(refusal(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}).find("edge 0-1") != std::string::npos);
  CHECK(refusal(5, {{0, 1, 2}, {0, 3, 4}}).find("vertex 0: several fans") != std::string::npos);
  // Two tetrahedra that share a vertex.
  CHECK(
      refusal(
          7,
          {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}, {0, 4, 5}, {0, 5, 6}, {0, 6, 4}, {4, 6, 5}})
          .find("vertex 0: several fans") != std::string::npos);
}

}  // namespace
}  // namespace crest::kernel
