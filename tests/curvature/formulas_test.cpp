// SPDX-License-Identifier: GPL-3.0-or-later
// Equations 3.13 and 3.14 against exact rationals, the determinant form of appendix A and the
// fundamental forms they are derived from.
#include <catch2/catch.hpp>
#include <random>

#include "algorithms/curvature/curvature.hpp"
#include "algorithms/curvature/normal_tensor.hpp"
#include "kernel/arithmetic/rational.hpp"
#include "tests/support/failures.hpp"

using namespace crest::curvature;
using crest::kernel::norm;
using crest::kernel::Rational;
using crest::kernel::TriangleMesh;

namespace {

using Exact = Vector<Rational>;

struct Case {
  NormalTriangle<double> t;
  Vector<double> lambda;
};

/// Random corners, normals near the triangle's own, a random point (lambda sums to 1 exactly:
/// multiples of 1/1024).
Case random_case(crest::tests::Random& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  Case c;
  for (auto& x : c.t.x) x = {unit(random), unit(random), unit(random)};
  const auto m = triangle_normal(c.t);
  for (auto& n : c.t.n)
    for (std::size_t k = 0; k < 3; ++k) n[k] = m[k] * (1 + 0.3 * unit(random)) + 0.2 * unit(random);
  const auto i = static_cast<double>(random() % 1025);
  const auto j = static_cast<double>(random() % (1025 - static_cast<std::uint64_t>(i)));
  c.lambda = {i / 1024, j / 1024, (1024 - i - j) / 1024};
  return c;
}

Exact exact(const Vector<double>& a) {
  return {Rational(a[0]), Rational(a[1]), Rational(a[2])};
}
NormalTriangle<Rational> exact(const NormalTriangle<double>& t) {
  return {{exact(t.x[0]), exact(t.x[1]), exact(t.x[2])},
          {exact(t.n[0]), exact(t.n[1]), exact(t.n[2])}};
}

/// E, F, G and sqrt(n~ n~) times e, f1, f2, g by equations 3.1, 3.2, 3.11 and 3.12, nothing
/// simplified.
struct Forms {
  Rational E, F, G, e, f1, f2, g;
};
Forms forms_of(const NormalTriangle<Rational>& t, const Exact& lambda) {
  const Exact n = interpolated_normal(t, lambda);
  const Rational nn = dot(n, n);
  const auto tangential = [&](const Exact& a) {
    const Rational s = dot(a, n) / nn;
    return Exact{a[0] - s * n[0], a[1] - s * n[1], a[2] - s * n[2]};
  };
  const Exact xu = tangential(t.x[1] - t.x[0]);
  const Exact xv = tangential(t.x[2] - t.x[0]);
  // sqrt(n~ n~) times the derivative of n = n~ / |n~| is the tangential part of n~'s.
  const Exact nu = tangential(t.n[1] - t.n[0]);
  const Exact nv = tangential(t.n[2] - t.n[0]);
  return {dot(xu, xu),  dot(xu, xv),  dot(xv, xv), -dot(nu, xu),
          -dot(nu, xv), -dot(nv, xu), -dot(nv, xv)};
}

bool regular(const Case& c) {
  const auto n = interpolated_normal(c.t, c.lambda);
  const auto m = triangle_normal(c.t);
  return std::abs(dot(n, m)) > 0.01 * std::sqrt(dot(n, n) * dot(m, m));
}

}  // namespace

TEST_CASE("K and H of 3.13 and 3.14 equal the forms' and the determinant form's, exactly") {
  crest::tests::Random random(crest::tests::kSeed);
  for (std::uint64_t i = 0; i < crest::tests::scaled(300); ++i) {
    const Case c = random_case(random);
    if (!regular(c)) continue;
    const crest::tests::OnFailure shown([&] { return "case " + crest::tests::in_words(c); });
    const auto t = exact(c.t);
    const Exact lambda = exact(c.lambda);
    const Exact n = interpolated_normal(t, lambda);
    const Rational nn = dot(n, n);
    const Rational K = gaussian_curvature(t, lambda), H = scaled_mean_curvature(t, lambda);
    const auto w = scaled_weingarten(t, lambda);
    CHECK(K * nn == w.w11 * w.w22 - w.w12 * w.w21);
    CHECK(2 * H == w.w11 + w.w22);

    // Equation 3.3 with f1 != f2 (section 3.2.3).
    const Forms f = forms_of(t, lambda);
    const Rational det = f.E * f.G - f.F * f.F;
    CHECK(K * nn * det == f.e * f.g - f.f1 * f.f2);
    CHECK(2 * H * det == f.e * f.G - f.f1 * f.F + f.g * f.E - f.f2 * f.F);
    const Rational a = asymmetry(t, lambda);
    CHECK(a * a * det * nn == (f.f1 - f.f2) * (f.f1 - f.f2));
    CHECK((f.f1 - f.f2) * a * dot(n, triangle_normal(t)) >= 0);
  }
}

TEST_CASE("the determinant form is the matrix of -dn on the sides of the triangle") {
  crest::tests::Random random(crest::tests::kSeed + 1);
  for (std::uint64_t i = 0; i < crest::tests::scaled(100); ++i) {
    const Case c = random_case(random);
    if (!regular(c)) continue;
    const crest::tests::OnFailure shown([&] { return "case " + crest::tests::in_words(c); });
    const auto t = exact(c.t);
    const Exact lambda = exact(c.lambda);
    const Exact n = interpolated_normal(t, lambda);
    const auto w = scaled_weingarten(t, lambda);
    const Exact xu = t.x[1] - t.x[0], xv = t.x[2] - t.x[0];
    const Exact nu = t.n[1] - t.n[0], nv = t.n[2] - t.n[0];
    // Equal up to a multiple of n~: crossed with it they agree.
    const auto map = [&](const Rational& p, const Rational& q) {
      return Exact{p * xu[0] + q * xv[0], p * xu[1] + q * xv[1], p * xu[2] + q * xv[2]};
    };
    const Exact zero{Rational(0), Rational(0), Rational(0)};
    CHECK(cross(map(w.w11, w.w21), n) == cross(zero - nu, n));
    CHECK(cross(map(w.w12, w.w22), n) == cross(zero - nv, n));
  }
}

TEST_CASE("curvature in doubles agrees with exact rationals, any point of a triangle") {
  crest::tests::Random random(crest::tests::kSeed + 2);
  double worst = 0;
  for (std::uint64_t i = 0; i < crest::tests::scaled(300); ++i) {
    const Case c = random_case(random);
    if (!regular(c)) continue;
    const crest::tests::OnFailure shown([&] { return "case " + crest::tests::in_words(c); });
    const TriangleMesh mesh({c.t.x[0], c.t.x[1], c.t.x[2]}, {{0, 1, 2}});
    const auto got = curvature_at(mesh, {c.t.n[0], c.t.n[1], c.t.n[2]}, 0, c.lambda);
    const auto t = exact(c.t);
    const Exact lambda = exact(c.lambda), n = interpolated_normal(t, lambda);
    const Rational nn = dot(n, n), K = gaussian_curvature(t, lambda),
                   H = scaled_mean_curvature(t, lambda), A = asymmetry(t, lambda);
    const auto w = scaled_weingarten(t, lambda);
    const double size = std::sqrt(static_cast<double>(nn));
    const double h = static_cast<double>(H) / size, k = static_cast<double>(K);
    const double a = std::abs(static_cast<double>(A));
    // Entries of W carry the error: compare on their scale.
    const double scale = 1 + h * h + std::abs(k) + a * a;
    CHECK(std::abs(got.K - k) <= 1e-9 * scale);
    CHECK(std::abs(got.H - h) <= 1e-9 * scale);
    CHECK(std::abs(got.asymmetry - a) <= 1e-9 * scale);
    worst = std::max({worst, std::abs(got.K - k) / scale, std::abs(got.H - h) / scale});
    // Real eigenvalues exactly where H^2 >= K; they are then the roots.
    if (H * H > K * nn && std::abs(h * h - k) > 1e-6 * scale) {
      CHECK(std::abs(got.k1 * got.k2 - k) <= 1e-8 * scale);
      CHECK(std::abs(got.k1 + got.k2 - 2 * h) <= 1e-8 * scale);
      CHECK(got.k1 > got.k2);
    }
    if (H * H < K * nn && std::abs(h * h - k) > 1e-6 * scale) CHECK(got.k1 == got.k2);
    (void)w;
  }
  CHECK(worst > 0);  // doubles round: a zero would mean that nothing was compared
}

TEST_CASE("principal directions are eigenvectors of the tensor and tangent") {
  crest::tests::Random random(crest::tests::kSeed + 3);
  int real = 0;
  for (std::uint64_t i = 0; i < crest::tests::scaled(300); ++i) {
    const Case c = random_case(random);
    if (!regular(c)) continue;
    const crest::tests::OnFailure shown([&] { return "case " + crest::tests::in_words(c); });
    const TriangleMesh mesh({c.t.x[0], c.t.x[1], c.t.x[2]}, {{0, 1, 2}});
    const auto got = curvature_at(mesh, {c.t.n[0], c.t.n[1], c.t.n[2]}, 0, c.lambda);
    const auto n = interpolated_normal(c.t, c.lambda);
    const double length = norm(n);
    CHECK(std::abs(dot(got.d1, got.d1) - 1) < 1e-12);
    CHECK(std::abs(dot(got.d2, got.d2) - 1) < 1e-12);
    CHECK(std::abs(dot(got.d1, n)) < 1e-12 * length);
    if (!(got.k1 - got.k2 > 1e-3 * (std::abs(got.k1) + std::abs(got.k2)))) continue;
    ++real;
    // dn along d = a x_u + b x_v (tangential parts) is (a n_u + b n_v) / |n~|, tangential part.
    const auto xu = c.t.x[1] - c.t.x[0], xv = c.t.x[2] - c.t.x[0];
    const auto nu = c.t.n[1] - c.t.n[0], nv = c.t.n[2] - c.t.n[0];
    for (const auto& [k, d] : {std::pair{got.k1, got.d1}, std::pair{got.k2, got.d2}}) {
      const double det = determinant(xu, xv, n);
      const double a = determinant(d, xv, n) / det, b = determinant(xu, d, n) / det;
      Vector<double> rest;
      for (std::size_t j = 0; j < 3; ++j) rest[j] = (a * nu[j] + b * nv[j]) / length + k * d[j];
      const auto off = cross(rest, n);  // must vanish: rest is along n~
      const double scale = 1 + std::abs(got.k1) + std::abs(got.k2) + got.asymmetry;
      CHECK(norm(off) < 1e-8 * scale * length * (1 + std::abs(a) + std::abs(b)));
    }
  }
  CHECK(real > 20);
}

TEST_CASE(
    "the tensor depends on the length of the normals (theorem 3.1, ii) but not on a common "
    "factor") {
  const TriangleMesh mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  const std::vector<Vec3> normals = {{-0.25, -0.25, 1}, {0.25, 0, 1}, {0, 0.5, 1}};
  auto longer = normals, all = normals;
  for (double& x : longer[0]) x *= 2;
  for (auto& n : all)
    for (double& x : n) x *= 4;
  const std::array<double, 3> lambda = {0.25, 0.25, 0.5};
  const auto base = curvature_at(mesh, normals, 0, lambda);
  CHECK(std::abs(curvature_at(mesh, longer, 0, lambda).K - base.K) > 0.01);
  CHECK(curvature_at(mesh, all, 0, lambda).K == base.K);
  CHECK(curvature_at(mesh, all, 0, lambda).H == base.H);
}
