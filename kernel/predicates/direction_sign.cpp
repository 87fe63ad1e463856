// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/predicates/direction_sign.hpp"

#include <algorithm>
#include <cmath>

namespace crest::kernel {
namespace {

using Exact3 = Vector3<Rational>;

/// Integers in proportion to v, the largest of about so many bits: keeps the next steps short.
Exact3 rounded(const Exact3& v, unsigned bits) {
  using Integer = boost::multiprecision::number<boost::multiprecision::gmp_int,
                                                boost::multiprecision::et_off>;
  Rational largest = 0;
  for (const Rational& x : v) largest = std::max<Rational>(largest, abs(x));
  const Rational scale = Rational(Integer(1) << bits) / largest;
  Exact3 r;
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational x = v[k] * scale;
    r[k] = Rational(Integer(numerator(x) / denominator(x)));
  }
  return r;
}

/// The theorem's test.
bool proves(const Symmetric3<Rational>& t, const Exact3& v, const Exact3& w) {
  const Rational length = dot(w, w), q = dot(w, product(t, w));
  const Exact3 tw = product(t, w);
  const Exact3 b = {length * tw[0] - q * w[0], length * tw[1] - q * w[1],
                    length * tw[2] - q * w[2]};
  const auto k = cone_matrix(t, w);
  const Rational trace = k[0] + k[1] + k[2], minor = cone_minor(k, w), along = dot(w, v);
  if (!(trace > 0 && minor > 0)) return false;
  return along * along * minor * minor > dot(b, b) * dot(v, v) * length * length * trace * trace;
}

/// One step towards n by the inverse iteration (T - (q + shift) I)^-1, whose adjugate needs no
/// division; q + shift lies above lambda1, so that the side of w is kept.
Exact3 improved(const Symmetric3<Rational>& t, const Exact3& w) {
  const Rational length = dot(w, w), q = dot(w, product(t, w));
  const Exact3 tw = product(t, w);
  const Exact3 b = {length * tw[0] - q * w[0], length * tw[1] - q * w[1],
                    length * tw[2] - q * w[2]};
  const auto k = cone_matrix(t, w);
  const Rational trace = k[0] + k[1] + k[2], minor = cone_minor(k, w);
  // lambda1 - q <= |b|^2 / (q - mu) <= |b^|^2 tr K^ / (W minor), times W as K^ is.
  const Rational shift = dot(b, b) * trace / minor / length;
  const Symmetric3<Rational> m = {k[0] + shift, k[1] + shift, k[2] + shift, k[3], k[4], k[5]};
  const Symmetric3<Rational> adjugate = {m[1] * m[2] - m[4] * m[4], m[0] * m[2] - m[5] * m[5],
                                         m[0] * m[1] - m[3] * m[3], m[4] * m[5] - m[3] * m[2],
                                         m[3] * m[5] - m[0] * m[4], m[3] * m[4] - m[1] * m[5]};
  return product(adjugate, w);
}

bool is_zero(const Symmetric3<Rational>& t, const Exact3& v, const Exact3& w) {
  if (v[0] == 0 && v[1] == 0 && v[2] == 0) return true;
  const Exact3 tv = product(t, v), u = cross(v, tv);
  const auto is_dominant = [&](const Exact3& e) {
    const Rational along = dot(e, w);
    return 2 * along * along > dot(e, e) * dot(w, w);
  };
  if (u[0] == 0 && u[1] == 0 && u[2] == 0) return !is_dominant(v);
  if (dot(u, product(t, tv)) != 0) return false;
  return is_dominant(u);
}

}  // namespace

MaybeSign triage_direction_sign(const Symmetric3<double>& t, double t_error, const Vec3& v,
                                double v_error, const Vec3& w) {
  double size = 0;
  for (const double x : t) size = std::max(size, std::fabs(x));
  const double gap = cone_margin(t, size, t_error, w);
  if (!(gap > 0)) return std::nullopt;
  const Vec3 tw = product(t, w);
  const double q = dot(w, tw), along = dot(w, v);
  // tan theta <= |b| / gap; the errors of b: 6 t_error and less than 30 roundings of 4 size.
  const double b = norm(tw - q * w) + 8 * t_error + 0x1p-44 * size;
  const double bound =
      (b / gap) * (norm(v) + 2 * v_error) * (1 + 0x1p-40) + 2 * v_error + 0x1p-48 * norm(v);
  if (along > bound) return Sign::positive;
  if (along < -bound) return Sign::negative;
  return std::nullopt;
}

Sign exact_direction_sign(const Symmetric3<Rational>& t, const Exact3& v, const Exact3& w) {
  if (is_zero(t, v, w)) return Sign::zero;
  Exact3 x = w;
  for (unsigned bits = 64; !proves(t, v, x); bits *= 2) x = rounded(improved(t, x), bits);
  return sign_of(dot(x, v));
}

Sign symbolic_direction_sign(const Symmetric3<Rational>& t, const Exact3& w) {
  for (std::size_t k = 0; k < 3; ++k) {
    Exact3 axis = {0, 0, 0};
    axis[k] = 1;
    if (const Sign s = exact_direction_sign(t, axis, w); s != Sign::zero) return s;
  }
  return Sign::zero;
}

Decision direction_sign(const Symmetric3<double>& t, const Vec3& v, const Vec3& w) {
  if (const MaybeSign s = triage_direction_sign(t, 0, v, 0, w)) return {*s, Stage::triage};
  const Symmetric3<Rational> exact_t = {Rational(t[0]), Rational(t[1]), Rational(t[2]),
                                        Rational(t[3]), Rational(t[4]), Rational(t[5])};
  const Exact3 exact_w = lift<Rational>(w);
  if (const Sign s = exact_direction_sign(exact_t, lift<Rational>(v), exact_w); s != Sign::zero)
    return {s, Stage::exact};
  return {symbolic_direction_sign(exact_t, exact_w), Stage::symbolic};
}

}  // namespace crest::kernel
