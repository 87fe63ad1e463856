// SPDX-License-Identifier: GPL-3.0-or-later
// Mutants. Two modes: resealed, every mutant must be rejected; rebound (data digest too), every
// accepted mutant must be a true claim about its own data, by the reference producer.
#include <catch2/catch.hpp>
#include <cmath>
#include <iostream>
#include <set>

#include "certify/container/container.hpp"
#include "certify/ridges_mesh/canonical.hpp"
#include "certify/verify.hpp"
#include "tests/certify/mutants.hpp"
#include "tests/certify/reference_ridges.hpp"
#include "tests/support/failures.hpp"

using namespace crest::certify;
using namespace crest::tests;

namespace {

struct Original {
  std::string name;
  Bytes bytes;
  RidgesMeshCertificate certificate;
};

std::vector<Original> originals() {
  std::vector<Original> out;
  Random random(kSeed);
  for (const auto& [name, data] : all_samples()) {
    // Where all angles come from MPFR a check takes 10 ms: the acceptance tests cover those.
    const bool slow = name.find(" bits") != std::string::npos || name.find("d1 ") == 0;
    if (data.faces.size() > 200 || slow) continue;
    const ReferenceRidges ridges(data);
    const auto c =
        *ridges.certificate(out.size() % 2 ? ridges.grown(8, random) : ridges.single_faces());
    const Bytes bytes = encode(c);
    out.push_back({name, bytes, decode(bytes)});
    REQUIRE(verify(bytes).accepted);
  }
  return out;
}

/// What the reference says about the mutant's data and patches, as bytes; empty if no claim is
/// true.
Bytes true_claim(const RidgesMeshCertificate& mutant) {
  const ReferenceRidges ridges(mutant.data);
  if (!ridges.valid()) return {};
  std::vector<PatchFaces> patches;
  for (const auto& patch : mutant.patches) patches.push_back({patch.centre, patch.faces});
  const auto certificate = ridges.certificate(patches);
  return certificate ? encode(*certificate) : Bytes{};
}

struct Tally {
  std::uint64_t mutants = 0, resealed_accepted = 0, rebound_accepted = 0, rebound_true = 0;

  void print(const char* what) const {
    std::cout << what << ": " << mutants << " mutants; resealed: " << resealed_accepted
              << " accepted; rebound: " << rebound_accepted << " accepted, of them " << rebound_true
              << " true claims about their own data\n";
  }
};

/// Both modes on one mutant; lengths that do not fit cannot be sealed and are checked as they are.
void judge(const Original& original, const Bytes& mutant, Tally& tally) {
  if (mutant == original.bytes) return;
  ++tally.mutants;
  const OnFailure shown(
      [&] { return original.name + ": " + difference_in_words(original.bytes, mutant); });
  Bytes sealed = mutant, bound = mutant;
  try {
    reseal(sealed);
    rebind(bound);
  } catch (const std::invalid_argument&) {
  }
  // An edit of the seal alone is undone by sealing again: nothing is left to reject.
  if (sealed != original.bytes) {
    const bool accepted = verify(sealed).accepted;
    // Another true claim about the same data (patches may be chosen) is no false acceptance.
    const bool is_false = accepted && true_claim(decode(sealed)) != sealed;
    CHECK_FALSE(is_false);
    tally.resealed_accepted += is_false;
  } else {
    CHECK_FALSE(verify(mutant).accepted);
  }
  if (!verify(bound).accepted) return;
  ++tally.rebound_accepted;
  const bool is_true = true_claim(decode(bound)) == bound;
  CHECK(is_true);
  tally.rebound_true += is_true;
}

}  // namespace

TEST_CASE("edited records are rejected by the checks proper") {
  Random random(kSeed);
  const auto all = originals();
  Tally tally;
  std::uint64_t other_true = 0;
  for (std::uint64_t i = 0; i < scaled(12000); ++i) {
    const Original& original = all[random() % all.size()];
    RidgesMeshCertificate c = original.certificate;
    const std::string what = mutate_claim(c, random);
    const Bytes mutant = encode_as_is(c);  // digest and seal are right
    if (mutant == original.bytes) continue;
    ++tally.mutants;
    if (!verify(mutant).accepted) continue;
    INFO(original.name << ": " << what);
    CHECK(true_claim(decode(mutant)) == mutant);
    ++other_true;
  }
  std::cout << "edited records: " << tally.mutants << " mutants, " << tally.mutants - other_true
            << " rejected, " << other_true << " accepted that state another choice of patches\n";
  CHECK(tally.mutants > scaled(12000) * 3 / 4);
  CHECK(other_true * 1000 < tally.mutants);
}

TEST_CASE("edited bytes: resealed all rejected, rebound only true claims accepted") {
  Random random(kSeed + 1);
  const auto all = originals();
  Tally tally;
  for (std::uint64_t i = 0; i < scaled(8000); ++i) {
    const Original& original = all[random() % all.size()];
    Bytes mutant = mutate_bytes(original.bytes, random);
    if (random() % 4 == 0)
      mutant = mutate_bytes(mutant.size() > 300 ? mutant : original.bytes, random);
    judge(original, mutant, tally);
  }
  tally.print("edited bytes");
  CHECK(tally.resealed_accepted == 0);
  CHECK(tally.rebound_true == tally.rebound_accepted);
  CHECK(tally.rebound_accepted > 0);
  CHECK(tally.mutants > scaled(8000) * 3 / 4);
}

TEST_CASE("edited data: signs, magnitudes, zeros, swapped vertices and faces") {
  Random random(kSeed + 2);
  const auto all = originals();
  Tally tally;
  for (std::uint64_t i = 0; i < scaled(3000); ++i) {
    const Original& original = all[random() % all.size()];
    RidgesMeshCertificate c = original.certificate;
    auto& monge = c.data.monge[random() % c.data.monge.size()];
    auto& position = c.data.positions[random() % c.data.positions.size()];
    auto& face = c.data.faces[random() % c.data.faces.size()];
    double& number = random() % 4 ? monge[random() % 14] : position[random() % 3];
    switch (random() % 8) {
      case 0:
        number = number == 0 ? 1 : -number;
        break;
      case 1:
        number = 0;
        break;
      case 2:
        number = uniform(random);
        break;
      case 3:
        number = std::ldexp(number, static_cast<int>(random() % 200) - 100);
        break;
      case 4:
        std::swap(monge, c.data.monge[random() % c.data.monge.size()]);
        break;
      case 5:
        std::swap(position, c.data.positions[random() % c.data.positions.size()]);
        break;
      case 6:
        std::swap(face[random() % 3], face[random() % 3]);
        break;
      default:
        std::swap(face, c.data.faces[random() % c.data.faces.size()]);
    }
    Bytes mutant = encode_as_is(c);
    const Bytes& bytes = original.bytes;
    // The mutant keeps the digest it was made with until it is bound again.
    std::copy(bytes.begin() + kDigestOffset, bytes.begin() + kLengthsOffset,
              mutant.begin() + kDigestOffset);
    judge(original, mutant, tally);
  }
  tally.print("edited data");
  CHECK(tally.resealed_accepted == 0);
  CHECK(tally.rebound_true == tally.rebound_accepted);
  CHECK(tally.mutants > scaled(3000) / 2);
}

TEST_CASE("the claims of one mesh do not hold for another") {
  const auto all = originals();
  Tally tally;
  for (const auto& one : all)
    for (const auto& other : all) {
      RidgesMeshCertificate c = one.certificate;
      c.data = other.certificate.data;
      const Bytes mutant = encode_as_is(c);
      if (mutant == other.bytes) continue;
      ++tally.mutants;
      const bool accepted = verify(mutant).accepted;
      INFO(one.name << " for " << other.name);
      CHECK((!accepted || true_claim(c) == mutant));
      tally.rebound_accepted += accepted;
    }
  std::cout << "another mesh's data: " << tally.mutants << " mutants, " << tally.rebound_accepted
            << " accepted (true claims there too)\n";
  CHECK(tally.mutants > 100);
}

TEST_CASE("garbage and truncations are rejected without harm") {
  Random random(kSeed + 3);
  const auto all = originals();
  const auto refuse = [](Bytes bytes) {
    CHECK_FALSE(verify(bytes).accepted);
    try {
      rebind(bytes);
    } catch (const std::invalid_argument&) {
    }
    return verify(bytes).accepted;
  };
  const Bytes& bytes = all.front().bytes;
  for (std::size_t n = 0; n < bytes.size(); n += n < 200 ? 1 : 97)
    CHECK_FALSE(refuse(Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(n))));
  for (std::uint64_t i = 0; i < scaled(5000); ++i) {
    // A good header over random sections, or a good start with a random rest.
    Bytes wild = bytes;
    const std::size_t keep = random() % 2 ? kHeaderSize : random() % (wild.size() - 2 * kSealSize);
    for (std::size_t k = keep; k < wild.size(); ++k) wild[k] = static_cast<std::uint8_t>(random());
    if (random() % 2)
      for (int k = 0; k < 4; ++k) wild[kHeaderSize + random() % 8] = 0xff;
    CHECK_FALSE(refuse(wild));
  }
  Bytes none;
  CHECK_THROWS_AS(reseal(none), std::invalid_argument);
  CHECK_THROWS_AS(rebind(none), std::invalid_argument);
  CHECK_THROWS_AS(data_digest(none), std::invalid_argument);
}
