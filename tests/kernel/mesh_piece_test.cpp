// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/geometry/mesh_piece.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/support/closed_surfaces.hpp"
#include "tests/support/ragged_mesh.hpp"
#include "tests/support/random.hpp"

using namespace crest;
using kernel::Index;
using kernel::MeshPart;
using kernel::Role;
using kernel::TriangleMesh;

namespace {

std::vector<Index> in_whole(const MeshPart& part, std::span<const Index> numbers) {
  std::vector<Index> r;
  for (const Index v : numbers) r.push_back(part.vertices[v]);
  return r;
}

/// The part's fans are the whole's wherever no face is missing, and its edges are in that order.
void check_part(const TriangleMesh& whole, const MeshPart& part, std::span<const Index> owned,
                Index rings) {
  const TriangleMesh mesh(part.points, part.faces);  // throws where it is no manifold
  const kernel::MeshPiece piece(mesh, part);
  CHECK(std::is_sorted(part.vertices.begin(), part.vertices.end()));
  CHECK(in_whole(part, piece.owned_vertices()) == std::vector<Index>(owned.begin(), owned.end()));
  std::vector<Index> reached(owned.begin(), owned.end());
  for (Index ring = 1; ring < rings; ++ring)
    for (std::size_t i = 0, n = reached.size(); i < n; ++i)
      for (const Index w : whole.ring(reached[i])) reached.push_back(w);
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const Index name = part.vertices[v];
    const auto around = whole.ring(name);
    const bool all = mesh.fan(v).size() == whole.fan(name).size();
    CHECK(piece.is_inner(v) == all);
    if (all)
      CHECK(in_whole(part, mesh.ring(v)) == std::vector<Index>(around.begin(), around.end()));
  }
  for (const Index name : reached) {
    const auto at = std::lower_bound(part.vertices.begin(), part.vertices.end(), name);
    REQUIRE((at != part.vertices.end() && *at == name));
    CHECK(piece.is_inner(static_cast<Index>(at - part.vertices.begin())));
  }
}

TriangleMesh mesh_of(const tests::Surface& s) {
  return {s.points, s.triangles};
}

}  // namespace

TEST_CASE("mesh pieces: cuts own every point once") {
  tests::Random random(3);
  for (const std::size_t n : {1U, 5U, 64U, 1000U}) {
    std::vector<kernel::Vec3> points(n);
    for (auto& p : points)
      for (double& x : p) x = double(random() % 7);  // with ties
    for (const Index count : {1U, 2U, 7U, 64U}) {
      const auto parts = kernel::cut_points(points, count);
      CHECK(parts.size() == std::min<std::size_t>(count, n));
      std::vector<int> owners(n);
      for (const auto& part : parts) {
        CHECK(std::is_sorted(part.begin(), part.end()));
        CHECK(part.size() <= n / parts.size() + 3);
        for (const Index v : part) ++owners[v];
      }
      CHECK(std::all_of(owners.begin(), owners.end(), [](int k) { return k == 1; }));
    }
  }
}

TEST_CASE("mesh pieces: fans of owned and inner vertices are those of the whole") {
  for (const tests::Surface& s :
       {tests::icosphere(3), tests::torus_surface(24, 12), tests::plate(15, 2, false)}) {
    const TriangleMesh mesh = mesh_of(s);
    for (const Index count : {2U, 7U, 64U})
      for (const auto& owned : kernel::cut_points(mesh.points(), count))
        for (const Index rings : {1U, 2U, 4U})
          check_part(mesh, kernel::mesh_part(mesh, owned, rings), owned, rings);
  }
}

TEST_CASE("mesh pieces: scattered owners, whose parts have vertices with several fans") {
  const TriangleMesh mesh = mesh_of(tests::icosphere(3));
  tests::Random random(8);
  std::size_t closed = 0;
  for (int trial = 0; trial < 40; ++trial) {
    std::vector<Index> owned;
    for (Index v = 0; v < mesh.vertex_count(); ++v)
      if (random() % 12 == 0) owned.push_back(v);
    const MeshPart part = kernel::mesh_part(mesh, owned, 1);
    std::vector<std::uint8_t> asked(mesh.face_count());
    for (const Index v : owned)
      for (const Index f : mesh.fan(v)) asked[f] = 1;
    closed +=
        part.faces.size() > static_cast<std::size_t>(std::count(asked.begin(), asked.end(), 1));
    check_part(mesh, part, owned, 1);
  }
  CHECK(closed > 20);  // faces had to be added
}

TEST_CASE("mesh pieces: a vertex each, of ragged parts without inner vertices") {
  tests::Random random(41);
  for (const Index n : {1U, 3U, 7U}) {
    const TriangleMesh mesh = tests::ragged_mesh(n, random);
    const auto cut = kernel::cut_points(mesh.points(), 2 * mesh.vertex_count());
    CHECK(cut.size() == mesh.vertex_count());
    for (const auto& owned : cut)
      for (const Index rings : {1U, 2U, 4U})
        check_part(mesh, kernel::mesh_part(mesh, owned, rings), owned, rings);
  }
}
