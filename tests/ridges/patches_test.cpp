// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/ridges/patches.hpp"

#include <catch2/catch.hpp>
#include <map>
#include <set>

#include "tests/ridges/ridge_cases.hpp"

using namespace crest;
using namespace crest::tests;
using kernel::Index;

namespace {

// Closure's Euler characteristic, connectedness through sides, one fan at every vertex.
bool is_disk(const kernel::TriangleMesh& mesh, const std::vector<Index>& faces) {
  const std::set<Index> in(faces.begin(), faces.end());
  std::set<Index> vertices, edges;
  std::map<Index, int> fan_gaps;  // contour sides leaving a vertex: one a fan
  std::set<Index> reached{faces[0]};
  std::vector<Index> queue{faces[0]};
  while (!queue.empty()) {
    const Index f = queue.back();
    queue.pop_back();
    for (int k = 0; k < 3; ++k) {
      const Index g = mesh.neighbour(f, k);
      if (g != kernel::kNone && in.count(g) && reached.insert(g).second) queue.push_back(g);
    }
  }
  for (Index f : faces)
    for (int k = 0; k < 3; ++k) {
      const auto i = static_cast<std::size_t>(k);
      vertices.insert(mesh.faces()[f][i]);
      edges.insert(mesh.face_edges()[f][i]);
      const Index g = mesh.neighbour(f, k);
      if (g == kernel::kNone || !in.count(g)) ++fan_gaps[mesh.faces()[f][i]];
    }
  for (const auto& [v, gaps] : fan_gaps)
    if (gaps != 1) return false;
  const auto chi = static_cast<long>(vertices.size()) - static_cast<long>(edges.size()) +
                   static_cast<long>(faces.size());
  return chi == 1 && reached.size() == faces.size();
}

}  // namespace

TEST_CASE("patches are disks of the wanted size") {
  const std::vector<RidgeCase> shapes = {exact_case("ellipsoid", {1, 1.5, 2}, 640, true),
                                         exact_case("torus", {}, 300, true),
                                         exact_case("plane", {}, 300, true)};
  for (const RidgeCase& c : shapes) {
    ridges::PatchGrower grower(c.mesh);
    std::vector<ridges::PatchFace> table;
    for (Index f = 0; f < c.mesh.face_count(); ++f) table.push_back(ridges::patch_face(c.mesh, f));
    ridges::PatchGrower by_table(c.mesh, table);
    const std::vector<Index> nobody(c.mesh.face_count(), kernel::kNone);
    for (double size : {0.0, 1.0, 3.0, 20.0})
      for (Index seed = 0; seed < c.mesh.face_count(); seed += 37) {
        const auto& faces = grower.grow(seed, size, nobody);
        REQUIRE(faces[0] == seed);
        REQUIRE(by_table.grow(seed, size, nobody) == faces);
        REQUIRE(is_disk(c.mesh, faces));
        if (size == 0) REQUIRE(faces.size() == 1);
        if (size == 1) REQUIRE(faces.size() > 4);
      }
  }
}

TEST_CASE("patches of umbilics are disjoint disks") {
  RidgeCase c = exact_case("ellipsoid", {1, 1.5, 2}, 2500, true);
  c.forms = random_forms(c.forms.size(), Family::generic, 5);
  const ridges::RidgeGraph g = ridges::extract_ridge_graph(c.mesh, c.forms);
  std::set<Index> used;
  for (const ridges::Umbilic& u : g.umbilics) {
    REQUIRE(is_disk(c.mesh, u.patch));
    for (Index f : u.patch) REQUIRE(used.insert(f).second);
  }
}
