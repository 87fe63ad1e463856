// SPDX-License-Identifier: GPL-3.0-or-later
// The checker accepts the certificates, cuts included, on every surface, and needs the cuts.
#include <catch2/catch.hpp>

#include "algorithms/reeb/certificate.hpp"
#include "certify/verify.hpp"
#include "tests/reeb/graph_cases.hpp"
#include "tests/support/random.hpp"

namespace crest::tests {
namespace {

certify::ReebCertificate certificate_of(const Surface& s, const std::vector<double>& values) {
  const kernel::QuadraticMesh mesh(s.points, s.triangles, values);
  const reeb::TileComplex tiles = reeb::tessellate(mesh);
  return reeb::make_certificate(mesh, tiles, reeb::reeb_graph(reeb::ordered(tiles)));
}

TEST_CASE("certificates of Reeb graphs are accepted on every surface") {
  Random random(kSeed);
  for (const SurfaceRow& row : surface_rows()) {
    const Surface s = turned_at_random(row.make(), random);
    for (std::uint64_t seed = 0; seed < scaled(5); ++seed) {
      const std::vector<std::vector<double>> functions = {
          noise_values(s, kSeed + seed), smooth_values(s, kSeed + seed),
          quantised(noise_values(s, kSeed + seed), 0.25),
          std::vector<double>(s.points.size(), -0.0)};
      for (const auto& values : functions) {
        INFO(row.name << ", seed " << seed);
        const certify::ReebCertificate c = certificate_of(s, values);
        const certify::Verdict verdict = certify::verify(certify::encode(c));
        INFO(verdict.reason);
        CHECK(verdict.accepted);
        CHECK(c.euler_characteristic == row.euler);
      }
    }
  }
}

TEST_CASE("certificates of Reeb graphs that lack a cut are rejected where there are loops") {
  const Surface s = plate(14, 3, true);
  certify::ReebCertificate c = certificate_of(s, noise_values(s, kSeed));
  REQUIRE(c.cuts.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    certify::ReebCertificate less = c;
    less.cuts.erase(less.cuts.begin() + static_cast<std::ptrdiff_t>(i));
    CHECK_FALSE(certify::verify(certify::encode(less)).accepted);
  }
}

}  // namespace
}  // namespace crest::tests
