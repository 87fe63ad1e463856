// SPDX-License-Identifier: GPL-3.0-or-later
// Vertices of valence 3 are taken out and put back: section 4.3.6.
#include "algorithms/coding/clearance.hpp"

#include <catch2/catch.hpp>

#include "algorithms/coding/verify.hpp"
#include "tests/coding/meshes.hpp"

namespace crest::tests {
namespace {

using coding::Clearance;
using kernel::Index;
using kernel::Triangle;

/// What is left of a mesh: vertices, faces; none: nothing pays.
std::pair<std::size_t, std::size_t> cleared(const PlainMesh& mesh) {
  const coding::Surface surface(mesh.vertices(), mesh.faces);
  const Clearance clearance(surface);
  // That it is an oriented manifold of the same kind is looked at here.
  const coding::Surface left(clearance.vertices(), clearance.faces());
  auto counts = left.counts();
  counts.vertices = surface.counts().vertices;
  CHECK(counts == surface.counts());
  return {clearance.vertices(), clearance.faces().size()};
}

coding::Encoded check_round_trip(const PlainMesh& mesh, bool keep_order) {
  const coding::EncodeOptions options{.keep_order = keep_order};
  const auto encoded = coding::encode(mesh.vertices(), mesh.faces, mesh.points, options);
  CHECK_NOTHROW(coding::verify(encoded, mesh.faces, mesh.points, options));
  return encoded;
}

PlainMesh with_points(std::vector<Triangle> faces) {
  PlainMesh mesh;
  mesh.faces = std::move(faces);
  Index vertices = 0;
  for (const Triangle& f : mesh.faces)
    for (const Index v : f) vertices = std::max(vertices, v + 1);
  for (Index v = 0; v < vertices; ++v) mesh.points.push_back({double(v), double(v % 3), 1});
  return mesh;
}

TEST_CASE("clearance: never below a tetrahedron, never both sides of a triangle") {
  const PlainMesh tetrahedron = with_points({{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
  CHECK(cleared(tetrahedron) == std::pair<std::size_t, std::size_t>(4, 4));
  const PlainMesh two_pyramids =
      with_points({{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {1, 0, 4}, {2, 1, 4}, {0, 2, 4}});
  CHECK(cleared(two_pyramids) == std::pair<std::size_t, std::size_t>(4, 4));
  const PlainMesh disk = with_points({{0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
  CHECK(cleared(disk) == std::pair<std::size_t, std::size_t>(3, 1));
  for (const PlainMesh& mesh : {tetrahedron, two_pyramids, disk}) check_round_trip(mesh, false);
}

TEST_CASE("clearance: stacked spheres and surfaces with stacked faces come back, and shrink") {
  Random random(kSeed);
  std::size_t used = 0;
  for (int round = 0; round < 20 * multiplier(); ++round) {
    PlainMesh mesh = round % 2 == 0 ? stacked_sphere(200, random) : joined_tori(2, 6, 6);
    mesh = with_stacked_faces(std::move(mesh), 40, random);
    if (round % 3 == 0) mesh = punch_holes(mesh, 2, random);
    cleared(mesh);
    const auto encoded = check_round_trip(mesh, round % 5 == 0);
    used += encoded.info.cleared ? 1 : 0;
    std::size_t plain = encoded.info.sizes.connectivity;
    for (const auto method :
         {coding::Method::valence, coding::Method::fan, coding::Method::fixed}) {
      const coding::EncodeOptions options{.method = method, .places = coding::Places::none};
      plain = std::min(
          plain, coding::encode(mesh.vertices(), mesh.faces, {}, options).info.sizes.connectivity);
    }
    CHECK(encoded.info.sizes.connectivity <= plain);
  }
  CHECK(used > 0);
}

}  // namespace
}  // namespace crest::tests
