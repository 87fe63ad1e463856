// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 1 on frames that no surface has: accepted only with their number, which the verdict names.
#include <catch2/catch.hpp>

#include "certify/verify.hpp"
#include "tests/certify/reference_ridges.hpp"
#include "tests/certify/sample_meshes.hpp"

using namespace crest::certify;
using namespace crest::tests;

namespace {

using Monge = std::array<double, 14>;

RidgesMeshCertificate certificate_of(const MeshData& data) {
  const ReferenceRidges ridges(data);
  REQUIRE(ridges.valid());
  return *ridges.certificate(ridges.single_faces());
}

void reverse_normal(Monge& m) {
  for (std::size_t i = 3; i < 6; ++i) m[i] = m[i] == 0 ? 0.0 : -m[i];
}

/// Whether the signs' line of the verdict names a number of such vertices, accepted under both
/// arithmetics.
void check_named(const MeshData& data, const std::string& words) {
  const Bytes bytes = encode(certificate_of(data));
  VerifyOptions mpfr;
  mpfr.arithmetic = Arithmetic::mpfr;
  for (const VerifyOptions& options : {VerifyOptions{}, mpfr}) {
    const Verdict verdict = verify(bytes, options);
    INFO(verdict.reason);
    REQUIRE(verdict.accepted);
    INFO(verdict.lines[2]);
    CHECK(verdict.lines[2].find(words) != std::string::npos);
  }
}

/// The claim as it was, about data with one frame changed.
std::string reason_after(const RidgesMeshCertificate& truth, std::size_t v,
                         void (*change)(Monge&)) {
  RidgesMeshCertificate c = truth;
  change(c.data.monge[v]);
  const Verdict verdict = verify(encode(c));
  CHECK_FALSE(verdict.accepted);
  return verdict.reason;
}

}  // namespace

TEST_CASE("a frame changed under a claim is noticed at every vertex") {
  const RidgesMeshCertificate truth = certificate_of(ellipsoid(2, 1, 1.3, 1.7));
  REQUIRE(truth.against_faces == 0);
  REQUIRE(truth.equal_curvatures == 0);
  REQUIRE(truth.parallel_frames == 0);
  for (std::size_t v = 0; v < truth.data.monge.size(); ++v) {
    INFO("vertex " << v);
    CHECK(reason_after(truth, v, reverse_normal) ==
          "vertices with n against the faces: 0 stated, 1 found");
    CHECK(reason_after(truth, v, [](Monge& m) { m[7] = m[6]; }) ==
          "vertices with k1 = k2: 0 stated, 1 found");
  }
}

TEST_CASE("frames that no surface has are counted in the verdict") {
  const MeshData data = ellipsoid(1, 1, 1.3, 1.7);
  const std::string all = std::to_string(data.monge.size());
  MeshData changed = data;
  reverse_normal(changed.monge[5]);
  check_named(changed, "vertices; n against the faces at 1");
  changed = data;
  for (Monge& m : changed.monge) reverse_normal(m);
  check_named(changed, "; n against the faces at " + all);
  // All reversed: the claim of the old data is about other indices.
  RidgesMeshCertificate old = certificate_of(data);
  old.data = changed;
  old.against_faces = static_cast<std::uint32_t>(data.monge.size());
  CHECK_FALSE(verify(encode(old)).accepted);
  changed = data;
  changed.monge[3][7] = changed.monge[3][6];
  check_named(changed, "; k1 = k2 at 1");
  changed = data;
  for (std::size_t i = 0; i < 3; ++i) changed.monge[7][i] = -2 * changed.monge[7][3 + i];
  check_named(changed, "; n x d1 = 0 at 1");
}

TEST_CASE("a normal exactly along the faces counts as against them, whatever the scale") {
  MeshData flat = grid(3, 3);
  for (Monge& m : flat.monge) m[6] = 1;
  flat.monge[0][3] = 1, flat.monge[0][4] = 0, flat.monge[0][5] = 0;
  flat.monge[1][3] = 1e300, flat.monge[1][5] = 5e-324;  // for the faces by the least bit
  flat.monge[2][3] = 1e300, flat.monge[2][5] = -5e-324;
  flat.monge[0][0] = 0, flat.monge[0][1] = 1;
  const RidgesMeshCertificate c = certificate_of(flat);
  CHECK(c.against_faces == 2);
  CHECK(verify(encode(c)).accepted);
}

TEST_CASE("a tangential d1 is not asked for") {
  const MeshData data = ellipsoid(1, 1, 1.3, 1.7);
  for (std::size_t v = 0; v < data.monge.size(); ++v) {
    MeshData changed = data;
    for (std::size_t i = 0; i < 3; ++i) changed.monge[v][i] += changed.monge[v][3 + i] / 2;
    CHECK(verify(encode(certificate_of(changed))).accepted);
  }
}
