// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 10: orbits, orders of arrivals, saddles that move, domains that change.
#include <algorithm>
#include <catch2/catch.hpp>
#include <iostream>

#include "certify/compression/bijection.hpp"
#include "certify/compression/encode.hpp"
#include "certify/verify.hpp"
#include "tests/certify_skeleton/reference_compression.hpp"
#include "tests/support/verdicts.hpp"

using namespace crest::certify;
using namespace crest::tests;
using u32 = std::uint32_t;

namespace {

bool contains(const std::string& text, const char* part) {
  return text.find(part) != std::string::npos;
}

/// Around the hole between two rings, forward: attracting.
SkeletonOrbit orbit_between(u32 inner_ring, double left, double right) {
  SkeletonOrbit orbit;
  orbit.side = 3 * 2 * 8 * inner_ring;
  orbit.left = left;
  orbit.right = right;
  for (int i = 0; i < 8; ++i) orbit.turns.insert(orbit.turns.end(), {Turn::left, Turn::right});
  return orbit;
}

}  // namespace

TEST_CASE("compression: orbits around the same correspond by their rank") {
  const PlaneField rings = ring_field({{1, 1}, {1.5, -0.5}, {2, 1}, {2.5, -0.5}});
  auto skeleton = reference_points(rings);
  skeleton.orbits = {orbit_between(0, -0.45, -0.3), orbit_between(2, -0.45, -0.25)};
  auto c = claim_of(rings, skeleton, rings.triangles, SkeletonNotion::original);
  c.output.orbits = skeleton.orbits;
  REQUIRE(reason(c) == "");
  auto wrong = c;
  std::swap(wrong.orbits[0], wrong.orbits[1]);
  CHECK(contains(reason(wrong), "orbit 0 is another one"));
  // Listed in another order the exchanged map is the true one.
  std::swap(wrong.output.orbits[0], wrong.output.orbits[1]);
  CHECK(reason(wrong) == "");
  // One that is listed twice, with segments that overlap.
  wrong = c;
  wrong.input.orbits[1] = wrong.output.orbits[1] = orbit_between(0, -0.44, -0.31);
  CHECK(contains(reason(wrong), "may be one"));
  // Both orbits gone with the second ring: not the same skeleton.
  const PlaneField two = ring_field({{1, 1}, {2.5, -0.5}});
  wrong = c;
  wrong.output.orbits.pop_back();
  CHECK(contains(reason(wrong), "orbits: 2 in the input, 1 in the output"));
}

TEST_CASE("compression: one place, another order") {
  using namespace compression;
  const auto field = lattice_field(2, 7, 24, true);
  const auto skeleton = reference_skeleton(field);
  Proof proof(skeleton);
  SignLadder sign(Arithmetic::doubles);
  Verdict verdict;
  prove_surface(proof, sign, verdict);
  prove_skeleton(proof, sign, Arithmetic::doubles, verdict);
  std::vector<u32> all(field.positions.size());
  for (u32 i = 0; i < all.size(); ++i) all[i] = i;
  Match match = match_surfaces(all, proof, proof, sign);
  match_boundary(match);
  const auto identity = [](std::size_t n) {
    std::vector<u32> list(n);
    for (u32 i = 0; i < n; ++i) list[i] = i;
    return Map(list, n, "numbers");
  };
  const Maps maps{identity(skeleton.zeros.size()), identity(skeleton.orbits.size()),
                  identity(skeleton.separatrices.size())};
  const auto orbits = find_orbits(proof, sign);
  const ArrivalTable table = find_arrivals(proof, orbits, sign);
  CHECK_NOTHROW(check_arrivals(match, table, table, maps));
  std::size_t cyclic = 0, linear = 0;
  for (const auto& [place, arrivals] : table.orders) {
    const std::size_t n = arrivals.lines.size();
    ArrivalTable other = table;
    auto& lines = other.orders.at(place).lines;
    std::rotate(lines.begin(), lines.begin() + 1, lines.end());
    if (arrivals.cyclic || n == 1)
      CHECK_NOTHROW(check_arrivals(match, table, other, maps));
    else
      CHECK_THROWS(check_arrivals(match, table, other, maps));
    if (n < 2 || (arrivals.cyclic && n < 3)) continue;
    ++(arrivals.cyclic ? cyclic : linear);
    std::swap(lines[0], lines[1]);
    other.orders.at(place).lines = arrivals.lines;
    std::swap(other.orders.at(place).lines[0], other.orders.at(place).lines[1]);
    CHECK_THROWS(check_arrivals(match, table, other, maps));
  }
  std::cout << "arrivals: other orders at " << cyclic << " zeros and " << linear
            << " regions refused\n";
  CHECK(cyclic > 3);
  CHECK(linear > 3);
}

TEST_CASE("compression: no line jumps over the only zero of a loop") {
  // Outflow all around, two sources, a saddle between. One of its lines ends beside the vertex p at
  // the top, at the right if m pushes it there. Two lines have one cyclic order.
  PlaneField field = grid_field(8, 8, 1, [](double x, double y) {
    const double s = (x - 3.9) / 2;
    return std::array{s * s * s - s, y - 3.95};
  });
  const u32 p = 9 * 8 + 4, m = 9 * 6 + 4;
  field.vectors[m] = {3, 2};
  const auto smaller = collapsed(field, field.triangles, m, m + 1);
  REQUIRE_FALSE(smaller.empty());
  for (const bool zero : {true, false}) {
    field.vectors[p] = {0, zero ? 0.0 : 4.05};
    const auto skeleton = reference_skeleton(field);
    REQUIRE(skeleton.loops[0].zero == zero);
    const auto same = claim_of(field, skeleton, field.triangles, SkeletonNotion::original);
    CHECK(reason(same) == "");
    const auto c = claim_of(field, skeleton, smaller, SkeletonNotion::original);
    for (const auto* s : {&c.input, &c.output})
      CHECK(std::count_if(s->separatrices.begin(), s->separatrices.end(),
                          [](const auto& line) { return line.end == SkeletonEnd::boundary; }) == 2);
    if (zero)
      CHECK(contains(reason(c), "in another order"));
    else
      CHECK(reason(c) == "");
  }
}

TEST_CASE("compression: relaxed, zeros move with their separatrices") {
  Random random(kSeed);
  const auto field = lattice_field(1, 4, 12, true);
  const auto c = reference_compression(field, SkeletonNotion::relaxed, 150, random);
  CHECK(reason(c) == "");
  std::size_t moved = 0;
  for (std::size_t k = 0; k < c.zeros.size(); ++k) {
    const auto at = [](const SkeletonCertificate& s, const SkeletonZero& z) {
      auto t = s.triangles[z.triangle];
      std::array<std::array<double, 2>, 3> corners;
      for (std::size_t i = 0; i < 3; ++i) corners[i] = s.positions[t[i]];
      std::sort(corners.begin(), corners.end());
      return corners;
    };
    moved += at(c.input, c.input.zeros[k]) != at(c.output, c.output.zeros[c.zeros[k]]);
  }
  std::cout << "compression: " << c.output.triangles.size() << " triangles left, " << moved
            << " of " << c.zeros.size() << " zeros have moved\n";
  CHECK(moved > 0);
  auto wrong = c;
  wrong.notion = SkeletonNotion::original;
  CHECK_FALSE(reason(wrong).empty());
  // Two rays of one saddle that has moved, exchanged: the order around it is another.
  std::size_t tried = 0;
  for (u32 i = 0; i < c.separatrices.size(); ++i)
    for (u32 j = i + 1; j < c.separatrices.size(); ++j) {
      const auto &a = c.input.separatrices[i], &b = c.input.separatrices[j];
      if (a.origin != SkeletonOrigin::zero || b.origin != a.origin || a.from != b.from ||
          a.backward != b.backward)
        continue;
      wrong = c;
      std::swap(wrong.separatrices[i], wrong.separatrices[j]);
      CHECK_FALSE(reason(wrong).empty());
      ++tried;
    }
  CHECK(tried >= 4);
}

TEST_CASE("compression: a straight boundary may lose vertices, a bent one none") {
  const auto flow = [](double x, double y) { return std::array{3 + 0.1 * y, 1 + 0.01 * x}; };
  const PlaneField field = grid_field(4, 4, 1, flow);
  const auto skeleton = reference_skeleton(field);
  const auto after = [&](const Triangles& triangles) {
    return reason(claim_of(field, skeleton, triangles, SkeletonNotion::original));
  };
  const Triangles shorter = collapsed(field, field.triangles, 2, 3);
  REQUIRE_FALSE(shorter.empty());
  CHECK(after(shorter) == "");
  // A corner cut off: both triangles of the cell at the corner lose it.
  Triangles cut;
  for (const auto& t : field.triangles)
    if (t != std::array<u32, 3>{3, 4, 9}) cut.push_back(t);
  CHECK(contains(after(cut), "boundary"));
  // A hole that the input has not.
  Triangles holed;
  for (const auto& t : field.triangles)
    if (t != std::array<u32, 3>{6, 7, 12}) holed.push_back(t);
  CHECK(contains(after(holed), "boundary"));
  // A hole filled.
  const PlaneField ring = grid_field(4, 4, 1, flow, [](u32 i, u32 j) { return i == 1 && j == 1; });
  Triangles filled = ring.triangles;
  filled.push_back({6, 7, 12});
  filled.push_back({6, 12, 11});
  CHECK(contains(reason(claim_of(ring, reference_skeleton(ring), filled, SkeletonNotion::relaxed)),
                 "boundary has"));
}

TEST_CASE("compression: a slit of no width is refused") {
  // From (2, 2) to the right border: its upper side has vertices of its own.
  PlaneField field = grid_field(4, 4, 1, [](double x, double y) {
    return std::array{3 - 0.1 * y, 2 + 0.05 * x};
  });
  const u32 first = static_cast<u32>(field.positions.size());
  for (const u32 v : {13U, 14U}) {
    field.positions.push_back(field.positions[v]);
    field.vectors.push_back(field.vectors[v]);
  }
  for (auto& t : field.triangles) {
    bool above = true;
    for (const u32 v : t) above = above && field.positions[v][1] >= 2;
    for (u32& v : t)
      if (above && (v == 13 || v == 14)) v = first + v - 13;
  }
  const auto skeleton = reference_skeleton(field);
  const auto same = claim_of(field, skeleton, field.triangles, SkeletonNotion::original);
  CHECK(contains(reason(same), "boundary sides coincide"));
}
