// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 9: files made to break the checker: numbers, counts, truncations, costs.
#include <catch2/catch.hpp>
#include <chrono>
#include <cmath>
#include <limits>

#include "certify/container/container.hpp"
#include "certify/skeleton/encode.hpp"
#include "certify/skeleton/signs.hpp"
#include "certify/verify.hpp"
#include "tests/certify_skeleton/reference_skeleton.hpp"
#include "tests/support/random.hpp"
#include "tests/support/verdicts.hpp"

using namespace crest::certify;
using namespace crest::tests;

namespace {

const SkeletonCertificate& original() {
  static const auto c = reference_skeleton(lattice_field(1, 4, 12, true));
  return c;
}

void put(Bytes& bytes, std::size_t at, std::uint64_t bits, std::size_t width) {
  for (std::size_t i = 0; i < width; ++i, bits >>= 8U)
    bytes[at + i] = static_cast<std::uint8_t>(bits);
}

double seconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

TEST_CASE("hostile: no number that is infinite, not a number or -0") {
  const Bytes bytes = encode(original());
  const std::size_t from = kHeaderSize + 8 + original().triangles.size() * 12,
                    to = from + original().positions.size() * 32;
  const double inf = std::numeric_limits<double>::infinity();
  std::size_t tried = 0;
  for (const double x : {inf, -inf, std::nan(""), -std::nan(""), -0.0})
    for (std::size_t at = from; at < to; at += 8 * 7) {
      Bytes mutant = bytes;
      put(mutant, at, std::bit_cast<std::uint64_t>(x), 8);
      rebind(mutant);
      const Verdict verdict = verify(mutant);
      CHECK_FALSE(verdict.accepted);
      CHECK(verdict.reason.find("infinite, NaN or -0") != std::string::npos);
      ++tried;
    }
  CHECK(tried > 400);
  for (const double x : {inf, std::nan("")}) {
    auto c = original();
    for (auto* list : {&c.separatrices[0].legs[0].first, &c.separatrices[0].legs[0].second})
      (*list)[0] = x;
    CHECK_FALSE(reason(c).empty());
    c = original();
    c.traps[0].form[1] = x;
    CHECK_FALSE(reason(c).empty());
  }
}

TEST_CASE("hostile: extreme magnitudes are decided or refused, never believed") {
  Random random(kSeed);
  std::size_t accepted = 0;
  for (const double x : {1e308, -1e308, 5e-324, 1e-160, 0x1p-537, 0.0}) {
    for (int i = 0; i < 12; ++i) {
      auto c = original();
      auto& list = i % 2 == 0 ? c.positions : c.vectors;
      list[static_cast<std::size_t>(random() % list.size())][random() % 2] = x;
      if (!reason(c).empty()) continue;
      ++accepted;
      const auto anew = reference_points({c.positions, c.triangles, c.vectors});
      CHECK(anew.zeros.size() == c.zeros.size());
      CHECK(anew.switches.size() == c.switches.size());
    }
    auto c = original();
    c.separatrices[0].legs[0].first = {x};
    CHECK_FALSE(reason(c).empty());
    c = original();
    c.traps[0].form[0] = x;
    CHECK_FALSE(reason(c).empty());
  }
  // All vectors tiny or huge: everything is decided in rationals.
  for (const double scale : {0x1p-1000, 0x1p900}) {
    auto c = original();
    for (auto& v : c.vectors) v = {v[0] * scale, v[1] * scale};
    const auto time = seconds([&] { static_cast<void>(reason(c)); });
    CHECK(time < 20);
  }
  CHECK(accepted < 72);
}

TEST_CASE("hostile: a sum that overflows has no certain sign") {
  using namespace crest::certify::skeleton;
  // Ends of the wanted sign; in the middle binomials times a form overflow, the exact sums are
  // negative, the computed ones are plus infinity.
  const std::vector<Point<double>> control = {{0, 0}, {0.35, 0}, {0.36, 0.64}};
  LinearForms<double> forms;
  forms.first = {0.9e308, 0.9e308, 0.9e308};
  forms.second = {-1.2e308, 0.5e308, 0.5e308};
  forms.magnitude_first = 0.9e308;
  forms.magnitude_second = 1.2e308;
  Products<double> products;
  CHECK(have_sign(control, forms, Binomials<double>(2), products, 1) == Answer::open);
  LinearForms<crest::kernel::Rational> exact;
  for (std::size_t k = 0; k < 3; ++k) {
    exact.first[k] = forms.first[k];
    exact.second[k] = forms.second[k];
  }
  CHECK_FALSE(ExactSigns().have(control, exact, 1));
}

TEST_CASE("hostile: differences below all doubles keep a bound") {
  using namespace crest::certify::skeleton;
  // da first + db second is as small as its own rounding; da, db are 0 as doubles.
  Random random(kSeed);
  Big::bits = 133;
  std::size_t seem_positive = 0;
  for (int i = 0; i < 200; ++i) {
    const auto number = [&] { return 1 + std::ldexp(static_cast<double>(random() >> 11U), -53); };
    const double f = 0x1p900 * number(), g = 0x1p900 * number();
    const Big p = (Big(number()) + Big(0x1p-53 * number()) + Big(0x1p-100 * number())) *
                  Big::power_of_half(1200);
    const Big q = -((p * Big(f)) / Big(g));
    const std::vector<Point<Big>> control = {{Big(0.0), Big(0.0)}, {p, q}};
    LinearForms<Big> forms;
    forms.first = {Big(f), Big(f), Big(f)};
    forms.second = {Big(g), Big(g), Big(g)};
    forms.magnitude_first = f;
    forms.magnitude_second = g;
    Products<Big> products;
    CHECK(have_sign(control, forms, Binomials<Big>(1), products, 1) == Answer::open);
    seem_positive += to_double(products.sums()[0]) > 0x1p-1000;
  }
  CHECK(seem_positive > 0);  // which a bound of nothing would have called certain
}

TEST_CASE("hostile: sides longer than doubles go have no finite bound") {
  using namespace crest::certify::skeleton;
  SkeletonCertificate c;
  c.positions = {{-1.5e308, -1.5e308}, {1.5e308, -1.5e308}, {-1.5e308, 1.5e308}};
  c.vectors = {{1, 0}, {1, 0}, {1, 0}};
  c.triangles = {{0, 1, 2}};
  const Field field(c);
  Big::bits = 133;
  // The side's length is infinite as a double, times 0 not a number: a maximum would pass over it.
  const Frame<Big> frame = make_frame<Big>(field, 0, false);
  CHECK(frame.determinant.magnitude_first == HUGE_VAL);
  CHECK(frame.product.magnitude_second == HUGE_VAL);
  const std::vector<Point<Big>> control = {{Big(0.25), Big(0.25)}, {Big(0.5), Big(0.25)}};
  Products<Big> products;
  CHECK(have_sign(control, frame.product, Binomials<Big>(1), products, 1) == Answer::open);
}

TEST_CASE("hostile: truncated anywhere, counts of any size") {
  const Bytes bytes = encode(original());
  Random random(kSeed);
  const std::size_t data = original().positions.size() * 32 + original().triangles.size() * 12 + 8;
  for (std::uint64_t i = 0; i < scaled(60); ++i) {
    Bytes mutant = bytes;
    mutant.resize(random() % mutant.size());
    CHECK_FALSE(verify(mutant).accepted);
  }
  for (std::size_t at = kHeaderSize + data; at + 36 < bytes.size(); at += 3)
    for (const std::uint64_t word : {0xffffffffULL, 0x80000000ULL, 0x7fffffffULL}) {
      Bytes mutant = bytes;
      put(mutant, at, word, 4);
      if (mutant == bytes) continue;
      rebind(mutant);
      static_cast<void>(verify(mutant));  // no crash, no huge allocation
      if (at % 5 != 0) break;
    }
  for (const std::uint64_t word : {0ULL, 1ULL, 0xffffffffULL})
    for (const std::size_t at : {kHeaderSize, kHeaderSize + 4}) {
      Bytes mutant = bytes;
      put(mutant, at, word, 4);
      rebind(mutant);
      CHECK_FALSE(verify(mutant).accepted);
    }
}

TEST_CASE("hostile: what a surface must be") {
  const std::vector<std::array<double, 2>> square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const std::vector<std::array<double, 2>> flow(4, {1, 2});
  const auto refused = [&](const std::vector<std::array<std::uint32_t, 3>>& triangles) {
    SkeletonCertificate c;
    c.positions = square;
    c.vectors = flow;
    c.triangles = triangles;
    return reason(c);
  };
  CHECK(refused({{0, 2, 1}}).find("not counter-clockwise") != std::string::npos);
  CHECK(refused({{0, 1, 2}, {1, 2, 0}}).find("same corners") != std::string::npos);
  CHECK(refused({{0, 1, 2}, {0, 1, 3}}).find("same direction") != std::string::npos);
  CHECK_FALSE(refused({{0, 1, 2}, {0, 1, 7}}).empty());
  CHECK_FALSE(refused({{0, 1, 1}}).empty());

  // Around a vertex twice: positive triangles, a surface, but not flat there.
  PlaneField twice{{{0, 0}}, {}, {{3, 1}}};
  const std::uint32_t n = 8;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 4 * M_PI * i / n;
    twice.positions.push_back({std::cos(angle), std::sin(angle)});
    twice.vectors.push_back({3, 1});
    twice.triangles.push_back({0, i + 1, (i + 1) % n + 1});
  }
  CHECK(reason(reference_points(twice)).find("go round 2 times") != std::string::npos);
  // Flat and once around every vertex, but two ends lie over one another: a spiral staircase.
  PlaneField spiral;
  for (std::uint32_t i = 0; i <= 12; ++i) {
    const double angle = 2 * M_PI * i / 10;
    for (const double radius : {1.0, 2.0}) {
      spiral.positions.push_back({radius * std::cos(angle), radius * std::sin(angle)});
      spiral.vectors.push_back({3, 1});
    }
    if (i == 12) break;
    const std::uint32_t a = 2 * i;
    spiral.triangles.push_back({a, a + 1, a + 3});
    spiral.triangles.push_back({a, a + 3, a + 2});
  }
  CHECK(reason(reference_points(spiral)).find("boundary sides") == 0);
  // Two components, one inside the other; a triangle whose side passes through a vertex.
  PlaneField two{{{0, 0}, {9, 0}, {0, 9}, {1, 1}, {2, 1}, {1, 2}},
                 {{0, 1, 2}, {3, 4, 5}},
                 std::vector<std::array<double, 2>>(6, {3, 1})};
  CHECK(reason(reference_points(two)).find("lie over one another") != std::string::npos);
  for (const std::size_t i : {3U, 4U, 5U}) two.positions[i][0] += 20;
  CHECK(reason(reference_points(two)).empty());
  two.positions[3] = {4.5, 4.5};
  CHECK(reason(reference_points(two)).find("meet") != std::string::npos);
  // The same at a common vertex: from there on one lies over the other.
  const PlaneField pinch{{{0, 0}, {9, 0}, {0, 9}, {4, 1}, {1, 4}},
                         {{0, 1, 2}, {0, 3, 4}},
                         std::vector<std::array<double, 2>>(5, {3, 1})};
  CHECK(reason(reference_points(pinch)).find("lie over one another") != std::string::npos);
  // All vectors zero: no domain, nothing to claim, and nothing is.
  SkeletonCertificate still;
  still.positions = square;
  still.vectors.assign(4, {0, 0});
  still.triangles = {{0, 1, 2}, {0, 2, 3}};
  CHECK(reason(still).empty());
}

TEST_CASE("hostile: a pinch vertex is two vertices") {
  const PlaneField f{{{0, 0}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}},
                     {{0, 1, 2}, {0, 3, 4}},
                     {{0, 0}, {1, 0}, {1, 1}, {-1, 1}, {-1, 0}}};
  const auto c = reference_points(f);
  CHECK(c.zeros.size() == 2);
  CHECK(c.loops.size() == 2);
  CHECK(reason(c).empty());
}

TEST_CASE("hostile: short files do not cost much") {
  // Many copies of one long straight line, from a zero where any number may be listed.
  auto f = grid_field(60, 60, 1, [](double x, double) { return std::array{x, 0.0}; });
  auto c = reference_points(f);
  SkeletonLeg leg;
  leg.kind = LegKind::straight;
  leg.first = {1, 0};
  leg.elements = 60;
  leg.corner = 0;
  SkeletonSeparatrix line;
  line.legs = {leg};
  line.reason = OpenReason::budget;
  c.separatrices.assign(50000, line);
  c.ends = {0, 0, 0, 0, 50000};
  CHECK(seconds([&] { CHECK(reason(c).find("too long straight lines") != std::string::npos); }) <
        20);
  // Pieces as short as can be.
  c = original();
  for (auto& s : c.separatrices)
    if (!s.legs.empty()) s.legs[0].barrier.shrink = 11;
  CHECK(seconds([&] { CHECK_FALSE(reason(c).empty()); }) < 30);
  // Degrees, angles and bits that nobody needs.
  for (const SkeletonBarrier& b :
       {SkeletonBarrier{0, 30, 53, 0}, SkeletonBarrier{51, 30, 53, 0},
        SkeletonBarrier{12, 54, 53, 0}, SkeletonBarrier{12, 30, 54, 0},
        SkeletonBarrier{129, 30, 133, 0}, SkeletonBarrier{12, 0, 53, 0},
        SkeletonBarrier{12, 30, 53, 17}, SkeletonBarrier{12, 30, 65535, 0}}) {
    c = original();
    c.separatrices[0].legs[0].barrier = b;
    CHECK(reason(c).find("separatrix 0: ") == 0);
  }
}
