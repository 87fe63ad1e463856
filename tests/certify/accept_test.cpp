// SPDX-License-Identifier: GPL-3.0-or-later
// True certificates are accepted, under both arithmetics, and have one encoding.
#include <algorithm>
#include <catch2/catch.hpp>

#include "certify/container/container.hpp"
#include "certify/ridges_mesh/canonical.hpp"
#include "certify/ridges_mesh/decode.hpp"
#include "certify/verify.hpp"
#include "tests/certify/reference_ridges.hpp"
#include "tests/certify/sample_meshes.hpp"
#include "tests/support/environment.hpp"

using namespace crest::certify;
using namespace crest::tests;

namespace {

RidgesMeshCertificate reference(const MeshData& data, std::size_t grow = 0) {
  const ReferenceRidges ridges(data);
  REQUIRE(ridges.valid());
  Random random(kSeed);
  const auto patches = grow > 0 ? ridges.grown(grow, random) : ridges.single_faces();
  const auto certificate = ridges.certificate(patches);
  REQUIRE(certificate);
  return *certificate;
}

Verdict check(const Bytes& bytes, Arithmetic arithmetic) {
  VerifyOptions options;
  options.arithmetic = arithmetic;
  const Verdict verdict = verify(bytes, options);
  INFO(verdict.reason);
  CHECK(verdict.accepted);
  CHECK(verdict.lines.size() == 6);
  return verdict;
}

/// Another writing of the same ridges: other starts, directions and orders.
void scramble(RidgesMeshCertificate& c, Random& random) {
  for (auto& ridge : c.ridges) {
    auto& nodes = ridge.nodes;
    const std::size_t m = nodes.size();
    const bool loop = (ridge.flags & 2U) != 0;
    if (random() % 2) {
      std::vector<unsigned> segments;
      for (const auto& node : nodes) segments.push_back(node.type >> 2);
      std::reverse(nodes.begin(), nodes.end());
      // Node i was m-1-i; after it now comes the segment that came after the one before it.
      for (std::size_t i = 0; i < m; ++i) {
        const unsigned after = i + 1 < m ? segments[m - 2 - i] : loop ? segments[m - 1] : 0;
        nodes[i].type = static_cast<std::uint8_t>((nodes[i].type & 3U) | after << 2);
      }
      std::swap(ridge.end_kind[0], ridge.end_kind[1]);
      std::swap(ridge.end_patch[0], ridge.end_patch[1]);
    }
    if (loop)
      std::rotate(nodes.begin(), nodes.begin() + static_cast<std::ptrdiff_t>(random() % m),
                  nodes.end());
  }
  std::shuffle(c.ridges.begin(), c.ridges.end(), random);
}

}  // namespace

TEST_CASE("reference certificates are accepted under both arithmetics") {
  for (const auto& [name, data] : all_samples())
    for (const std::size_t grow : {0, 8}) {
      INFO(name << ", patches grown by " << grow);
      const auto certificate = reference(data, grow);
      const Bytes bytes = encode(certificate);
      const Verdict doubles = check(bytes, Arithmetic::doubles);
      const Verdict mpfr = check(bytes, Arithmetic::mpfr);
      CHECK(doubles.lines == mpfr.lines);
      if (certificate.boundary_loops == 0)
        CHECK(certificate.twice_index_sum == 2 * certificate.euler_characteristic);
    }
}

TEST_CASE("samples reach every stage and every kind of record") {
  std::size_t loops = 0, grown = 0, boundary_ends = 0, single = 0, kinds[4] = {};
  std::uint64_t ambiguous = 0, conflicts = 0;
  std::uint64_t ties = 0, mpfr_edges = 0, mpfr_faces = 0, double_only = 0, exact = 0;
  for (const auto& [name, data] : all_samples()) {
    const auto c = reference(data, 8);
    ambiguous += c.ambiguous_edges;
    conflicts += c.conflict_triangles;
    for (const auto& patch : c.patches) {
      grown += patch.faces.size() > 1;
      ++kinds[patch.kind];
    }
    for (const auto& ridge : c.ridges) {
      loops += ridge.flags >> 1;
      single += ridge.nodes.size() == 1;
      boundary_ends += (ridge.end_kind[0] == 2) + (ridge.end_kind[1] == 2);
    }
    const Verdict verdict = verify(encode(c));
    ties += verdict.angles.ties;
    mpfr_edges += verdict.angles.mpfr_edges;
    mpfr_faces += verdict.angles.mpfr_faces;
    double_only += verdict.angles.mpfr_edges == 0;
    exact += verdict.signs.exact;
  }
  CHECK(loops > 0);
  CHECK(grown > 0);
  CHECK(single > 0);
  CHECK(boundary_ends > 0);
  CHECK(kinds[0] > 0);
  CHECK(kinds[1] > 0);
  CHECK(kinds[3] > 0);
  CHECK(ambiguous > 0);
  CHECK(conflicts > 0);
  CHECK(ties > 0);
  CHECK(mpfr_edges > 0);
  CHECK(mpfr_faces > 0);
  CHECK(double_only > 0);
  CHECK(exact > 0);
}

TEST_CASE("one graph has one encoding") {
  Random random(kSeed);
  for (const auto& [name, data] : all_samples()) {
    INFO(name);
    auto certificate = reference(data, 8);
    const Bytes bytes = encode(certificate);
    for (int i = 0; i < 5; ++i) {
      scramble(certificate, random);
      CHECK(encode(certificate) == bytes);
    }
    RidgesMeshCertificate read;
    const Container container = open_container(bytes);
    read.data = decode_data(container.data);
    decode_claims(container.claims, read);
    CHECK(encode_as_is(read) == bytes);
    CHECK(data_digest(bytes) == container.stated_data_digest);
    CHECK(hex(data_digest(bytes)).size() == 64);
  }
}

TEST_CASE("the claim does not depend on the signs of the stored frames") {
  int checked = 0;
  Random random(kSeed);
  for (const auto& [name, data] : all_samples()) {
    // Where d1 is parallel to n, phi is 0 whatever the frame: the law's one exception (SPEC.md).
    const auto parallel = [](const auto& m) {
      return m[1] * m[5] == m[2] * m[4] && m[2] * m[3] == m[0] * m[5] && m[0] * m[4] == m[1] * m[3];
    };
    if (std::any_of(data.monge.begin(), data.monge.end(), parallel)) continue;
    ++checked;
    INFO(name);
    const auto before = reference(data);
    RidgesMeshCertificate flipped = before;
    for (auto& m : flipped.data.monge) {
      if (random() % 2) continue;
      for (const std::size_t i : {0, 1, 2, 8, 9, 10, 11}) m[i] = m[i] == 0 ? 0.0 : -m[i];
    }
    CHECK(verify(encode(flipped)).accepted);
  }
  CHECK(checked >= 12);
}

TEST_CASE("files round-trip, unreadable ones throw") {
  const Bytes bytes = encode(reference(all_samples().front().data));
  const std::string path = CREST_BINARY_DIR "/certify-round-trip.crest";
  const std::string missing = CREST_BINARY_DIR "/certify-missing.crest";
  write_file(path, bytes);
  CHECK(read_file(path) == bytes);
  CHECK_THROWS_AS(read_file(missing), std::runtime_error);
  CHECK_THROWS_AS(write_file(missing + "/x", bytes), std::runtime_error);
  std::remove(path.c_str());
}
