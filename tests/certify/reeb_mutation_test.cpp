// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 3: wrong claims are rejected. Every mutant has the right digests for what it says; an
// accepted one must be true of its own data by the reference producer.
#include <catch2/catch.hpp>
#include <iostream>
#include <map>

#include "certify/container/container.hpp"
#include "certify/reeb/decode.hpp"
#include "certify/verify.hpp"
#include "tests/certify/mutants.hpp"
#include "tests/certify/reeb_mutants.hpp"
#include "tests/certify/reeb_samples.hpp"
#include "tests/certify/reference_reeb.hpp"
#include "tests/support/environment.hpp"

using namespace crest::certify;
using namespace crest::tests;

namespace {

struct Original {
  std::string name;
  Bytes bytes;
  ReebCertificate certificate;
  std::vector<std::array<std::uint32_t, 2>> contours;  ///< lower end, least node of every arc
  std::vector<ReferenceReeb::Arc> arcs;
};

std::vector<Original> originals(std::uint64_t seed) {
  Random random(seed);
  std::vector<Original> out;
  for (const ReebSurface& surface : reeb_surfaces(random))
    for (const int degree : {1, 2})
      for (const Values kind : {Values::random, Values::small, Values::mixed}) {
        const ReferenceReeb reference(reeb_data(surface, degree, kind, random));
        const ReebCertificate c = reference.certificate(random, out.size() % 2 ? 0.3 : 0);
        out.push_back({surface.name, encode(c), c, {}, reference.arcs()});
        for (const auto& a : reference.arcs()) out.back().contours.push_back({a.lower, a.node});
        REQUIRE(verify(out.back().bytes).accepted);
      }
  return out;
}

ReebCertificate decoded(const Bytes& bytes) {
  const Container container = open_container(bytes);
  return decode_reeb(container.data, container.claims);
}

struct Tally {
  std::uint64_t mutants = 0, accepted = 0, false_accepted = 0;
  std::map<std::string, std::uint64_t> reasons;

  void judge(const std::string& what, const Bytes& mutant) {
    ++mutants;
    const Verdict verdict = verify(mutant);
    ++reasons[verdict.reason.substr(0, verdict.reason.find(' '))];
    if (!verdict.accepted) return;
    ++accepted;
    const bool is_true = ReferenceReeb::is_true(decoded(mutant));
    INFO(what);
    CHECK(is_true);
    false_accepted += !is_true;
  }
  void print(const char* what) const {
    std::cout << what << ": " << mutants << " mutants, " << accepted << " accepted, "
              << false_accepted << " of them false; rejected:";
    for (const auto& [reason, count] : reasons)
      if (!reason.empty()) std::cout << " " << reason << " " << count;
    std::cout << "\n";
  }
};

const Original& pick(const std::vector<Original>& all, Random& random) {
  return all[random() % all.size()];
}

}  // namespace

TEST_CASE("edited records of a Reeb graph are rejected") {
  Random random(kSeed);
  const auto all = originals(kSeed);
  Tally tally;
  for (std::uint64_t i = 0; i < scaled(15000); ++i) {
    const Original& original = pick(all, random);
    ReebCertificate c = original.certificate;
    const std::string what = original.name + ": " + mutate_reeb_claim(c, random);
    const Bytes mutant = encode(c);
    if (mutant != original.bytes) tally.judge(what, mutant);
  }
  tally.print("Reeb graph, edited records");
  CHECK(tally.false_accepted == 0);
  CHECK(tally.mutants > scaled(15000) * 3 / 4);
  CHECK(tally.accepted < tally.mutants / 20);  // cuts that are not needed may be left out
}

TEST_CASE("edited bytes of a Reeb graph's certificate, bound again, are rejected unless true") {
  Random random(kSeed + 1);
  const auto all = originals(kSeed + 1);
  Tally tally;
  for (std::uint64_t i = 0; i < scaled(15000); ++i) {
    const Original& original = pick(all, random);
    Bytes mutant = mutate_bytes(original.bytes, random);
    if (random() % 4 == 0 && mutant.size() > 300) mutant = mutate_bytes(mutant, random);
    if (mutant == original.bytes) continue;
    const std::string what = original.name + ": " + difference_in_words(original.bytes, mutant);
    INFO(what);
    CHECK_FALSE(verify(mutant).accepted);
    try {
      rebind(mutant);
    } catch (const std::invalid_argument&) {
      continue;
    }
    if (mutant != original.bytes) tally.judge(what, mutant);
  }
  tally.print("Reeb graph, edited bytes");
  CHECK(tally.false_accepted == 0);
  CHECK(tally.accepted > 0);
}

TEST_CASE("the claim of one function does not hold for another") {
  Random random(kSeed + 2);
  const auto all = originals(kSeed + 2);
  Tally tally, swapped;
  for (std::uint64_t i = 0; i < scaled(10000); ++i) {
    const Original& original = pick(all, random);
    ReebCertificate c = original.certificate;
    const std::string what = original.name + ": " + mutate_reeb_data(c, random);
    const Bytes mutant = encode(c);
    if (mutant != original.bytes) tally.judge(what, mutant);
  }
  tally.print("Reeb graph, edited data");
  for (const Original& one : all)
    for (const Original& other : all) {
      ReebCertificate c = one.certificate;
      c.faces = other.certificate.faces, c.positions = other.certificate.positions;
      c.values = other.certificate.values, c.edge_values = other.certificate.edge_values;
      const std::size_t nodes = c.values.size() + std::size_t{c.line_critical} + c.face_critical;
      if (nodes != c.order.size()) continue;
      const Bytes mutant = encode(c);
      if (mutant != one.bytes && mutant != other.bytes)
        swapped.judge(one.name + " for " + other.name, mutant);
    }
  swapped.print("Reeb graph, another function's data");
  CHECK(tally.false_accepted + swapped.false_accepted == 0);
  CHECK(tally.accepted > 0);
  CHECK(swapped.mutants > 50);
}

TEST_CASE("other graphs on the right nodes, cut into forests at contours that exist") {
  Random random(kSeed + 3);
  const auto all = originals(kSeed + 3);
  Tally tally;
  for (std::uint64_t i = 0; i < scaled(40000); ++i) {
    const Original& original = pick(all, random);
    ReebCertificate c = original.certificate;
    rewire(c, original.contours, random);
    const Bytes mutant = encode(c);
    if (mutant == original.bytes) continue;
    tally.judge(original.name + ": " + difference_in_words(original.bytes, mutant), mutant);
  }
  tally.print("Reeb graph, rewired");
  CHECK(tally.false_accepted == 0);
  CHECK(tally.accepted > 0);
  CHECK(tally.reasons["graph:"] > tally.mutants / 4);
  CHECK(tally.reasons["cuts:"] > 0);
}
