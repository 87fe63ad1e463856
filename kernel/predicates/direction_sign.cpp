// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/predicates/direction_sign.hpp"

#include <algorithm>
#include <cmath>

namespace crest::kernel {
namespace {

using Exact3 = Vector3<Rational>;

using Integer =
    boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;

/// Integers in proportion to v, the largest of about so many bits: keeps the next steps short.
Exact3 rounded(const Exact3& v, unsigned bits) {
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

/// w with K^ and b^ of the theorem.
class Guess {
 public:
  Guess(const Symmetric3<Rational>& t, const Exact3& w)
      : w_(w), length_(dot(w, w)), k_(cone_matrix(t, w)) {
    const Exact3 tw = product(t, w);
    const Rational q = dot(w, tw);
    b_ = {length_ * tw[0] - q * w[0], length_ * tw[1] - q * w[1], length_ * tw[2] - q * w[2]};
    trace_ = k_[0] + k_[1] + k_[2];
    minor_ = cone_minor(k_, w);
  }

  /// The theorem's test.
  bool proves(const Exact3& v) const {
    if (!(trace_ > 0 && minor_ > 0)) return false;
    const Rational along = dot(w_, v);
    return along * along * minor_ * minor_ >
           dot(b_, b_) * dot(v, v) * length_ * length_ * trace_ * trace_;
  }

  /// The form's sign at w, if it is proven to be that at n.
  MaybeSign form_sign(const Symmetric3<Rational>& m) const {
    if (!(trace_ > 0 && minor_ > 0)) return std::nullopt;
    const Rational form = dot(w_, product(m, w_));
    const Rational square =
        m[0] * m[0] + m[1] * m[1] + m[2] * m[2] + 2 * (m[3] * m[3] + m[4] * m[4] + m[5] * m[5]);
    if (form * form * minor_ * minor_ >
        4 * dot(b_, b_) * length_ * length_ * length_ * trace_ * trace_ * square)
      return sign_of(form);
    return std::nullopt;
  }

  /// About how many bits of w are n's: of |b|^2 W tr^2 / minor^2, half.
  unsigned bits() const {
    const Rational square = dot(b_, b_) * length_ * trace_ * trace_ / (minor_ * minor_);
    if (square == 0) return 4096;
    const auto high = static_cast<long>(msb(numerator(square)));
    const auto low = static_cast<long>(msb(denominator(square)));
    return low > high ? static_cast<unsigned>((low - high) / 2) : 0;
  }

  /// One step towards n by the inverse iteration (T - (q + shift) I)^-1, whose adjugate needs no
  /// division; q + shift is at least lambda1, so that the side of w is kept.
  Exact3 improved() const {
    // lambda1 - q is at most |b|^2 / (q - mu) <= |b^|^2 tr K^ / (W minor), and at most |b| as mu
    // <= q; times W as K^ is.
    const Rational near = dot(b_, b_) * trace_ / minor_;
    Rational longest = 0;
    for (const Rational& x : w_) longest = std::max<Rational>(longest, abs(x));
    const Rational far = (abs(b_[0]) + abs(b_[1]) + abs(b_[2])) / longest;
    const Rational shift = std::min(near, far);
    const Symmetric3<Rational> m = {k_[0] + shift, k_[1] + shift, k_[2] + shift,
                                    k_[3],         k_[4],         k_[5]};
    return product(adjugate(m), w_);
  }

 private:
  Exact3 w_;
  Rational length_;
  Symmetric3<Rational> k_;
  Exact3 b_;
  Rational trace_, minor_;
};

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

/// Does f, of form sign, vanish at lambda1?
bool is_form_zero(const Symmetric3<Rational>& t, const Symmetric3<Rational>& m, const Exact3& w) {
  const Symmetric3<Rational> adj = adjugate(t);
  const Rational trace = t[0] + t[1] + t[2], minors = adj[0] + adj[1] + adj[2];
  const Rational det = t[0] * adj[0] + t[3] * adj[3] + t[5] * adj[5];
  const auto inner = [](const Symmetric3<Rational>& a, const Symmetric3<Rational>& b) {
    return Rational(a[0] * b[0] + a[1] * b[1] + a[2] * b[2] +
                    2 * (a[3] * b[3] + a[4] * b[4] + a[5] * b[5]));
  };
  // adj(x I - T) = x^2 I + x (T - trace I) + adj T.
  const Rational a = m[0] + m[1] + m[2], b = inner(t, m) - trace * a, c = inner(adj, m);
  const Rational q = dot(w, product(t, w)) / dot(w, w);
  if (a == 0) {
    if (b == 0) return c == 0;
    const Rational x = -c / b;
    return x >= q && ((x - trace) * x + minors) * x == det;
  }
  // p = f (x / a + ..) + slope x + rest
  const Rational third = trace + b / a;  // p's third root, if f divides it
  const Rational slope = minors + third * b / a - c / a, rest = third * c / a - det;
  if (slope == 0) return rest == 0 && third < q;
  const Rational x = -rest / slope;
  return x >= q && (a * x + b) * x + c == 0;
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
  for (;;) {
    const Guess guess(t, x);
    if (guess.proves(v)) return sign_of(dot(x, v));
    // A step triples the bits.
    x = rounded(guess.improved(), 64 + 4 * guess.bits());
  }
}

Sign exact_form_sign(const Symmetric3<Rational>& t, const Symmetric3<Rational>& m,
                     const Exact3& w) {
  if (is_form_zero(t, m, w)) return Sign::zero;
  Exact3 x = w;
  for (;;) {
    const Guess guess(t, x);
    if (const MaybeSign s = guess.form_sign(m)) return *s;
    x = rounded(guess.improved(), 64 + 4 * guess.bits());
  }
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
