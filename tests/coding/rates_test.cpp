// SPDX-License-Identifier: GPL-3.0-or-later
// Sizes: those that were reached before, and the proven bound of the static code.
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <map>

#include "algorithms/coding/coding.hpp"
#include "tests/coding/shared_meshes.hpp"

namespace crest::tests {
namespace {

using coding::Method;
using coding::Places;

std::size_t connectivity_bytes(const PlainMesh& mesh, std::optional<Method> method = {}) {
  return coding::encode(mesh.vertices(), mesh.faces, {}, {.method = method, .places = Places::none})
      .info.sizes.connectivity;
}

/// What the smallest method of a prototype needed: to be reached within 1 % and 2 bytes.
const std::map<std::string, std::size_t> kToReach = {
    {"armadillo.off", 6373},  {"horse.ply", 7369},       {"stanford-bunny.obj", 4256},
    {"anchor.off", 139},      {"b9_mesh.off", 2109},     {"bones.off", 513},
    {"bunny_3k.off", 909},    {"cheese.off", 2478},      {"cube_no_bottom.obj", 9},
    {"dino.off", 433},        {"disk.obj", 670},         {"elephant.off", 674},
    {"fandisk.off", 679},     {"featuretype.STL", 322},  {"fertility.off", 1103},
    {"head.off", 234},        {"homer.obj", 588},        {"joint.off", 65},
    {"kitten.obj", 1061},     {"knot1.off", 203},        {"lilium.obj", 401},
    {"lion-head.off", 1671},  {"man.off", 3916},         {"max-planck_decimated.obj", 1467},
    {"penguin.obj", 359},     {"pinion.off", 101},       {"plane_holes.obj", 491},
    {"rocker-arm.obj", 2717}, {"rotor.off", 92},         {"spot.obj", 370},
    {"springer.obj", 373},    {"stratocaster.ply", 442}, {"torus.obj", 773}};

TEST_CASE("rates: connectivity of real meshes") {
  for (const auto& [name, bytes] : kToReach) {
    const auto path = shared_data("meshes/" + name);
    if (!path) return;
    INFO(name);
    CHECK(static_cast<double>(connectivity_bytes(read_plain(*path))) <=
          1.01 * static_cast<double>(bytes) + 2);
  }
}

/// Triangles around each polygon's first corner; the reader of meshes cuts otherwise.
std::vector<kernel::Triangle> fanned(const std::string& path, kernel::Index& vertices) {
  std::ifstream in(path);
  std::string word;
  kernel::Index polygons = 0, corners = 0, a = 0, b = 0, c = 0;
  in >> word >> vertices >> polygons >> word;
  for (kernel::Index k = 0; k < 3 * vertices; ++k) in >> word;
  std::vector<kernel::Triangle> faces;
  while (polygons-- > 0 && in >> corners >> a >> b)
    for (; corners > 2; --corners, b = c) {
      in >> c;
      faces.push_back({a, b, c});
    }
  return faces;
}

TEST_CASE("rates: the list's polygons, fanned, and the paper's meshes") {
  const auto polygons = shared_data("meshes/double-torus-example.off");
  if (!polygons) return;
  kernel::Index vertices = 0;
  const auto faces = fanned(*polygons, vertices);
  CHECK(faces.size() == 466);
  const coding::EncodeOptions bare{.places = Places::none};
  CHECK(coding::encode(vertices, faces, {}, bare).info.sizes.connectivity <= 75);
  const std::map<std::string, std::size_t> to_reach = {
      {"venus.off", 2750}, {"mannequin_11703.off", 523}, {"mannequin_428.off", 134}};
  for (const auto& [name, bytes] : to_reach) {
    const auto path = shared_data("thesis-meshes/" + name);
    if (!path) return;
    INFO(name);
    CHECK(static_cast<double>(connectivity_bytes(read_plain(*path))) <=
          1.01 * static_cast<double>(bytes) + 2);
  }
}

TEST_CASE("rates: the paper's meshes below Alliez and Desbrun's numbers") {
  const std::map<std::string, double> published = {{"meshes/fandisk.off", 1.02},
                                                   {"thesis-meshes/venus.off", 2.71},
                                                   {"thesis-meshes/mannequin_11703.off", 0.37},
                                                   {"thesis-meshes/mannequin_428.off", 2.51}};
  for (const auto& [name, bits] : published) {
    const auto path = shared_data(name);
    if (!path) return;
    INFO(name);
    const PlainMesh mesh = read_plain(*path);
    CHECK(8.0 * static_cast<double>(connectivity_bytes(mesh)) / mesh.vertices() < bits);
  }
}

TEST_CASE("rates: exact places of real meshes") {
  // Half a per cent above what is stored in experiments/001-coding.
  const std::map<std::string, double> bits = {{"meshes/fandisk.off", 21.78},
                                              {"meshes/bunny_3k.off", 61.38},
                                              {"thesis-meshes/venus.off", 27.08}};
  for (const auto& [name, most] : bits) {
    const auto path = shared_data(name);
    if (!path) return;
    INFO(name);
    const PlainMesh mesh = read_plain(*path);
    const auto encoded =
        coding::encode(mesh.vertices(), mesh.faces, mesh.points, {.method = Method::valence});
    CHECK(8.0 * static_cast<double>(encoded.info.sizes.geometry) / mesh.vertices() <= most);
  }
}

void check_bound(const PlainMesh& mesh, std::size_t components = 1) {
  const double bound = std::ceil(3.4713 * mesh.vertices() / 8) + 8 +
                       (components > 1 ? std::ceil(static_cast<double>(components) / 8) : 0);
  CHECK(static_cast<double>(connectivity_bytes(mesh, Method::fixed)) <= bound);
}

TEST_CASE("the bound 5 log2(phi): stacked and flipped triangulations") {
  Random random(kSeed);
  for (const kernel::Index v : {4u, 5u, 10u, 100u, 1000u, 20000u})
    for (const std::size_t flips : {0u, 1u, 10u}) {
      PlainMesh mesh = stacked_sphere(v, random);
      flip_edges(mesh, flips * mesh.faces.size(), random);
      INFO(v << " vertices, " << flips << " flips a face");
      check_bound(mesh);
      const std::size_t fixed = connectivity_bytes(mesh, Method::fixed);
      CHECK(connectivity_bytes(mesh) <= fixed);
      // (5 v - 12) log2(phi) bits, and nothing is lost.
      const double exact = (5.0 * v - 12) * std::log2((1 + std::sqrt(5.0)) / 2);
      CHECK(static_cast<double>(fixed) <= std::ceil(exact * (1 + 4e-6) / 8) + 4);
      mesh.faces.pop_back();
      check_bound(mesh);
    }
}

/// Long strips: rings of squares around an axis, all cut alike, with two caps.
PlainMesh tube(kernel::Index rings, kernel::Index around) {
  PlainMesh mesh;
  mesh.points.resize(std::size_t{rings} * around + 2);
  const kernel::Index first = rings * around, last = first + 1;
  for (kernel::Index j = 0; j < around; ++j) {
    const kernel::Index k = (j + 1) % around, end = (rings - 1) * around;
    mesh.faces.push_back({first, k, j});
    mesh.faces.push_back({last, end + j, end + k});
    for (kernel::Index i = 0; i + 1 < rings; ++i) {
      const kernel::Index a = i * around + j, b = i * around + k, c = b + around, d = a + around;
      mesh.faces.push_back({a, b, c});
      mesh.faces.push_back({a, c, d});
    }
  }
  return mesh;
}

TEST_CASE("the bound 5 log2(phi): long strips lose nothing by rounding") {
  check_bound(tube(static_cast<kernel::Index>(30000 * multiplier()), 8));
  check_bound(tube(8, static_cast<kernel::Index>(30000 * multiplier())));
  PlainMesh many;
  for (kernel::Index c = 0; c < 500; ++c) {
    const kernel::Index v = 4 * c;
    many.points.resize(v + 4);
    for (const kernel::Triangle f : {kernel::Triangle{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}})
      if (c % 2 == 0 || f[0] == 0) many.faces.push_back({f[0] + v, f[1] + v, f[2] + v});
  }
  check_bound(many, 500);
}

}  // namespace
}  // namespace crest::tests
