// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 7: the producer's certificates are accepted; edited ones are rejected unless true.
#include <catch2/catch.hpp>
#include <functional>
#include <iostream>
#include <map>

#include "algorithms/modes/curves_certificate.hpp"
#include "algorithms/modes/degenerate_curves.hpp"
#include "certify/modes_curves/decode.hpp"
#include "certify/modes_curves/encode.hpp"
#include "certify/verify.hpp"
#include "tests/certify_modes/byte_mutants.hpp"
#include "tests/certify_modes/modes_samples.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/failures.hpp"
#include "tests/support/random.hpp"

using namespace crest::certify;
using namespace crest::tests;

namespace {

using Certificate = ModesCurvesCertificate;

Certificate produced(const ModesInput& input) {
  const auto curves = crest::modes::degenerate_curves(input.points, input.tets, input.tensors);
  return crest::modes::curves_certificate(input.points, input.tets, input.tensors, curves);
}

void require_accepted(const Certificate& c) {
  const Verdict verdict = verify(encode(c));
  INFO(verdict.reason);
  REQUIRE(verdict.accepted);
}

/// Tensors at random on a grid; of one vertex in `zeros`, if any, zero.
ModesInput random_grid(std::uint32_t n, Random& random, unsigned zeros) {
  ModesInput input = grid(n, 0, 1, kReferenceFields[0]);
  for (auto& t : input.tensors) {
    const bool zero = zeros > 0 && random() % zeros == 0;
    for (double& x : t) x = zero ? 0 : static_cast<double>(random() % 2001) / 1000.0 - 1;
  }
  return input;
}

auto counts(const CurveCounts& c) {
  return std::array{c.open, c.closed, c.touched};
}
auto statement(const Certificate& c) {
  return std::pair(counts(c.linear), counts(c.planar));
}

}  // namespace

TEST_CASE("modes-curves: the curves of linear fields are those of the table") {
  constexpr std::array<std::array<std::uint32_t, 2>, 6> kPieces = {
      {{1, 2}, {2, 1}, {2, 1}, {1, 2}, {1, 1}, {2, 2}}};
  for (std::size_t f = 0; f < 6; ++f)
    for (const bool mirrored : {false, true})
      for (const std::uint32_t n : {1U, 2U, 3U}) {
        CAPTURE(f + 1, n, mirrored);
        const auto c = produced(grid(n, -2, 2, kReferenceFields[f], mirrored));
        require_accepted(c);
        CHECK(counts(c.linear) == std::array{kPieces[f][0], 0U, 0U});
        CHECK(counts(c.planar) == std::array{kPieces[f][1], 0U, 0U});
      }
}

TEST_CASE("modes-curves: random fields, with closed curves, and with zeros at vertices") {
  Random random(kSeed);
  std::uint32_t closed = 0, touched = 0, four = 0;
  for (const unsigned zeros : {0U, 0U, 12U}) {
    const auto c = produced(random_grid(3, random, zeros));
    require_accepted(c);
    closed += c.linear.closed + c.planar.closed;
    touched += c.linear.touched + c.planar.touched;
    CHECK((zeros > 0) == !c.special_tets.empty());
    for (std::size_t i = 1; i < c.arcs.size(); ++i) four += c.arcs[i].tet == c.arcs[i - 1].tet;
  }
  std::cout << closed << " closed curves, " << touched << " at special places, " << four
            << " tetrahedra with two arcs or more\n";
  CHECK(closed > 0);
  CHECK(touched > 0);
  CHECK(four > 0);  // several points on a conic
}

namespace {

using Edit = std::function<bool(Certificate&, Random&)>;

template <class List>
auto& any_of(List& list, Random& random) {
  return list[static_cast<std::size_t>(random() % list.size())];
}

/// Each returns whether it changed anything.
const std::vector<std::pair<std::string, Edit>> kEdits = {
    {"count changed",
     [](Certificate& c, Random& r) {
       auto& of = r() % 2 ? c.linear : c.planar;
       ++*std::array{&of.open, &of.closed, &of.touched}[r() % 3];
       return true;
     }},
    {"type turned",
     [](Certificate& c, Random& r) {
       auto& type = any_of(c.face_points, r).type;
       type = static_cast<std::int8_t>(-type);
       return true;
     }},
    {"all types turned",
     [](Certificate& c, Random&) {
       for (auto& p : c.face_points) p.type = static_cast<std::int8_t>(-p.type);
       std::swap(c.linear, c.planar);
       return true;
     }},
    {"box moved",
     [](Certificate& c, Random& r) {
       auto& p = any_of(c.face_points, r);
       const auto k = static_cast<std::size_t>(r() % 2);
       const double width = p.high[k] - p.low[k];
       p.low[k] += width, p.high[k] += width;
       return true;
     }},
    {"box of all",
     [](Certificate& c, Random& r) {
       auto& p = any_of(c.face_points, r);
       p.low = {0, 0}, p.high = {1, 1};
       return true;
     }},
    {"box of nothing",
     [](Certificate& c, Random& r) {
       auto& p = any_of(c.face_points, r);
       p.low[r() % 2] = std::array{HUGE_VAL, -HUGE_VAL, std::nan("")}[r() % 3];
       return true;
     }},
    {"arc dropped",
     [](Certificate& c, Random& r) {
       c.arcs.erase(c.arcs.begin() + static_cast<std::ptrdiff_t>(r() % c.arcs.size()));
       return true;
     }},
    {"arc elsewhere",
     [](Certificate& c, Random& r) {
       auto& tet = any_of(c.arcs, r).tet;
       const auto before = tet;
       tet = static_cast<std::uint32_t>(r() % c.tets.size());
       return tet != before;
     }},
    {"arcs exchanged",
     [](Certificate& c, Random& r) {
       if (c.arcs.size() < 2) return false;
       const auto at = 1 + static_cast<std::size_t>(r() % (c.arcs.size() - 1));
       if (c.arcs[at].tet != c.arcs[at - 1].tet) return false;
       std::swap(c.arcs[at].points[1], c.arcs[at - 1].points[1]);
       return true;
     }},
    {"point dropped, with its arcs",
     [](Certificate& c, Random& r) {
       const auto at = static_cast<std::uint32_t>(r() % c.face_points.size());
       c.face_points.erase(c.face_points.begin() + at);
       std::erase_if(c.arcs, [&](const auto& a) { return a.points[0] == at || a.points[1] == at; });
       for (auto& arc : c.arcs)
         for (auto& p : arc.points) p -= p > at;
       return true;
     }},
    {"points exchanged",
     [](Certificate& c, Random& r) {
       const auto at = static_cast<std::size_t>(r() % (c.face_points.size() - 1));
       std::swap(c.face_points[at].low, c.face_points[at + 1].low);
       std::swap(c.face_points[at].high, c.face_points[at + 1].high);
       return true;
     }},
    {"all forgotten",
     [](Certificate& c, Random&) {
       c.faces.clear(), c.face_points.clear(), c.arcs.clear();
       c.linear = c.planar = {};
       return true;
     }},
    {"tetrahedron said to be special",
     [](Certificate& c, Random& r) {
       const auto t = any_of(c.arcs, r).tet;
       if (std::ranges::binary_search(c.special_tets, t)) return false;
       c.special_tets.insert(std::ranges::lower_bound(c.special_tets, t), t);
       if (r() % 2) std::erase_if(c.arcs, [&](const auto& a) { return a.tet == t; });
       return true;
     }},
    {"special places forgotten",
     [](Certificate& c, Random& r) {
       if (c.special_tets.empty()) return false;
       if (r() % 2) c.special_tets.clear();
       c.special_faces.clear();
       return true;
     }},
};

std::vector<Certificate> originals() {
  Random random(kSeed);
  std::vector<Certificate> all;
  for (const std::size_t f : {0U, 5U}) all.push_back(produced(grid(1, -2, 2, kReferenceFields[f])));
  all.push_back(produced(random_grid(2, random, 0)));
  all.push_back(produced(random_grid(2, random, 6)));
  for (const auto& c : all) {
    require_accepted(c);
    REQUIRE(c.face_points.size() > 2);
    REQUIRE(!c.arcs.empty());
  }
  return all;
}

struct Judge {
  std::uint64_t mutants = 0, accepted = 0, anew = 0;

  /// What an accepted mutant with the same special places says is what the producer finds.
  bool operator()(const Certificate& original, const Certificate& mutant) {
    ++mutants;
    if (!verify(encode(mutant)).accepted) return false;
    ++accepted;
    const bool same_places = original.special_tets == mutant.special_tets &&
                             original.special_faces == mutant.special_faces;
    if (!same_places) return true;
    if (original.tets == mutant.tets && original.tensors == mutant.tensors) {
      CHECK(statement(original) == statement(mutant));
      return true;
    }
    ++anew;
    const auto made = produced({mutant.points, mutant.tets, mutant.tensors});
    // The producer's own, too, must be a certificate: it lists points of special faces at times.
    if (made.special_tets == mutant.special_tets && verify(encode(made)).accepted)
      CHECK(statement(made) == statement(mutant));
    return true;
  }
};

}  // namespace

TEST_CASE("modes-curves: edited records are rejected unless true") {
  Random random(kSeed);
  Judge judge;
  std::map<std::string, std::array<std::uint64_t, 2>> kinds;
  for (const auto& original : originals())
    for (const auto& [kind, edit] : kEdits)
      for (std::uint64_t i = 0; i < scaled(2); ++i) {
        Certificate mutant = original;
        if (!edit(mutant, random)) continue;
        CAPTURE(kind);
        ++kinds[kind][0];
        kinds[kind][1] += judge(original, mutant);
      }
  for (const auto& [kind, edit] : kEdits) {
    CAPTURE(kind);
    const auto [made, accepted] = kinds[kind];
    std::cout << kind << ": " << made << " mutants, " << accepted << " accepted\n";
    CHECK(made > 0);
    if (kind != "box of all" && kind != "arcs exchanged" && kind != "arc elsewhere")
      CHECK(accepted == 0);
  }
}

TEST_CASE("modes-curves: edited bytes, bound again, are rejected unless true") {
  Random random(kSeed);
  Judge judge;
  for (const auto& original : originals()) {
    try_bytes(encode(original), scaled(32), random, decode_modes_curves,
              [&](const Certificate& mutant) { judge(original, mutant); });
  }
  std::cout << "bytes: " << judge.mutants << " mutants, " << judge.accepted << " accepted, "
            << judge.anew << " of them made anew\n";
  CHECK(judge.mutants > 80);
}
