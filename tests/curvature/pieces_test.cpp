// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes cut into pieces: joined, the curvatures are those of the whole, byte for byte.
#include "algorithms/curvature/pieces.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstring>

#include "algorithms/sampling/mesh_surface.hpp"
#include "tests/support/ragged_mesh.hpp"

using namespace crest;
using namespace crest::curvature;
using kernel::TriangleMesh;

namespace {

std::vector<double> numbers_of(const Result& r) {
  std::vector<double> n;
  for (const PointCurvature& c : r.vertices)
    for (const double x :
         {c.k1, c.k2, c.K, c.H, c.asymmetry, c.d1[0], c.d1[1], c.d1[2], c.d2[0], c.d2[1], c.d2[2]})
      n.push_back(x);
  for (const Vec3& normal : r.normals) n.insert(n.end(), normal.begin(), normal.end());
  return n;
}

/// Bit by bit: 0 is not -0.
bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

}  // namespace

TEST_CASE("curvature pieces: 2, 7 and 64 pieces have the bytes of the whole, by all methods") {
  for (const char* name : {"ellipsoid", "umbilic-patch"}) {
    auto sample = sampling::sample(name, {}, 700, true);
    sampling::add_normal_noise(sample.points, sampling::normals(sample), 0.01, 3);
    std::reverse(sample.faces.begin(), sample.faces.end());
    const TriangleMesh mesh(sample.points, sample.faces);
    for (const Method method : kMethods) {
      Options o;
      o.method = method;
      o.rings = 2;
      if (method == Method::np || method == Method::cf) o.normals = sampling::normals(sample);
      const Result whole = estimate(mesh, o);
      for (const Index pieces : {2U, 7U, 64U}) {
        INFO(name << ", " << name_of(method) << ", " << pieces << " pieces");
        const Workers workers = workers_here(pieces);
        const Result joined = estimate(mesh, o, &workers);
        CHECK(same_bits(numbers_of(joined), numbers_of(whole)));
        CHECK(joined.lowered == whole.lowered);
        CHECK(joined.complex == whole.complex);
        CHECK(joined.undetermined == whole.undetermined);
      }
    }
  }
}

TEST_CASE("curvature pieces: a jet whose rings reach the rim is asked for again") {
  const auto sample = sampling::sample("sphere", {}, 2000, true);
  const TriangleMesh mesh(sample.points, sample.faces);
  Options o;
  o.method = Method::jet;
  o.jet_points = 300;  // ten rings or so, more than are guessed
  Workers workers = workers_here(4);
  const auto plain = workers.estimates;
  std::vector<std::size_t> left;
  workers.estimates = [&](std::size_t jobs, const auto& job) {
    auto r = plain(jobs, job);
    left.push_back(0);
    for (const Records& records : r) left.back() += records.left.size();
    return r;
  };
  const Result joined = estimate(mesh, o, &workers);
  CHECK(left.size() > 1);
  CHECK(left.front() > 0);
  CHECK(left.back() == 0);
  CHECK(same_bits(numbers_of(joined), numbers_of(estimate(mesh, o))));
}

TEST_CASE("curvature pieces: a vertex each, of ragged parts without inner vertices") {
  tests::Random random(43);
  for (const Index n : {1U, 4U, 10U}) {
    const TriangleMesh mesh = tests::ragged_mesh(n, random);
    for (const Method method : kMethods) {
      Options o;
      o.method = method;
      o.rings = 2;
      if (method == Method::np) o.normals = area_weighted_normals(mesh);
      INFO(mesh.vertex_count() << " vertices, " << name_of(method));
      const Workers workers = workers_here(2 * mesh.vertex_count());
      const Result whole = estimate(mesh, o), joined = estimate(mesh, o, &workers);
      CHECK(same_bits(numbers_of(joined), numbers_of(whole)));
      CHECK(joined.lowered == whole.lowered);
      CHECK(joined.complex == whole.complex);
      CHECK(joined.undetermined == whole.undetermined);
    }
  }
}
