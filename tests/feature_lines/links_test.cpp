// SPDX-License-Identifier: GPL-3.0-or-later
// Every marking of every link up to valence 8: which local rule is exactly simplicity
// (docs/feature-lines-topology.md has the table).
#include <catch2/catch.hpp>

#include "tests/feature_lines/meshes.hpp"

using namespace crest::tests;
namespace fl = crest::feature_lines;

namespace {

/// The subcomplex of a cycle or path of n vertices on those with this mark, by ranks over Z/2.
Betti link_betti(Index n, bool closed, unsigned bits, bool mark) {
  std::vector<std::set<Index>> edges;
  Index vertices = 0;
  const auto in = [&](Index k) { return ((bits >> k & 1) != 0) == mark; };
  for (Index k = 0; k < n; ++k) {
    vertices += in(k);
    const Index next = (k + 1) % n;
    if (in(k) && in(next) && (closed || next != 0)) edges.push_back({k, next});
  }
  const auto e = static_cast<Index>(edges.size());
  const Index rank = rank_mod_2(edges);
  return {static_cast<int>(vertices) - static_cast<int>(e), vertices - rank, e - rank, 0};
}

const Betti kPoint = {1, 1, 0, 0};

struct Tally {
  Index links = 0, keeps_marked = 0, simple = 0, paper = 0, paper_wrong = 0;
  bool operator==(const Tally&) const = default;
};

Tally enumerate(Index n, bool closed) {
  const TriangleMesh mesh = fan(n, closed);
  Tally tally;
  for (unsigned bits = 0; bits < 1u << n; ++bits) {
    Marks marks(n + 1, 0);
    marks[0] = 1;
    Index changes = 0;
    for (Index k = 0; k < n; ++k) {
      marks[k + 1] = static_cast<std::uint8_t>(bits >> k & 1);
      changes += (bits >> k & 1) != (bits >> (k + 1) % n & 1);
    }
    const bool keeps_marked = link_betti(n, closed, bits, true) == kPoint;
    const bool keeps_other = link_betti(n, closed, bits, false) == kPoint;
    INFO(n << (closed ? " around, bits " : " in a row, bits ") << bits);
    CHECK(fl::is_simple(mesh, marks, 0) == (keeps_marked && keeps_other));
    ++tally.links;
    tally.keeps_marked += keeps_marked;
    tally.simple += keeps_marked && keeps_other;
    tally.paper += changes < 4;
    tally.paper_wrong += changes < 4 && !(keeps_marked && keeps_other);
    // The same seen from the whole complex: one removal keeps both Betti triples or not.
    Marks without = marks;
    without[0] = 0;
    const bool same = betti_by_ranks(mesh, marks, 1) == betti_by_ranks(mesh, without, 1) &&
                      betti_by_ranks(mesh, marks, 0) == betti_by_ranks(mesh, without, 0);
    CHECK(same == (keeps_marked && keeps_other));
  }
  return tally;
}

}  // namespace

TEST_CASE("interior links, valence 3 to 8: simple is exactly c_i = 2") {
  // n (n - 1) markings have two transitions; c_i < 4 also admits the empty and the full link.
  for (Index n = 3; n <= 8; ++n) {
    const Tally tally = enumerate(n, true);
    INFO(n);
    CHECK(tally == Tally{1u << n, n * (n - 1), n * (n - 1), n * (n - 1) + 2, 2});
  }
}

TEST_CASE("boundary links, 2 to 8 neighbours: simple is exactly one transition") {
  for (Index n = 2; n <= 8; ++n) {
    const Tally tally = enumerate(n, false);
    INFO(n);
    // One marked run: n (n + 1) / 2 markings; one run of each: 2 (n - 1).
    CHECK(tally.links == 1u << n);
    CHECK(tally.keeps_marked == n * (n + 1) / 2);
    CHECK(tally.simple == 2 * (n - 1));
    CHECK(tally.paper == n * (n - 1) + 2);
    CHECK(tally.paper_wrong == n * (n - 1) + 2 - 2 * (n - 1));
  }
}

TEST_CASE("Betti numbers agree with ranks over Z/2 on random sets") {
  Random random(7);
  for (const auto& [name, mesh] : sample_meshes()) {
    for (int i = 0; i < 12; ++i) {
      const Marks marks = random_marks(mesh, random, i % 4 == 3 ? 0.7 : 0.15, Index(i % 2));
      INFO(name << ", set " << i);
      for (const std::uint8_t mark : {std::uint8_t{0}, std::uint8_t{1}})
        CHECK(fl::betti_numbers(mesh, marks, mark) == betti_by_ranks(mesh, marks, mark));
    }
    const Marks all(mesh.vertex_count(), 1);
    CHECK(fl::betti_numbers(mesh, all, 1) == betti_by_ranks(mesh, all, 1));
    CHECK(fl::betti_numbers(mesh, all, 0) == Betti{});
  }
  CHECK(fl::betti_numbers(plate(3, 2), Marks(plate(3, 2).vertex_count(), 1), 1) ==
        Betti{-4, 1, 6, 1});
}
