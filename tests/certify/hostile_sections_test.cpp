// SPDX-License-Identifier: GPL-3.0-or-later
// Claims 1 to 3, section by section: counts, numbers that are none, sections of other certificates.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <iostream>
#include <limits>

#include "certify/container/container.hpp"
#include "certify/features_mesh/encode.hpp"
#include "certify/reeb/decode.hpp"
#include "certify/verify.hpp"
#include "tests/certify/mutants.hpp"
#include "tests/certify/reeb_samples.hpp"
#include "tests/certify/reference_reeb.hpp"
#include "tests/certify/reference_ridges.hpp"
#include "tests/support/failures.hpp"

using namespace crest::certify;
using namespace crest::tests;

namespace {

using u32 = std::uint32_t;

Bytes ridges_certificate(Random& random) {
  MeshData data = icosphere(0);
  randomize_monge(data, random);
  const ReferenceRidges ridges(data);
  return encode(*ridges.certificate(ridges.grown(4, random)));
}

/// On an octahedron, marks on a quarter of its equator and a pole: both ends are taken off in turn.
Bytes features_certificate() {
  FeaturesMeshCertificate c;
  c.faces = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1},
             {5, 2, 1}, {5, 3, 2}, {5, 4, 3}, {5, 1, 4}};
  c.positions.resize(6);
  c.marked_before = {1, 1, 1, 0, 0, 0};
  c.euler_characteristic = 2;
  c.removed = {0, 1};
  c.marked_after = c.dropped = {2};
  c.betti.fill({1, 1, 0, 0});
  return encode(c);
}

Bytes reeb_certificate(int degree, Random& random) {
  const auto surfaces = reeb_surfaces(random);
  return encode(ReferenceReeb(reeb_data(surfaces[3], degree, Values::mixed, random))
                    .certificate(random, 0.5));
}

std::vector<Bytes> certificates(Random& random) {
  std::vector<Bytes> all = {ridges_certificate(random), features_certificate(),
                            reeb_certificate(1, random), reeb_certificate(2, random)};
  for (const Bytes& bytes : all) {
    INFO(verify(bytes).reason);
    REQUIRE(verify(bytes).accepted);
  }
  return all;
}

/// Is what is accepted true by the slow producers? Claim 2 says one thing of these data.
bool is_true(const Bytes& bytes) {
  const Container container = open_container(bytes);
  if (container.claim == kReeb)
    return ReferenceReeb::is_true(decode_reeb(container.data, container.claims));
  if (container.claim != kRidgesMesh) return false;
  const auto c = decode(bytes);
  std::vector<PatchFaces> patches;
  for (const auto& patch : c.patches) patches.push_back({patch.centre, patch.faces});
  const ReferenceRidges ridges(c.data);
  if (!ridges.valid()) return false;
  const auto truth = ridges.certificate(patches);
  return truth && encode(*truth) == bytes;
}

u32 word_at(const Bytes& bytes, std::size_t at) {
  u32 word = 0;
  std::memcpy(&word, bytes.data() + at, sizeof word);
  return word;
}

/// Accepted with the digest and the seal made anew?
bool accepted(Bytes bytes) {
  rebind(bytes);
  return verify(bytes).accepted;
}

}  // namespace

TEST_CASE("no word of a claim may be another") {
  Random random(kSeed + 21);
  std::uint64_t tried = 0, lies = 0;
  for (const Bytes& original : certificates(random)) {
    const std::size_t claims = kHeaderSize + open_container(original).data.size();
    std::vector<std::size_t> places = {kHeaderSize, kHeaderSize + 4};  // V and F
    for (std::size_t at = claims; at + kSealSize + 4 <= original.size(); ++at) places.push_back(at);
    for (const std::size_t at : places) {
      const u32 right = word_at(original, at);
      for (const u32 wrong : {0U, 1U, right + 1, right - 1, right ^ 1U << 31, 1U << 31, ~0U}) {
        if (wrong == right) continue;
        Bytes bytes = original;
        std::memcpy(bytes.data() + at, &wrong, sizeof wrong);
        rebind(bytes);
        ++tried;
        if (!verify(bytes).accepted || is_true(bytes)) continue;
        ++lies;
        INFO("claim " << open_container(original).claim << ", byte " << at << ": " << wrong);
        CHECK(false);
      }
    }
  }
  std::cout << "words of claims 1 to 3 replaced: " << tried << ", " << lies << " lies accepted\n";
  CHECK(lies == 0);
  CHECK(tried > 10000);
}

TEST_CASE("no number of the data may be none") {
  Random random(kSeed + 22);
  const double kNotPlain[] = {std::numeric_limits<double>::infinity(), -HUGE_VAL, -0.0,
                              std::nan(""), -std::nan("7")};
  std::uint64_t tried = 0;
  for (const Bytes& original : certificates(random)) {
    const Container c = open_container(original);
    // Behind the counts, claim 3's degree and the faces.
    const std::size_t first =
        kHeaderSize + (c.claim == kReeb ? 9 : 8) + kFaceSize * word_at(original, kHeaderSize + 4);
    const std::size_t marks = c.claim == kFeaturesMesh ? word_at(original, kHeaderSize) : 0;
    for (std::size_t at = first; at + 8 <= kHeaderSize + c.data.size() - marks; at += 8)
      for (const double none : kNotPlain) {
        Bytes bytes = original;
        std::memcpy(bytes.data() + at, &none, sizeof none);
        rebind(bytes);
        const Verdict verdict = verify(bytes);
        CHECK_FALSE(verdict.accepted);
        CHECK(verdict.reason.find("infinite, NaN or -0") != std::string::npos);
        ++tried;
      }
  }
  CHECK(tried > 1000);
}

TEST_CASE("no section stands for another") {
  Random random(kSeed + 23);
  const auto all = certificates(random);
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = 0; j < all.size(); ++j) {
      const Container a = open_container(all[i]), b = open_container(all[j]);
      for (const u32 claim : {0U, 1U, 2U, 3U, 4U, 5U, ~0U})
        for (const u32 version : {0U, 1U, 2U, 3U, ~0U}) {
          Bytes bytes = all[i];
          bytes.resize(kHeaderSize + a.data.size());
          bytes.insert(bytes.end(), b.claims.begin(), b.claims.end());
          bytes.resize(bytes.size() + kSealSize);
          std::memcpy(bytes.data() + 8, &version, sizeof version);
          std::memcpy(bytes.data() + 12, &claim, sizeof claim);
          const std::uint64_t length = b.claims.size();
          std::memcpy(bytes.data() + kLengthsOffset + 8, &length, sizeof length);
          const bool same = i == j && claim == a.claim && version == a.version;
          CHECK(accepted(bytes) == same);
        }
    }
}
