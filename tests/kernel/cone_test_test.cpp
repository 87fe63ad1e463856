// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/predicates/cone_test.hpp"

#include "kernel/predicates/direction_sign.hpp"
#include "tests/kernel/ladder_checks.hpp"

using namespace crest::kernel;
using namespace crest::tests;

namespace {

using Tensor = Symmetric3<double>;

Tensor draw_tensor(Draw& d, Family family) {
  Tensor t;
  for (double& x : t) x = draw(d, family);
  return t;
}
template <class T>
Symmetric3<T> lifted(const Tensor& t) {
  return {T(t[0]), T(t[1]), T(t[2]), T(t[3]), T(t[4]), T(t[5])};
}

/// u v' + v u' + c I and the like: exact eigenvalues meet.
Tensor degenerate(Draw& d) {
  Vec3 u;
  for (double& x : u) x = d.integer(-2, 2);
  const double c = d.integer(-1, 1), s = d.coin() ? 1 : -1;
  return {s * u[0] * u[0] + c, s * u[1] * u[1] + c, s * u[2] * u[2] + c,
          s * u[0] * u[1],     s * u[1] * u[2],     s * u[0] * u[2]};
}

}  // namespace

TEST_CASE("cone test: stages agree on all families, depths and bounds hold") {
  require_depth(ConeTrace{});
  require_depth(ConeMinor{});
  for (const Family family : kFamilies) {
    Draw d(1, family);
    require_stages_agree<ConeTrace>(scaled(2000), [&](auto) {
      return ConeTrace{draw_tensor(d, family), draw_vector(d, family)};
    });
    require_stages_agree<ConeMinor>(scaled(2000), [&](auto) {
      return ConeMinor{draw_tensor(d, family), draw_vector(d, family)};
    });
    require_bound(scaled(500), [&] {
      return ConeMinor{draw_tensor(d, family), draw_vector(d, family)};
    });
  }
}

TEST_CASE("cone test: every stage decides") {
  const auto stage = [](const Tensor& t, const Vec3& w) { return cone_test(t, w); };
  CHECK(stage({2, 1, 1, 0, 0, 0}, {1, 0, 0}).sign == Sign::positive);
  CHECK(stage({2, 1, 1, 0, 0, 0}, {1, 0, 0}).stage == Stage::triage);
  CHECK(stage({2, 1, 1, 0, 0, 0}, {0, 0, 1}).sign == Sign::negative);
  // The eigenvalues differ by one step of a double.
  CHECK(stage({1 + 0x1p-52, 1, 0, 0, 0, 0}, {1, 0, 0}).sign == Sign::positive);
  CHECK(stage({1 + 0x1p-52, 1, 0, 0, 0, 0}, {1, 0, 0}).stage == Stage::interval);
  CHECK(stage({1, 1, 0, 0, 0, 0}, {1, 0, 0}).sign == Sign::zero);
  CHECK(stage({0, 0, 0, 0, 0, 0}, {1, 2, 3}).sign == Sign::zero);
  CHECK(stage({1, 1, 1, 0, 0, 0}, {1, 2, 3}).sign == Sign::zero);
  // w at 45 degrees from n: q equals mu.
  CHECK(stage({1, 0, 0, 0, 0, 0}, {1, 1, 0}).sign == Sign::zero);
  CHECK(stage({1, 0, 0, 0, 0, 0}, {1, 1 - 0x1p-30, 0}).sign == Sign::positive);
  CHECK(stage({1, 0, 0, 0, 0, 0}, {1 - 0x1p-50, 1, 0}).sign == Sign::negative);
  CHECK(stage({1, 0, 0, 0, 0, 0}, {1 + 0x1p-52, 1 + 0x1p-52, 0}).sign == Sign::zero);
  CHECK(stage({1, 0, 0, 0, 0, 0}, {1 + 0x1p-52, 1 + 0x1p-52, 0}).stage == Stage::exact);
}

TEST_CASE("cone test: laws 1, 2, 4 and 5 on random and degenerate tensors") {
  Failures failures;
  for (const Family family : {Family::generic, Family::small_integers, Family::equal_mantissas}) {
    Draw d(2, family);
    for (std::uint64_t i = 0; i < scaled(3000); ++i) {
      const Tensor t = d.coin() ? draw_tensor(d, family) : degenerate(d),
                   s = draw_tensor(d, family);
      const Vec3 w = draw_vector(d, family), o = draw_vector(d, family);
      const Sign sign = exact_cone_test(t, w);
      const Vec3 back = {-2 * w[0], -2 * w[1], -2 * w[2]};
      failures.expect(exact_cone_test(t, back) == sign, "law 1 holds for", t, w);
      Tensor twice = t;
      for (double& x : twice) x *= 2;
      failures.expect(exact_cone_test(twice, w) == sign, "law 2 holds for", t, w);
      if (sign != Sign::positive) continue;
      if (exact_cone_test(s, w) == Sign::positive) {
        Symmetric3<Rational> sum = lifted<Rational>(t);
        for (std::size_t k = 0; k < 6; ++k) sum[k] += Rational(s[k]);
        const auto k = cone_matrix(sum, lift<Rational>(w));
        failures.expect(cone_minor(k, lift<Rational>(w)) > 0 && k[0] + k[1] + k[2] > 0,
                        "law 4 holds for", t, s, w);
      }
      if (exact_cone_test(t, o) == Sign::positive)
        failures.expect(dot(lift<Rational>(w), lift<Rational>(o)) != 0, "law 5 holds for", t, w, o);
    }
  }
  CHECK(failures.report() == "");
}

TEST_CASE("cone test: the margin of the triage is never more than q - mu") {
  Failures failures;
  Draw d(3, Family::generic);
  for (std::uint64_t i = 0; i < scaled(3000); ++i) {
    const Tensor t = draw_tensor(d, Family::generic);
    Vec3 w = draw_vector(d, Family::generic);
    w = (1 / norm(w)) * w;
    if (cone_margin(t, 1, 0, w) > 0)
      failures.expect(exact_cone_test(t, w) == Sign::positive, "a positive margin is right for", t,
                      w);
  }
  CHECK(failures.report() == "");
}

TEST_CASE("direction sign: exact zeros of every kind") {
  const Tensor t = {3, 2, 1, 0, 0, 0};
  const Vec3 n = {1, 0, 0};
  // v = 0; v another eigenvector; v in the plane of the others; v in a plane with n; generic.
  CHECK(direction_sign(t, {0, 0, 0}, n).stage == Stage::symbolic);
  CHECK(direction_sign(t, {0, 0, 0}, n).sign == Sign::positive);
  CHECK(direction_sign(t, {0, 0, 0}, {-1, 0, 0}).sign == Sign::negative);
  CHECK(direction_sign(t, {0, 5, 0}, n).stage == Stage::symbolic);
  CHECK(direction_sign(t, {0, 1, 1}, n).stage == Stage::symbolic);
  CHECK(direction_sign(t, {-1, 0, 0}, n).sign == Sign::negative);
  CHECK(direction_sign(t, {-1, 5, 0}, n).sign == Sign::negative);
  CHECK(direction_sign(t, {1, 5, -7}, n).sign == Sign::positive);
  CHECK(direction_sign(t, {0x1p-400, 5, -7}, n).sign == Sign::positive);
  CHECK(direction_sign(t, {0x1p-400, 5, -7}, n).stage == Stage::exact);
  // n = e_y: the first coordinate of the symbolic term is zero.
  CHECK(direction_sign({1, 3, 2, 0, 0, 0}, {0, 0, 0}, {0, -1, 0}).sign == Sign::negative);
}

TEST_CASE("direction sign: the laws, and the stages agree") {
  Failures failures;
  for (const Family family : {Family::generic, Family::small_integers}) {
    Draw d(4, family);
    for (std::uint64_t i = 0; i < scaled(400); ++i) {
      const Tensor t = d.coin() ? draw_tensor(d, family) : degenerate(d);
      const Vec3 v = draw_vector(d, family), w0 = draw_vector(d, family);
      if (exact_cone_test(t, w0) != Sign::positive) continue;
      const auto e = lifted<Rational>(t);
      const auto ev = lift<Rational>(v), ew = lift<Rational>(w0);
      const Sign sign = exact_direction_sign(e, ev, ew);
      const Vec3 back = {-w0[0], -w0[1], -w0[2]};
      failures.expect(exact_direction_sign(e, ev, lift<Rational>(back)) == -sign, "law 1 holds for",
                      t, v, w0);
      failures.expect(symbolic_direction_sign(e, ew) != Sign::zero, "law 4 holds for", t, w0);
      const Vec3 w = (1 / norm(w0)) * w0;
      if (const MaybeSign fast = triage_direction_sign(t, 0, v, 0, w))
        failures.expect(*fast == sign, "triage is as the exact stage on", t, v, w0);
      // Any other vector of the cone on the same side.
      const Vec3 o = draw_vector(d, family);
      if (exact_cone_test(t, o) == Sign::positive) {
        const Sign side = sign_of(dot(lift<Rational>(o), ew));
        failures.expect(exact_direction_sign(e, ev, lift<Rational>(o)) == side * sign,
                        "law 3 holds for", t, v, w0, o);
      }
    }
  }
  CHECK(failures.report() == "");
}

TEST_CASE("form sign: zeros, where the direction sign knows them, and signs") {
  Failures failures;
  std::size_t zeros = 0;
  for (const Family family : {Family::generic, Family::small_integers}) {
    Draw d(5, family);
    for (std::uint64_t i = 0; i < scaled(2000); ++i) {
      Tensor t = d.coin() ? draw_tensor(d, family) : degenerate(d);
      if (i % 2 == 0) t[3] = t[4] = t[5] = 0;  // n is along an axis, so that many v are across it
      const Vec3 v = draw_vector(d, family), o = draw_vector(d, family),
                 w0 = draw_vector(d, family);
      if (exact_cone_test(t, w0) != Sign::positive) continue;
      const auto e = lifted<Rational>(t);
      const auto a = lift<Rational>(v), b = lift<Rational>(o), w = lift<Rational>(w0);
      // M = a b^T + b a^T: twice (n . a)(n . b).
      Symmetric3<Rational> m = {2 * a[0] * b[0],           2 * a[1] * b[1],
                                2 * a[2] * b[2],           a[0] * b[1] + a[1] * b[0],
                                a[1] * b[2] + a[2] * b[1], a[0] * b[2] + a[2] * b[0]};
      const Sign sign = exact_direction_sign(e, a, w) * exact_direction_sign(e, b, w);
      zeros += sign == Sign::zero ? 1 : 0;
      failures.expect(exact_form_sign(e, m, w) == sign, "a product's sign is right for", t, v, o,
                      w0);
      for (Rational& x : m) x = -x;
      failures.expect(exact_form_sign(e, m, w) == -sign, "law 5 holds for", t, v, o, w0);
    }
  }
  CHECK(failures.report() == "");
  CHECK(zeros > 20);
}

TEST_CASE("form sign: T less its eigenvalues, forms that divide the characteristic polynomial") {
  // A rational rotation.
  const Rational f = Rational(1) / 3;
  const std::array<Vector3<Rational>, 3> axes = {
      {{f, 2 * f, 2 * f}, {2 * f, f, -2 * f}, {2 * f, -2 * f, f}}};
  const auto made = [&](const Rational& x, const Rational& y, const Rational& z) {
    Symmetric3<Rational> r = {0, 0, 0, 0, 0, 0};
    const std::array<Rational, 3> values = {x, y, z};
    constexpr std::size_t kPairs[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {0, 2}};
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < 6; ++i)
        r[i] += values[k] * axes[k][kPairs[i][0]] * axes[k][kPairs[i][1]];
    return r;
  };
  const Symmetric3<Rational> t = made(5, 2, -1);
  for (const Vector3<Rational>& w : {axes[0], Vector3<Rational>{1, 3, 2}}) {
    const auto sign = [&](int x, int y, int z) { return exact_form_sign(t, made(x, y, z), w); };
    for (int y = -3; y <= 3; ++y)
      for (int z = -3; z <= 3; ++z) {
        CAPTURE(y, z);
        CHECK(sign(0, y, z) == Sign::zero);  // y = -z: of degree 1; y = z = 0: none
        CHECK(sign(1, y, z) == Sign::positive);
        CHECK(sign(-1, y, z) == Sign::negative);
      }
  }
  // lambda1 = sqrt 2: M = (T^2 - 2) + k e_z e_z^T.
  const Symmetric3<Rational> s = {1, -1, 0, 1, 0, 0};
  for (const int k : {-1, 0, 1})
    CHECK(exact_form_sign(s, {0, 0, Rational(k), 0, 0, 0}, {2, 1, 0}) == Sign::zero);
  // n = (1 + sqrt 2, 1, 0): n^T M n = 0 for M = xx - 2 xy - yy, which divides p.
  CHECK(exact_form_sign(s, {1, -1, 0, -1, 0, 0}, {2, 1, 0}) == Sign::zero);
  CHECK(exact_form_sign(s, {1, -1, 1, -1, 0, 0}, {2, 1, 0}) == Sign::zero);
  CHECK(exact_form_sign(s, {1 + Rational(1) / 1000000000, -1, 1, -1, 0, 0}, {2, 1, 0}) ==
        Sign::positive);
}
