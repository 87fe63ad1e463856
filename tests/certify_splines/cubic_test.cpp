// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 12: the normal form, true certificates, what the referee found.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "certify/spline_cubic/encode.hpp"
#include "certify/spline_cubic/evaluate.hpp"
#include "certify/verify.hpp"
#include "tests/certify_splines/reference_cubic.hpp"
#include "tests/support/verdicts.hpp"

using namespace crest::certify;
using namespace crest::tests;

namespace {

struct Place {
  Int3 cube;
  std::size_t tet;
};
/// Two tetrahedra that share a face: their vertices off it, the face, and what C1 demands.
struct Crossing {
  std::string kind;
  Letter u, v;
  std::array<Letter, 3> face;
};

std::vector<Crossing> crossings(const SplineCubicData& data) {
  std::map<std::array<Letter, 3>, Letter> seen;
  std::vector<Crossing> all;
  for (const Int3& cube : domain_cubes(data))
    for (const ReferenceTet& tet : reference_tets())
      for (std::size_t out = 0; out < 4; ++out) {
        std::array<Letter, 3> face;
        Letter off{};
        for (std::size_t i = 0, k = 0; i < 4; ++i) {
          Letter x;
          for (std::size_t d = 0; d < 3; ++d) x[d] = 2 * cube[d] + 1 + tet.vertices[i][d];
          if (i == out)
            off = x;
          else
            face[k++] = x;
        }
        std::ranges::sort(face);
        const auto [at, is_new] = seen.try_emplace(face, off);
        const char* const kinds[] = {"inter-cube", "intra-pyramid", "intra-pyramid",
                                     "inter-pyramid"};
        if (!is_new) all.push_back({kinds[out], at->second, off, face});
      }
  return all;
}

/// a(wu) + a(wv) less what C1 demands of it, by affine dependence of u, v and the face.
Rational defect(const ReferenceCubic& s, const Int3& cube, const Int3& other, const Crossing& c,
                const Letter& w0, const Letter& w1) {
  const auto a = [&](const Letter& x) { return s.coefficient(cube, {w0, w1, x}); };
  const auto odd = [](const Letter& x) { return (x[0] & 1) + (x[1] & 1) + (x[2] & 1); };
  Rational demanded = 0;
  for (const Letter& x : c.face)
    if (c.kind == "inter-pyramid")
      demanded += odd(x) == 3 ? a(x) : Rational(a(x) / 2);
    else if (odd(x) == 2)
      demanded += 2 * a(x);
  return a(c.u) + s.coefficient(other, {w0, w1, c.v}) - demanded;
}

Int3 cube_of(const Letter& centre) {
  return {(centre[0] - 1) / 2, (centre[1] - 1) / 2, (centre[2] - 1) / 2};
}

/// Failures by kind and word (by what its letters are).
std::map<std::string, int> failures(const SplineCubicData& data) {
  const ReferenceCubic s(data);
  std::map<std::string, int> count;
  const auto name = [](const Letter& x) {
    const int odd = (x[0] & 1) + (x[1] & 1) + (x[2] & 1);
    return odd == 3 ? 'C' : odd == 2 ? 'D' : 'A';
  };
  const auto is_centre = [&](const Letter& x) { return name(x) == 'C'; };
  for (const Crossing& c : crossings(data)) {
    const auto centre = std::ranges::find_if(c.face, is_centre);
    const Int3 cube = cube_of(centre != c.face.end() ? *centre : c.u);
    const Int3 other = cube_of(centre != c.face.end() ? *centre : c.v);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = i; j < 3; ++j) {
        const Rational d = defect(s, cube, other, c, c.face[i], c.face[j]);
        std::string word = {name(c.face[i]), name(c.face[j])};
        std::ranges::sort(word);
        const std::string key = c.kind + " " + word;
        count[key] += d != 0;
        if (word != "AC" || c.kind != "inter-pyramid") continue;
        const Letter a = name(c.face[i]) == 'A' ? c.face[i] : c.face[j];
        const Int3 corner = {a[0] - (2 * cube[0] + 1), a[1] - (2 * cube[1] + 1),
                             a[2] - (2 * cube[2] + 1)};
        CHECK(d == -s.residual(cube, corner));
      }
  }
  return count;
}

}  // namespace

TEST_CASE("splines: the normal form satisfies all conditions but those of r") {
  Random random(kSeed);
  for (const bool doubles : {false, true}) {
    const auto c = random_cubic({2, 2, 2}, doubles, random);
    std::map<std::string, std::size_t> kinds;
    for (const Crossing& crossing : crossings(c.data)) ++kinds[crossing.kind];
    CHECK(kinds == std::map<std::string, std::size_t>{
                       {"inter-cube", 48}, {"inter-pyramid", 96}, {"intra-pyramid", 192}});
    for (const auto& [key, count] : failures(c.data)) {
      INFO(key);
      CHECK(count == (doubles && key == "inter-pyramid AC" ? 2 * 96 : 0));
    }
  }
}

TEST_CASE("splines: the checker's polynomial of a tetrahedron is that of the coefficients") {
  Random random(kSeed);
  const auto c = random_cubic({2, 1, 2}, true, random);
  const ReferenceCubic reference(c.data);
  for (const Int3& cube : domain_cubes(c.data)) {
    const spline_cubic::CubePlace place{{static_cast<std::size_t>(cube[0]),
                                         static_cast<std::size_t>(cube[1]),
                                         static_cast<std::size_t>(cube[2])}};
    const auto form =
        spline_cubic::load<Rational>(c.data, place, [](double x) { return Rational(x); });
    for (unsigned corner = 0; corner < 8; ++corner) {
      Int3 signs;
      for (std::size_t d = 0; d < 3; ++d) signs[d] = spline_cubic::bit(corner, d) != 0 ? 1 : -1;
      CHECK(spline_cubic::eight_residuals(form, corner) == 8 * reference.residual(cube, signs));
    }
    for (unsigned number = 0; number < kTetrahedra; ++number) {
      Exact3 d, x;
      for (std::size_t k = 0; k < 3; ++k) {
        d[k] = Rational(static_cast<double>(random() % 64) / 32 - 1);
        x[k] = d[k] + (2 * cube[k] + 1);
      }
      const Tetrahedron tet = tetrahedron(number);
      CHECK(spline_cubic::value(form, tet, barycentrics(tet, d)) ==
            reference.polynomial(cube, number, x));
    }
  }
}

TEST_CASE("splines: the gradient jumps by the bound where it is largest, and no more") {
  Random random(kSeed);
  const auto c = random_cubic({1, 1, 1}, true, random);
  const ReferenceCubic s(c.data);
  // Along each triangle [A, B, C] the difference of two polynomials over the distance from it.
  const auto slope = [&](std::size_t d) {
    return Rational(2) * c.data.cubes[d] /
           (Rational(c.data.box[2 * d + 1]) - Rational(c.data.box[2 * d]));
  };
  Rational most = 0;
  for (std::size_t first = 0; first < 24; ++first)
    for (std::size_t second = 0; second < first; ++second) {
      const auto &t = reference_tets()[first].vertices, &o = reference_tets()[second].vertices;
      if (t[1] != o[1] || t[2] != o[2]) continue;
      for (int i = 0; i <= 8; ++i)
        for (int j = 0; i + j <= 8; ++j) {
          Exact3 at, beside, back;
          Rational square = 0, step = 0;
          for (std::size_t d = 0; d < 3; ++d) {
            at[d] = 1 + Rational(i * t[1][d] + j * t[2][d]) / 8;
            // D - D' is across the triangle's plane in the cube, not in the world; the jump of the
            // gradient is along the plane's normal, n = (slope_b, -slope_c) up to signs.
            const Rational n = Rational(t[3][d] - o[3][d]) * slope(d);
            square += n * n;
            step += Rational(t[3][d] - o[3][d]) * (t[3][d] - o[3][d]);
            beside[d] = at[d] + Rational(t[3][d] - o[3][d]) / 64;
            back[d] = at[d] - Rational(t[3][d] - o[3][d]) / 64;
          }
          const auto difference = [&](const Exact3& x) {
            return Rational(s.polynomial({0, 0, 0}, first, x) - s.polynomial({0, 0, 0}, second, x));
          };
          CHECK(difference(at) == 0);
          // The difference is a multiple of a linear form l times a quadratic: its derivative by
          // symmetric differences is exact but for the cubic part, which a second step removes.
          Exact3 far, far_back;
          for (std::size_t d = 0; d < 3; ++d) {
            far[d] = at[d] + (beside[d] - at[d]) * 2;
            far_back[d] = at[d] + (back[d] - at[d]) * 2;
          }
          const Rational near_slope = (difference(beside) - difference(back)) * 32;
          const Rational far_slope = (difference(far) - difference(far_back)) * 16;
          const Rational along = (4 * near_slope - far_slope) / 3;  // by D - D'
          // grad = g l with l along D - D' equal to `step`: |grad| = along / step |n|.
          most = std::max(most, Rational(along * along / (step * step) * square));
        }
    }
  const Rational bound = Rational(c.jump) * Rational(c.jump);
  CHECK(most <= bound);
  // The steepest plane and the largest residual need not meet, so this seed's case may be less.
  CHECK(static_cast<double>(most / bound) > 0.05);
}

TEST_CASE("splines: cubic splines, marched and not, are accepted as the reference makes them") {
  Random random(kSeed);
  for (std::uint64_t i = 0; i < scaled(4); ++i)
    for (const bool doubles : {false, true}) {
      auto c = random_cubic({2, 1 + static_cast<std::uint32_t>(i % 3), 2}, doubles, random);
      CHECK((c.jump == 0) == !doubles);
      require_accepted(c);
      if (doubles) {
        c.jump = std::nextafter(c.jump, 0);
        CHECK(reason(c).starts_with("the gradient jumps by more than stated at corner "));
        c.jump = 0;
        CHECK(reason(c).starts_with("not C1: r is not 0 at corner "));
        c.jump = least_jump(c.data);
      }
      c.error = std::nextafter(c.error, 0);
      CHECK(reason(c).ends_with("differs from the spline by more than stated"));
    }
}

TEST_CASE("splines: a domain of some cubes, and samples outside it") {
  Random random(kSeed);
  auto c = random_cubic({3, 2, 2}, false, random);
  // All but one corner cube, whose own sites are then 0.
  c.data.domain = {{0, 11}};
  c.data.centres[11] = {};
  const std::size_t last = c.data.vertices.size() - 1;
  c.data.vertices[last] = {};
  c.data.samples.clear();
  CHECK(reason(c) ==
        "an edge of vertex " + std::to_string(last - 12) + " is not in the domain, not 0");
  for (const std::size_t k : {0, 1}) c.data.slopes[last - 1][k] = 0;
  for (const std::size_t k : {2, 3}) c.data.slopes[last - 4][k] = 0;
  for (const std::size_t k : {4, 5}) c.data.slopes[last - 12][k] = 0;
  c.error = 0;
  require_accepted(c);
  c.data.samples = {{1, 1, 5.25, 0}};  // on the plane between cube 11 and its neighbours
  c.error = least_error(c.data);
  require_accepted(c);
  c.data.samples = {{1.5, 1.5, 5.4, 0}};
  CHECK(reason(c) == "sample 0 is not in the domain");
  c.data.samples = {{1.5, 1.5, 6, 0}};
  CHECK(reason(c) == "sample 0 is not in the box");
}

TEST_CASE("splines: r is asked at the stored centres, in their own units") {
  Random random(kSeed);
  const auto c = random_cubic({2, 2, 2}, false, random);
  const double u = std::ldexp(1.0, c.data.exponent);
  int eighths = 0, quarters = 0;
  for (const auto& centre : c.data.centres) {
    eighths += std::fmod(centre[0], u / 4) != 0;
    for (const std::size_t k : {1, 2, 3}) quarters += std::fmod(centre[k], u / 2) != 0;
  }
  CHECK(eighths > 0);
  CHECK(quarters > 0);
  for (const std::size_t k : {0, 1, 2, 3}) {
    auto moved = c;
    moved.data.centres[5][k] += k == 0 ? u / 8 : u / 4;
    CHECK(reason(moved).starts_with("not C1: r is not 0 at corner 0 of cube 5"));
    auto rounded = c;
    rounded.data.centres[5][k] += u / 16;
    CHECK_THROWS_AS(encode(rounded), std::invalid_argument);
  }
}

TEST_CASE("splines: all numbers 0, and units at the ends") {
  Random random(kSeed);
  for (const int exponent : {-1060, -46, 0, 954}) {
    auto c = random_cubic({2, 2, 2}, false, random);
    c.data.exponent = exponent;
    for (auto& row : c.data.vertices) row = {};
    for (auto& row : c.data.slopes) row = {};
    for (auto& row : c.data.centres) row = {};
    c.error = 0;
    for (auto& sample : c.data.samples) sample[3] = 0;
    require_accepted(c);
    // The same integers in another unit.
    auto scaled_up = random_cubic({2, 2, 2}, false, random);
    const int shift = exponent - scaled_up.data.exponent;
    for (auto* rows : {&scaled_up.data.vertices, &scaled_up.data.centres})
      for (auto& row : *rows)
        for (double& x : row) x = std::ldexp(x, shift);
    for (auto& row : scaled_up.data.slopes)
      for (double& x : row) x = std::ldexp(x, shift);
    scaled_up.data.exponent = exponent;
    scaled_up.data.samples.resize(4);
    for (auto& sample : scaled_up.data.samples) sample[3] = 0;
    scaled_up.error = std::ldexp(1.0, exponent + 60);
    require_accepted(scaled_up);
    scaled_up.data.centres[3][0] += std::ldexp(1.0, exponent - 3);
    CHECK(reason(scaled_up).starts_with("not C1"));
  }
  auto beyond = random_cubic({1, 1, 1}, false, random);
  for (auto& row : beyond.data.vertices) row = {};
  for (auto& row : beyond.data.slopes) row = {};
  for (auto& row : beyond.data.centres) row = {};
  beyond.data.exponent = -1061;
  CHECK(reason(beyond) == "malformed: data section: no such unit");
}
