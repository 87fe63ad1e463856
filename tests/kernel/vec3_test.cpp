// SPDX-License-Identifier: GPL-3.0-or-later
// Vectors: their values over exact numbers, and the order in which doubles are rounded, on which
// certificates and files depend to the last bit.
#include "kernel/arithmetic/vec3.hpp"

#include <catch2/catch.hpp>
#include <limits>

#include "kernel/arithmetic/rational.hpp"
#include "tests/support/random.hpp"

namespace {

using namespace crest::kernel;

class Vectors {
 public:
  Vec3 space() { return {number(), number(), number()}; }
  Vec2 plane() { return {number(), number()}; }
  double number() { return std::ldexp(static_cast<double>(random_() >> 11), -53) - 0.5; }

 private:
  crest::tests::Random random_{20};
};

}  // namespace

TEST_CASE("vectors: exact identities over rationals") {
  Vectors vectors;
  for (int i = 0; i < 100; ++i) {
    const auto a = lift<Rational>(vectors.space()), b = lift<Rational>(vectors.space()),
               c = lift<Rational>(vectors.space());
    const auto n = cross(a, b);
    CHECK(dot(n, a) == 0);
    CHECK(dot(n, b) == 0);
    CHECK(dot(n, n) == dot(a, a) * dot(b, b) - dot(a, b) * dot(a, b));  // Lagrange
    CHECK(cross(a, cross(b, c)) == dot(a, c) * b - dot(a, b) * c);
    CHECK(determinant(a, b, c) == dot(a, cross(b, c)));
    CHECK(determinant(b, a, c) == -determinant(a, b, c));
    CHECK((a + b) - b == a);
  }
  CHECK(cross(Vec3{1, 0, 0}, Vec3{0, 1, 0}) == Vec3{0, 0, 1});
  CHECK(cross(Vec2{1, 0}, Vec2{0, 1}) == 1);
  CHECK(dot(Vec2{3, 4}, Vec2{2, 5}) == 26);
  CHECK(2 * (Vec2{1, 2} + Vec2{3, 4}) - Vec2{1, 1} == Vec2{7, 11});
}

TEST_CASE("vectors: sums of doubles are rounded from the first coordinate on") {
  // Of 1 + 2^-53 + 2^-53 only this order loses both small terms.
  const Vec3 a = {1, 0x1p-53, 0x1p-53}, ones = {1, 1, 1};
  CHECK(dot(a, ones) == 1);
  CHECK(dot(Vec3{a[1], a[2], a[0]}, ones) > 1);
  Vectors vectors;
  int other_order = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 p = vectors.space(), q = vectors.space();
    CHECK(dot(p, q) == (p[0] * q[0] + p[1] * q[1]) + p[2] * q[2]);
    CHECK(norm(p) == std::sqrt(dot(p, p)));
    CHECK(p + -1.0 * q == p - q);
    other_order += dot(p, q) != p[0] * q[0] + (p[1] * q[1] + p[2] * q[2]);
  }
  CHECK(other_order > 100);  // so that the order is seen
}

TEST_CASE("vectors: norm and distance") {
  CHECK(norm(Vec2{3, 4}) == 5);
  CHECK(norm(Vec3{2, 3, 6}) == 7);
  CHECK(distance({1, 2, 3}, {3, 5, 9}) == 7);
  CHECK(norm(Vector3<long double>{0x1p-600L, 0, 0}) == 0x1p-600L);
  // Squares vanish or overflow in a norm; a distance stays.
  const Vec3 far = {3e200, 4e200, 0}, near = {3e-200, 4e-200, 0};
  CHECK(norm(far) == std::numeric_limits<double>::infinity());
  CHECK(norm(near) == 0);
  CHECK(distance(far, {}) == Approx(5e200).epsilon(1e-15));
  CHECK(distance(near, {}) == Approx(5e-200).epsilon(1e-15));
}
