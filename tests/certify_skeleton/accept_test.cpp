// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 9: certificates of a producer that knows only the definitions are accepted.
#include <catch2/catch.hpp>
#include <iostream>

#include "certify/skeleton/encode.hpp"
#include "certify/verify.hpp"
#include "tests/certify_skeleton/reference_skeleton.hpp"
#include "tests/support/failures.hpp"

using namespace crest::certify;
using namespace crest::tests;

namespace {

struct Expected {
  std::uint64_t seed;
  bool hole;
  std::size_t saddles, sources, sinks, foci, inside, outside;
  int index;
  std::size_t separatrices, at_zeros, at_boundary, at_orbits;
};

/// The reference table of the specification; ends: those of all separatrices.
constexpr std::array kTable = {Expected{1, false, 5, 3, 3, 2, 7, 7, 1, 34, 22, 12, 0},
                               Expected{1, true, 4, 3, 3, 2, 12, 8, 2, 40, 27, 13, 0},
                               Expected{4, false, 17, 7, 13, 12, 12, 8, 3, 92, 76, 15, 1},
                               Expected{6, true, 22, 16, 8, 16, 18, 14, 2, 124, 70, 52, 2}};

std::size_t count(const SkeletonCertificate& c, ZeroClass kind) {
  std::size_t n = 0;
  for (const auto& z : c.zeros) n += z.kind == kind;
  return n;
}

/// Integers from -range to range at the vertices of a small grid.
PlaneField integer_field(Random& random, std::uint32_t n, int range, bool hole) {
  return grid_field(
      n, n, 1,
      [&](double, double) {
        const auto number = [&] {
          return static_cast<double>(
              static_cast<int>(random() % static_cast<unsigned>(2 * range + 1)) - range);
        };
        const double x = number();
        return std::array{x, number()};
      },
      [&](std::uint32_t i, std::uint32_t j) { return hole && i == n / 2 && j == n / 2; });
}

}  // namespace

TEST_CASE("skeleton: fields of the reference table, to the last count") {
  for (const Expected& e : kTable) {
    INFO("seed " << e.seed << ", hole " << e.hole);
    const auto c = reference_skeleton(
        lattice_field(e.seed, 5 + static_cast<std::uint32_t>(e.seed % 9), 40, e.hole));
    const Verdict verdict = verify(encode(c));
    INFO(verdict.reason);
    CHECK(verdict.accepted);
    CHECK(count(c, ZeroClass::saddle) == e.saddles);
    CHECK(count(c, ZeroClass::source) == e.sources);
    CHECK(count(c, ZeroClass::sink) == e.sinks);
    std::size_t foci = 0, inside = 0, outside = 0;
    for (const auto& z : c.zeros) foci += z.focus;
    for (const auto& s : c.switches) ++(s.inside != 0 ? inside : outside);
    CHECK(foci == e.foci);
    CHECK(inside == e.inside);
    CHECK(outside == e.outside);
    CHECK(c.index_sum == e.index);
    CHECK(c.separatrices.size() == e.separatrices);
    // What the producer could not follow is missing; no end is of the wrong kind.
    const std::size_t open = c.ends[4];
    CHECK(c.ends[0] <= e.at_zeros);
    CHECK(c.ends[2] <= e.at_boundary);
    CHECK(c.ends[3] <= e.at_orbits);
    CHECK(c.ends[0] + c.ends[2] + c.ends[3] + open == e.separatrices);
    CHECK(10 * open < e.separatrices);
    std::cout << "seed " << e.seed << (e.hole ? " hole" : " square") << ": " << c.ends[0] << "/"
              << c.ends[2] << "/" << c.ends[3] << ", " << open << " undecided\n";
  }
}

TEST_CASE("skeleton: both arithmetics say the same") {
  const Bytes bytes = encode(reference_skeleton(lattice_field(3, 4, 16, true)));
  VerifyOptions mpfr;
  mpfr.arithmetic = Arithmetic::mpfr;
  const Verdict fast = verify(bytes), slow = verify(bytes, mpfr);
  CHECK(fast.accepted);
  CHECK(slow.accepted);
  CHECK(fast.lines == slow.lines);
}

TEST_CASE("skeleton: integer fields with ties, holes and walls") {
  Random random(kSeed);
  Failures failures;
  std::array<std::size_t, 5> places{};
  std::size_t runs = 0, corners = 0, dead = 0;
  for (std::uint64_t i = 0; i < scaled(150); ++i) {
    const auto n = static_cast<std::uint32_t>(3 + i % 3);
    auto field = integer_field(random, n, 1 + static_cast<int>(i % 4), i % 2 == 1);
    if (i % 5 == 0)  // walls, dead triangles
      for (auto& v : field.vectors)
        if (random() % 3 == 0) v = {0, 0};
    const auto c = reference_points(field);
    const Verdict verdict = verify(encode(c));
    failures.expect(verdict.accepted, verdict.reason.c_str(), i);
    for (const auto& z : c.zeros) ++places[static_cast<std::size_t>(z.place)];
    for (const auto& s : c.switches) {
      runs += s.place == 2;
      corners += s.place == 1;
    }
    dead += !verdict.lines.empty() && verdict.lines[0].find(", 0 of them") == std::string::npos;
  }
  CHECK(failures.report() == "");
  std::cout << "integer fields: zeros in triangles, edges, vertices, lines, regions " << places[0]
            << " " << places[1] << " " << places[2] << " " << places[3] << " " << places[4] << "; "
            << runs << " runs, " << corners << " corners, " << dead << " with dead triangles\n";
  for (const std::size_t n : places) CHECK(n > 0);
  CHECK(runs > 0);
  CHECK(corners > 0);
}

TEST_CASE("skeleton: scaled positions and vectors have the same ends") {
  const auto field = lattice_field(1, 6, 20, true);
  const auto original = reference_skeleton(field);
  for (const auto& [positions, vectors] : {std::array{1e-5, 1.0}, std::array{1e3, 1e-8}}) {
    auto other = field;
    for (auto& p : other.positions) p = {p[0] * positions, p[1] * positions};
    for (auto& v : other.vectors) v = {v[0] * vectors, v[1] * vectors};
    const auto c = reference_skeleton(other);
    const Verdict verdict = verify(encode(c));
    INFO(verdict.reason);
    CHECK(verdict.accepted);
    CHECK(c.ends == original.ends);
    CHECK(c.switches.size() == original.switches.size());
  }
}
