// SPDX-License-Identifier: GPL-3.0-or-later
// Strips: every face once and turned as it is, the number of vertices sent, the cache.
#include "algorithms/strips/strips.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <numeric>

#include "algorithms/strips/tree_links.hpp"
#include "algorithms/strips/vertex_cache.hpp"
#include "io/read/mesh_reader.hpp"
#include "io/strips/strip_writer.hpp"
#include "kernel/geometry/input_error.hpp"
#include "tests/support/random.hpp"
#include "tests/support/shared_data.hpp"

namespace crest::strips {
namespace {

using tests::Random;

/// m n vertices on a torus; without the last column or row of squares a cylinder or a disc.
std::vector<Triangle> grid(Index m, Index n, bool round, bool high) {
  std::vector<Triangle> faces;
  for (Index j = 0; j < n - (high ? 0 : 1); ++j)
    for (Index i = 0; i < m - (round ? 0 : 1); ++i) {
      const Index a = i + m * j, b = (i + 1) % m + m * j, c = (i + 1) % m + m * ((j + 1) % n),
                  d = i + m * ((j + 1) % n);
      faces.push_back({a, b, c});
      faces.push_back({a, c, d});
    }
  return faces;
}

/// A disc or sphere whose faces come in any order and begin with any corner.
std::vector<Triangle> stacked(Index vertices, Random& random) {
  std::vector<Triangle> faces = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  for (Index v = 4; v < vertices; ++v) {
    Triangle& t = faces[random() % faces.size()];
    const auto [a, b, c] = t;
    t = {a, b, v};
    faces.push_back({b, c, v});
    faces.push_back({c, a, v});
  }
  std::shuffle(faces.begin(), faces.end(), random);
  for (Triangle& t : faces)
    std::rotate(t.begin(), t.begin() + static_cast<std::ptrdiff_t>(random() % 3), t.end());
  return faces;
}

Strips strips_of(const std::vector<Triangle>& faces, Index vertices, const StripOptions& options) {
  return strips::strips_of(CornerTable(vertices, faces), faces, Links(faces.size(), 0), options);
}

void check_strips(const std::vector<Triangle>& faces, Index vertices) {
  for (const int effort : {0, 1, 20})
    for (const bool swaps : {false, true}) {
      INFO(faces.size() << " faces, effort " << effort << ", swaps " << swaps);
      const Strips s = strips_of(faces, vertices, {effort, swaps});
      CHECK(covers(s, faces));
      CHECK(s.vertices.size() == faces.size() + 2 * s.count() + s.swaps);
      CHECK((swaps || s.swaps == 0));
      const Strips ordered = in_cache_order(s, vertices, 16);
      CHECK(covers(ordered, faces));
      CHECK(ordered.vertices.size() == s.vertices.size());
      CHECK(ordered.count() == s.count());
    }
}

TEST_CASE("strips hold every face once, turned as it is") {
  check_strips({{0, 1, 2}}, 3);
  check_strips({{0, 1, 2}, {3, 4, 5}}, 6);
  for (const bool round : {false, true})
    for (const bool high : {false, true})
      for (const Index m : {3u, 4u, 7u, 20u}) check_strips(grid(m, 5, round, high), 5 * m);
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    const auto vertices = static_cast<Index>(4 + random() % 300);
    check_strips(stacked(vertices, random), vertices);
  }
}

TEST_CASE("a grid's row is one strip without a swap") {
  const std::vector<Triangle> row = grid(50, 2, false, false);
  const Strips s = strips_of(row, 100, {100, true});
  CHECK(s.count() == 1);
  CHECK(s.swaps <= 1);  // from one end the first turn is the wrong one
  CHECK(s.vertices.size() == row.size() + 2 + s.swaps);
}

TEST_CASE("a closed fan costs a swap a face but for its first three") {
  std::vector<Triangle> fan;
  for (Index k = 0; k < 9; ++k) fan.push_back({0, k + 1, k + 2});
  Links links(fan.size(), 0b101);
  links.front() = 0b100;
  links.back() = 0b001;
  const Strips s = strips::strips_of(CornerTable(11, fan), fan, links, {0, true});
  CHECK(s.count() == 1);
  CHECK(covers(s, fan));
  CHECK(s.swaps == fan.size() - 3);
}

TEST_CASE("strips that lack a face, have one twice or turned are seen") {
  const std::vector<Triangle> faces = grid(6, 6, true, true);
  const Strips good = strips_of(faces, 36, {20, true});
  REQUIRE(covers(good, faces));
  std::vector<Triangle> wrong = faces;
  std::swap(wrong[5][0], wrong[5][1]);
  CHECK_FALSE(covers(good, wrong));
  wrong = faces;
  wrong.pop_back();
  CHECK_FALSE(covers(good, wrong));
  wrong = faces;
  wrong[3] = wrong[4];
  CHECK_FALSE(covers(good, wrong));
  Strips moved = good;
  std::swap(moved.vertices[4], moved.vertices[5]);
  CHECK_FALSE(covers(moved, faces));
}

TEST_CASE("strips do not depend on anything but the mesh") {
  Random random(7);
  const std::vector<Triangle> faces = stacked(500, random);
  CHECK(strips_of(faces, 500, {20, true}).vertices == strips_of(faces, 500, {20, true}).vertices);
}

TEST_CASE("annealing does not make good strips worse") {
  const std::vector<Triangle> row = grid(60, 2, false, false);
  Links links(row.size());
  // Squares a b c, a c d: over the diagonal, and over bc to the next square's ad.
  for (Index f = 0; f < row.size(); ++f) links[f] = f % 2 == 0 ? 0b110 : 0b101;
  links[row.size() - 2] = 0b100;
  links[1] = 0b001;
  const CornerTable mesh(120, row);
  const Strips start = strips::strips_of(mesh, row, links, {0, true});
  REQUIRE(start.count() == 1);
  for (const int effort : {1, 5, 20})
    CHECK(strips::strips_of(mesh, row, links, {effort, true}).vertices.size() <=
          start.vertices.size());
}

TEST_CASE("strips of the tree: at most t + v - 1 vertices on discs, three more on spheres") {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    const auto vertices = static_cast<Index>(4 + random() % 400);
    std::vector<Triangle> faces = stacked(vertices, random);
    const bool disc = seed % 2 == 0 && faces.size() > 4;
    if (disc) faces.pop_back();
    const CornerTable mesh(vertices, faces);
    const Strips s =
        strips::strips_of(mesh, faces, tree_links(mesh, faces), {.effort = 0, .swaps = true});
    INFO("seed " << seed);
    CHECK(covers(s, faces));
    CHECK(s.vertices.size() <= faces.size() + vertices - 1 + (disc ? 0 : 3));
  }
}

TEST_CASE("average cache misses: bounds and a case by hand") {
  Strips s;
  s.vertices = {0, 1, 2, 3, 0, 4};
  s.begin = {0, 6};
  // 0 1 2 3 miss; the second 0 hits with four entries, misses with three; 4 misses.
  CHECK(average_cache_miss_ratio(s, 5, 1, 4) == 5);
  CHECK(average_cache_miss_ratio(s, 5, 1, 3) == 6);
  const std::vector<Triangle> faces = grid(30, 30, true, true);
  const Strips strips = in_cache_order(strips_of(faces, 900, {20, true}), 900, 16);
  const double ratio = average_cache_miss_ratio(strips, 900, faces.size(), 16);
  CHECK(ratio >= 0.5);
  CHECK(ratio <= static_cast<double>(strips.vertices.size()) / static_cast<double>(faces.size()));
}

TEST_CASE("strips of real meshes save what they are known to") {
  struct Known {
    const char* file;
    double tree, improved;  // per cent, 20 sweeps
  };
  for (const Known& k :
       {Known{"meshes/fandisk.off", 60.6, 62.6}, Known{"meshes/rocker-arm.obj", 55.6, 58.6},
        Known{"meshes/stanford-bunny.obj", 59.6, 62.1},
        Known{"thesis-meshes/mannequin_11703.off", 62.2, 63.7},
        Known{"thesis-meshes/venus.off", 54.7, 58.2}}) {
    const auto path = tests::shared_data(k.file);
    if (!path) return;
    INFO(k.file);
    const io::MeshFile file = io::read_mesh(*path);
    const std::vector<Triangle>& faces = file.mesh.faces();
    const CornerTable mesh(file.mesh.vertex_count(), faces);
    const Links tree = tree_links(mesh, faces);
    const auto saved = [&](int effort) {
      const Strips s = strips::strips_of(mesh, faces, tree, {effort, true});
      CHECK(covers(s, faces));
      return saved_per_cent(s, faces.size());
    };
    CHECK(saved(0) >= k.tree);
    CHECK(saved(20) >= k.improved);
  }
}

TEST_CASE("strips are written to .vtp only") {
  CHECK_THROWS_AS(io::write_strips("strips.obj", {}, {}), kernel::InputError);
}

}  // namespace
}  // namespace crest::strips
